extends TestCase
## A client's walker and the server's, over a bad network.

const WalkerCourse: GDScript = preload("res://tests/bench/walker/walker_course.gd")
const WalkerLine: GDScript = preload("res://tests/bench/walker/walker_line.gd")
const TICK_S: float = 1.0 / 60.0

var _course: WalkerCourse = null


func before_each() -> void:
	_course = WalkerCourse.new(9, self)
	await physics_frames(2)


func after_each() -> void:
	_course.view.free()


func test_a_delayed_line_with_loss_pulls_nobody() -> void:
	var line: WalkerLine = WalkerLine.new(_course, 80.0, 20.0, 0.02, 4)
	for input: WalkerInput in WalkerCourse.inputs(6, 1500):
		line.advance(input)
	equal(line.late_frames, 0)
	is_true(line.prediction.corrections < 15, "%d corrections" % line.prediction.corrections)
	is_true(line.pulls.percentile(0.99) < 0.02)
	is_true(line.sent_bytes / line.seconds() < 8000.0)


func test_a_correction_makes_the_ticks_since_again_and_fades() -> void:
	var truth: WalkerMover = _course.mover()
	truth.place(Vector3(20.0, 0.0, 0.0), 0.0)
	var prediction: WalkerPrediction = WalkerPrediction.new()
	prediction.mover = _course.mover()
	is_true(prediction.correct(100, 1, truth.get_state(), TICK_S))
	equal(prediction.tick, 100)
	var input: WalkerInput = WalkerInput.new()
	input.wish = Vector2(0.0, 1.5)
	var told: PackedByteArray = PackedByteArray()
	for tick: int in range(101, 131):
		prediction.advance(tick, input, TICK_S)
		input.apply(truth, TICK_S)
		if tick == 110:
			# Something has moved it, which only the server knows.
			truth.push(Vector3(0.3, 0.0, 0.0))
			told = truth.get_state()
	var before: Vector3 = prediction.shown()
	is_true(prediction.correct(110, 2, told, TICK_S))
	almost_equal(prediction.shown(), before, 1e-4, "the picture does not jump")
	equal(prediction.mover.get_state(), truth.get_state())
	equal(prediction.correction, 2)
	for tick: int in range(131, 171):
		prediction.advance(tick, input, TICK_S)
	is_true(prediction.offset.length() < 0.01)


func test_what_is_no_state_changes_nothing() -> void:
	var prediction: WalkerPrediction = WalkerPrediction.new()
	is_false(prediction.correct(5, 1, PackedByteArray([1, 2, 3]), TICK_S))
	equal([prediction.tick, prediction.corrections], [-1, 0])


func test_inputs_are_rounded_as_the_command_is() -> void:
	var schema: EntitySchema = WalkerCourse.walk_schema()
	var chance: RandomNumberGenerator = RandomNumberGenerator.new()
	chance.seed = 2
	for _time: int in 200:
		var input: WalkerInput = WalkerInput.new()
		input.wish = Vector2(chance.randf_range(-9.0, 9.0), chance.randf_range(-9.0, 9.0))
		input.heading = chance.randf_range(-4.0, 4.0)
		input.look = chance.randf_range(-2.0, 2.0)
		input.stance = (chance.randi() % 3) as WalkerMover.Stance
		input.jumps = chance.randf() < 0.5
		input.check = chance.randi() % 65536
		input.correction = chance.randi() % WalkerInput.CORRECTIONS
		var sent: PackedByteArray = schema.encode(input.to_values())
		var read: WalkerInput = WalkerInput.of_values(schema.decode(ByteReader.new(sent)))
		equal(read.to_values(), input.rounded(schema).to_values())
		equal([read.stance, read.jumps, read.check], [input.stance, input.jumps, input.check])
		equal(read.correction, input.correction)

extends TestCase
## The view in a headset moves with the wearer's body in the world, and never shakes.

const STEP_S: float = 1.0 / 90.0

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 3


func test_a_body_that_trembles_does_not_move_the_view() -> void:
	var room: RoomFrame = RoomFrame.new()
	var first: Transform3D = room.advance(_place(2.0, 1.0), STEP_S)
	for _frame: int in 900:
		var shaken: Transform3D = _place(2.0, 1.0)
		shaken.origin += 0.005 * Vector3(_random.randf(), _random.randf(), _random.randf())
		equal(room.advance(shaken, STEP_S), first)


func test_a_step_up_is_followed_without_a_jump() -> void:
	var room: RoomFrame = RoomFrame.new()
	var before: float = room.advance(_place(0.0, 0.0), STEP_S).origin.y
	for _frame: int in 180:
		var now: float = room.advance(_place(0.0, 0.2), STEP_S).origin.y
		is_true(now - before < 0.01, "%.3f m in a frame" % (now - before))
		before = now
	almost_equal(before, 0.2, 0.012)


func test_a_vehicle_carries_the_view_rigidly() -> void:
	var room: RoomFrame = RoomFrame.new()
	var inside: Transform3D = Transform3D(Basis(Vector3.UP, 0.3), Vector3(0.4, 1.1, -0.2))
	for frame: int in 400:
		var carrier: Transform3D = Transform3D(
			Basis.from_euler(Vector3(0.1 * sin(frame * 0.2), frame * 0.02, 0.0)),
			Vector3(frame * 0.3, sin(frame * 0.5), 0.0)
		)
		var shown: Transform3D = room.advance(carrier * inside, STEP_S, 7, carrier)
		almost_equal(shown.origin, carrier * inside.origin, 1e-4)


func test_another_place_is_a_cut_and_nonsense_is_passed_over() -> void:
	var room: RoomFrame = RoomFrame.new()
	room.advance(_place(0.0, 0.0), STEP_S)
	almost_equal(room.advance(_place(30.0, 2.0), STEP_S).origin.x, 30.0, 1e-6)
	var broken: Transform3D = _place(NAN, 0.0)
	almost_equal(room.advance(broken, STEP_S).origin.x, 30.0, 1e-6)
	almost_equal(room.advance(_place(1.0, 0.0), STEP_S, 4).origin.x, 1.0, 1e-6)


static func _place(p_x: float, p_y: float) -> Transform3D:
	return Transform3D(Basis(Vector3.UP, 0.7), Vector3(p_x, p_y, 0.0))

extends TestCase
## Which ticks a server sends: each of a late frame, of a world that is too slow only the last.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")
const STEP_S: float = 1.0 / 60.0

var _server: Server = null


func before_each() -> void:
	var options: Options = Options.parse(
		ProgramOptions.rows(),
		["--port=%d" % LinkPair.free_port(), "--world=yard"],
		ProgramRoles.SERVER
	)
	equal(options.error, "")
	_server = preload("res://scenes/server/server.tscn").instantiate()
	_server.configure(options, ProgramParts.SERVER)
	add_child(_server)
	# The test gives it its ticks.
	_server.set_physics_process(false)
	_server.set_process(false)


func after_each() -> void:
	_server.free()


func test_a_late_frame_sends_each_of_its_ticks() -> void:
	equal(_sent_of_three_ticks(), 3)


func test_a_world_that_is_too_slow_sends_a_frames_last_tick() -> void:
	_server.context().stats.watch.speed = 0.5
	equal(_sent_of_three_ticks(), 1)


func _sent_of_three_ticks() -> int:
	var before: int = _server.context().stats.sent_ticks
	for _number: int in 3:
		_server._physics_process(STEP_S)
	_server._process(3.0 * STEP_S)
	_server._process(0.0)
	return _server.context().stats.sent_ticks - before

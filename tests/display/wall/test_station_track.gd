extends TestCase
## Where another client of a station has it in the world, of what the first one says.

const RATE: float = 60.0

var _track: StationTrack = null


func before_each() -> void:
	_track = StationTrack.new()


func _say(p_tick: float, p_mount: Transform3D, p_eye: Vector3 = Vector3.ZERO) -> void:
	var message: StationMessage = StationMessage.new()
	message.tick = p_tick
	message.rate = RATE
	message.mount = p_mount
	message.eye = p_eye
	_track.take(message)


func _at(p_x: float) -> Transform3D:
	return Transform3D(Basis.IDENTITY, Vector3(p_x, 0.0, 0.0))


func test_between_and_after_messages_it_moves_on_with_the_tick() -> void:
	is_null(_track.at(5.0))
	_say(10.0, _at(0.0))
	almost_equal(_track.at(12.0).mount.origin.x, 0.0, 1e-6, "nothing tells how it moves")
	_say(11.0, _at(0.3), Vector3(0.0, 0.1, 0.0))
	_say(12.0, _at(0.6), Vector3(0.0, 0.2, 0.0))
	almost_equal(_track.at(9.0).mount.origin.x, 0.0, 1e-6)
	almost_equal(_track.at(11.5).mount.origin.x, 0.45, 1e-5)
	almost_equal(_track.at(14.0).mount.origin.x, 1.2, 1e-5)
	almost_equal(_track.at(14.0).eye.y, 0.4, 1e-5)
	almost_equal(
		_track.at(30.0).mount.origin.x, _track.at(100.0).mount.origin.x, 1e-5, "no further"
	)
	is_true(_track.at(100.0).mount.origin.x < 3.0)


func test_it_goes_on_round_a_curve() -> void:
	for tick: int in 3:
		_say(tick, Transform3D(Basis(Vector3.UP, 0.05 * tick), Vector3.ZERO) * _at(10.0))
	var wanted: Transform3D = Transform3D(Basis(Vector3.UP, 0.25), Vector3.ZERO) * _at(10.0)
	almost_equal(_track.at(5.0).mount.origin, wanted.origin, 0.005)
	almost_equal(_track.at(5.0).mount.basis.x, wanted.basis.x, 1e-4)


func test_another_view_is_a_cut_and_another_session_a_beginning() -> void:
	_say(10.0, _at(0.0))
	_say(11.0, _at(0.3))
	_say(12.0, _at(80.0))
	almost_equal(_track.at(13.0).mount.origin.x, 80.0, 1e-5)
	_say(13.0, _at(80.3))
	almost_equal(_track.at(14.0).mount.origin.x, 80.6, 1e-4)
	_say(2.0, _at(1.0))
	almost_equal(_track.at(3.0).mount.origin.x, 1.0, 1e-5)
	_track.clear()
	is_null(_track.at(3.0))

extends TestCase
## What leaves for a platform while a seat moves. Nothing is sent to any other machine than this.

const _SIZE: int = 100

var _listener: PacketPeerUDP = null
var _seat: Node3D = null
var _output: PlatformOutput = null


func goes_by_clock() -> bool:
	return true


func before_each() -> void:
	_listener = PacketPeerUDP.new()
	is_true(_listener.bind(0, "127.0.0.1") == OK, "a port")
	_seat = Node3D.new()
	add_child(_seat)
	_output = PlatformOutput.new()
	_output.seat = _seat
	_output.washout = WashoutParameters.new()
	_output.washout.enter_time = 0.1
	add_child(_output)


func after_each() -> void:
	_output.stop()
	_listener.close()


func test_a_seat_on_a_slope_tilts_the_platform() -> void:
	_seat.rotation.x = 0.2
	equal(_start(), "")
	is_true(await _cue_is(func(cue: Vector3) -> bool: return cue.x > 0.01), "nose up")
	var sender: PlatformSender = _output.get_sender()
	almost_equal(sender.get_specific_force().y, 9.81 * cos(0.2), 0.02, "m/s²")
	almost_equal(sender.get_specific_force().z, -9.81 * sin(0.2), 0.02, "m/s²")
	equal(sender.get_error(), "")


func test_a_pause_and_a_seat_that_is_gone_lead_to_neutral() -> void:
	_output.washout.leave_time = 0.1
	_seat.rotation.x = 0.2
	equal(_start(), "")
	is_true(await _gain_is(1.0), "in motion")
	get_tree().paused = true
	var waits: Callable = func(packet: PackedByteArray) -> bool:
		return packet.decode_float(88) == 0.0 and packet.decode_u16(6) & 1 != 0
	is_true(await _packet_is(waits), "in a pause, and says so")
	get_tree().paused = false
	is_true(await _gain_is(1.0), "in motion again")
	_seat.free()
	is_true(await _gain_is(0.0), "without a seat")
	var is_stale: Callable = func(packet: PackedByteArray) -> bool:
		return packet.decode_u16(6) & 4 != 0
	is_true(await _packet_is(is_stale), "without news, and says so")


func test_a_simulated_body_is_followed_in_ticks() -> void:
	var body: RigidBody3D = RigidBody3D.new()
	body.gravity_scale = 0.0
	add_child(body)
	_seat.reparent(body)
	_output.source = PlatformOutput.Source.PHYSICS
	body.constant_force = Vector3(0.0, 0.0, -2.0)
	equal(_start(), "")
	is_true(await _gain_is(1.0), "in motion")
	await physics_frames(40)
	# It is pushed ahead with 2 m/s²; the engine runs ticks in bunches, the seat must not feel that.
	almost_equal(_output.get_sender().get_specific_force().z, -2.0, 0.3, "m/s²")


func test_what_cannot_be_is_refused_by_name() -> void:
	_output.platform = MotionPlatform.preset("small_hexapod")
	_output.platform.rate.z = -1.0
	contains(_start(), "rate")
	contains(_output.start(PlatformAddress.parse("127.0.0.1")), "HOST:PORT")
	is_false(_output.get_sender().is_open())


func test_another_seat_is_a_teleport() -> void:
	equal(_start(), "")
	is_true(await _gain_is(1.0), "in motion")
	var other: Node3D = Node3D.new()
	add_child(other)
	other.position.x = 0.5
	_output.seat = other
	var has_teleported: Callable = func(packet: PackedByteArray) -> bool:
		return packet.decode_u16(6) & 2 != 0
	is_true(await _packet_is(has_teleported), "says so")


func _start() -> String:
	var text: String = "127.0.0.1:%d" % _listener.get_local_port()
	return _output.start(PlatformAddress.parse(text))


func _gain_is(p_gain: float) -> bool:
	return await _packet_is(
		func(packet: PackedByteArray) -> bool: return packet.decode_float(88) == p_gain
	)


func _cue_is(p_holds: Callable) -> bool:
	return await _packet_is(
		func(packet: PackedByteArray) -> bool:
			var pitch: float = packet.decode_float(76)
			return p_holds.call(Vector3(pitch, packet.decode_float(80), packet.decode_float(84)))
	)


## Waits for a datagram that is like that.
func _packet_is(p_holds: Callable) -> bool:
	return await Waiting.until(
		get_tree(),
		func() -> bool:
			var packet: PackedByteArray = _last_packet()
			return packet.size() == _SIZE and p_holds.call(packet)
	)


func _last_packet() -> PackedByteArray:
	var packet: PackedByteArray = []
	while _listener.get_available_packet_count() > 0:
		packet = _listener.get_packet()
	return packet

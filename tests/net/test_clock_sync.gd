extends TestCase
## The server's clock as a client sees it, over ways with delay, jitter, loss and drifting clocks.

const RATE: int = 60

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 12


func test_an_even_way_is_exact() -> void:
	var sync: ClockSync = _simulate(10.0, 5000, 0, 0.0)
	almost_equal(sync.offset_usec, 3e9, 1.0)
	equal(sync.round_trip_usec, 10000)
	almost_equal(sync.jitter_usec, 0.0, 1.0)


func test_jitter_is_measured_and_hardly_shifts_the_clock() -> void:
	var sync: ClockSync = _simulate(30.0, 25000, 10000, 0.0)
	almost_equal(sync.offset_usec, 3e9, 5000.0)
	is_true(sync.jitter_usec > 3000.0 and sync.jitter_usec < 15000.0, str(sync.jitter_usec))


func test_drift_is_found() -> void:
	for drift: float in [-80.0, 0.0, 50.0]:
		var sync: ClockSync = _simulate(120.0, 2000, 500, drift)
		almost_equal(sync.drift_ppm, drift, 10.0, "drift, ppm")
		var local: int = 120000000
		almost_equal(float(sync.server_usec(local)), _server_time(local, drift), 500.0)
		# Ten seconds without an answer.
		local += 10000000
		almost_equal(float(sync.server_usec(local)), _server_time(local, drift), 1000.0)


func test_ticks() -> void:
	var sync: ClockSync = _simulate(10.0, 5000, 1000, 0.0)
	var local: int = sync.local_usec_of_tick(1000.25)
	almost_equal(sync.tick_at(local), 1000.25, 0.001)
	# Tick 0 began at 3000 s of the server's clock, which is 0 of ours.
	almost_equal(sync.tick_at(10000000), 600.0, 0.1)
	almost_equal(float(local), 1000.25 * 1e6 / RATE, 1500.0)


func test_there_and_back() -> void:
	var sync: ClockSync = _simulate(60.0, 5000, 1000, 40.0)
	for local: int in [50000000, 60000000, 61234567]:
		almost_equal(float(sync.local_usec(sync.server_usec(local))), float(local), 2.0)


func test_a_server_that_was_started_again_has_another_clock() -> void:
	var sync: ClockSync = _simulate(10.0, 5000, 0, 0.0)
	var packet: ClockMessage = _answer(20000000, 7000000)
	sync.arrived(packet, 20010000)
	equal(sync.count, 1)
	almost_equal(float(sync.server_usec(20010000)), 7005000.0, 5.0)


func test_answers_that_cannot_be() -> void:
	var sync: ClockSync = ClockSync.new()
	sync.arrived(_answer(5000, 1), 4000)
	sync.arrived(_answer(0, 1), 60000000)
	is_false(sync.is_known(), "from the future, or a minute old")


func test_packets() -> void:
	var question: PackedByteArray = ClockMessage.question(123)
	var bytes: PackedByteArray = ClockMessage.answer(question, 1000000, 60, 990000, 60)
	var packet: ClockMessage = ClockMessage.decode(bytes)
	equal([packet.asked_usec, packet.server_usec], [123, 1000000])
	equal([packet.tick, packet.tick_usec, packet.tick_rate], [60, 990000, 60])
	equal(ClockMessage.answer(bytes, 1, 1, 1, 1), PackedByteArray(), "no question")
	is_null(ClockMessage.decode(question))


## Questions as a client asks them, for some seconds, with a delay each way, μs.
func _simulate(
	p_seconds: float, p_delay_usec: int, p_jitter_usec: int, p_drift_ppm: float
) -> ClockSync:
	var sync: ClockSync = ClockSync.new()
	var now: int = 0
	var number: int = 0
	while now < int(p_seconds * 1e6):
		number += 1
		if _random.randf() > 0.05:
			var out: int = p_delay_usec + _random.randi_range(0, 2 * p_jitter_usec)
			var back: int = p_delay_usec + _random.randi_range(0, 2 * p_jitter_usec)
			var packet: ClockMessage = _answer(now, int(_server_time(now + out, p_drift_ppm)))
			sync.arrived(packet, now + out + back)
		now += 250000 if number < 20 else 1000000
	return sync


func _server_time(p_local_usec: int, p_drift_ppm: float) -> float:
	return 3e9 + p_local_usec * (1.0 + p_drift_ppm * 1e-6)


func _answer(p_asked_usec: int, p_server_usec: int) -> ClockMessage:
	var packet: ClockMessage = ClockMessage.new()
	packet.asked_usec = p_asked_usec
	packet.server_usec = p_server_usec
	var tick: int = floori((p_server_usec - 3e9) * RATE / 1e6)
	packet.tick = maxi(tick, 0)
	packet.tick_usec = int(3e9 + packet.tick * 1e6 / RATE)
	packet.tick_rate = RATE
	return packet

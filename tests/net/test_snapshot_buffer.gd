extends TestCase
## What a client shows between snapshots, whatever the network does to them.

const RATE: int = 60
const NETWORK_S: float = 0.02

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _buffer: SnapshotBuffer = SnapshotBuffer.new()


func before_each() -> void:
	_random.seed = 5


func test_interpolates_place_and_turn() -> void:
	_buffer.push(_snapshot(100, {7: _at(1.0, 0.0)}), 10.0)
	_buffer.push(_snapshot(104, {7: _at(3.0, PI / 2.0)}), 10.1)
	for step: int in 9:
		var part: float = step / 8.0
		var shown: Transform3D = _buffer.transform_at(7, 100.0 + 4.0 * part)
		almost_equal(shown, _at(1.0 + 2.0 * part, PI / 2.0 * part), 1e-5)
	almost_equal(_buffer.newest_transform(7), _at(3.0, PI / 2.0), 1e-6)


func test_does_not_guess_beyond_what_is_known() -> void:
	_buffer.push(_snapshot(100, {7: _at(1.0, 0.0)}), 10.0)
	_buffer.push(_snapshot(101, {7: _at(2.0, 0.0)}), 10.02)
	almost_equal(_buffer.transform_at(7, 50.0), _at(1.0, 0.0))
	almost_equal(_buffer.transform_at(7, 150.0), _at(2.0, 0.0))
	is_true(_buffer.shown_tick(20.0) <= 101.0)


func test_order_and_copies_do_not_matter() -> void:
	var order: Array = range(100, 110) + range(100, 110)
	for _round: int in 50:
		_buffer = SnapshotBuffer.new()
		for i: int in order.size():
			var other: int = _random.randi_range(0, i)
			var kept: int = order[i]
			order[i] = order[other]
			order[other] = kept
		for tick: int in order:
			_buffer.push(_snapshot(tick, {7: _at(tick * 1.0, 0.0)}), 10.0)
		equal(_buffer.newest_tick, 109)
		for shown: float in [100.0, 100.5, 103.25, 108.9, 109.0]:
			almost_equal(_buffer.transform_at(7, shown).origin.x, shown, 1e-4)


func test_late_ones_do_not_push_out_newer_ones() -> void:
	for tick: int in range(100, 140):
		_buffer.push(_snapshot(tick, {7: _at(tick * 1.0, 0.0)}), tick / 60.0)
	for tick: int in range(60, 80):
		_buffer.push(_snapshot(tick, {7: _at(-1000.0, 0.0)}), 140.0 / 60.0)
	equal(_buffer.newest_tick, 139)
	for shown: float in [130.5, 138.5, 139.0]:
		almost_equal(_buffer.transform_at(7, shown).origin.x, shown, 1e-4)


func test_parts_of_a_snapshot_add_up() -> void:
	_buffer.push(_snapshot(100, {1: _at(1.0, 0.0)}), 10.0)
	is_false(_buffer.has_body(2))
	_buffer.push(_snapshot(100, {2: _at(2.0, 0.0)}), 10.0)
	almost_equal(_buffer.transform_at(1, 100.0).origin.x, 1.0)
	almost_equal(_buffer.transform_at(2, 100.0).origin.x, 2.0)


func test_shows_smoothly_under_jitter_and_loss() -> void:
	var figures: Dictionary = _play(20.0, 0.0)
	# DELAY_S behind the quickest way, a little more while the estimate creeps.
	almost_equal(figures["lag_s"], NETWORK_S + SnapshotBuffer.DELAY_S, 0.01)
	is_true(
		figures["between"] > 0.95, "%f of the frames between two snapshots" % figures["between"]
	)
	is_true(figures["backward"] < 1e-6, "went back by %f ticks" % figures["backward"])


func test_is_smooth_again_after_a_hiccup_of_the_server() -> void:
	var figures: Dictionary = _play(40.0, 1.0)
	is_true(
		figures["between"] > 0.95, "%f of the frames between two snapshots" % figures["between"]
	)


func test_restarted_server() -> void:
	for tick: int in range(6000, 6060):
		_buffer.push(_snapshot(tick, {7: _at(5.0, 0.0)}), tick / 60.0)
	for tick: int in range(3, 63):
		_buffer.push(_snapshot(tick, {7: _at(8.0, 0.0)}), 110.0 + tick / 60.0)
	equal(_buffer.newest_tick, 62)
	var shown: float = _buffer.shown_tick(110.0 + 62.0 / 60.0)
	is_true(shown > 50.0 and shown <= 62.0, "shows tick %f" % shown)
	almost_equal(_buffer.transform_at(7, shown).origin.x, 8.0)


func test_memory_is_bounded() -> void:
	for tick: int in 5000:
		var snapshot: Snapshot = _snapshot(tick, {7: _at(1.0, 0.0)})
		snapshot.samples[3] = Snapshot.SampleMark.new()
		_buffer.push(snapshot, tick / 60.0)
	var track: SnapshotBuffer.Track = _buffer._tracks[7]
	is_true(track.ticks.size() <= 32 and track.transforms.size() <= 32)
	is_true(_buffer._marks[3].size() <= 32)
	_buffer.clear()
	is_false(_buffer.has_body(7))


func test_sample_times_with_many_datagrams_a_tick() -> void:
	for tick: int in range(100, 110):
		for part: int in 11:
			var snapshot: Snapshot = _snapshot(tick, {part: _at(1.0, 0.0)})
			snapshot.samples[3] = _mark(tick * 1000)
			_buffer.push(snapshot, tick / 60.0)
	equal(_buffer.sample_time_at(3, 105.0), 105000)
	equal(_buffer.sample_time_at(3, 109.0), 109000)
	equal(_buffer.sample_time_at(4, 109.0), -1, "nobody")
	equal(_buffer.sample_time_at(3, 50.0), -1, "too early")


func test_sample_times_out_of_order() -> void:
	for tick: int in [100, 103, 101, 104, 102]:
		var snapshot: Snapshot = _snapshot(tick, {})
		snapshot.samples[3] = _mark(tick * 1000)
		_buffer.push(snapshot, 10.0)
	for tick: int in range(100, 105):
		equal(_buffer.sample_time_at(3, tick), tick * 1000)


## Plays a session with jitter, 2 % loss and some pause of the server in the middle; measures its
## last quarter.
func _play(p_length_s: float, p_pause_s: float) -> Dictionary:
	var arrivals: Array = []
	for tick: int in int(p_length_s * RATE):
		var sent: float = 50.0 + tick / float(RATE)
		sent += p_pause_s if tick > p_length_s * RATE / 4.0 else 0.0
		if _random.randf() > 0.02:
			arrivals.append([sent + NETWORK_S + _random.randf() * 0.015, tick, sent])
	arrivals.sort_custom(func(a: Array, b: Array) -> bool: return a[0] < b[0])
	var next: int = 0
	var last: float = -INF
	var counts: Dictionary = {"frames": 0, "between": 0.0, "lag_s": 0.0, "backward": 0.0}
	var end: float = 50.0 + p_length_s
	var now: float = 50.1
	while now < end:
		while next < arrivals.size() and arrivals[next][0] <= now:
			_buffer.push(_snapshot(arrivals[next][1], {7: _at(arrivals[next][1], 0.0)}), now)
			next += 1
		if now > end - p_length_s / 4.0:
			var shown: float = _buffer.shown_tick(now)
			counts["frames"] += 1
			counts["between"] += 1.0 if shown < _buffer.newest_tick else 0.0
			counts["lag_s"] += now - 50.0 - p_pause_s - shown / RATE
			counts["backward"] = maxf(counts["backward"], last - shown)
			last = shown
		now += _random.randf_range(0.005, 0.012)
	counts["between"] /= counts["frames"]
	counts["lag_s"] /= counts["frames"]
	return counts


static func _snapshot(p_tick: int, p_bodies: Dictionary) -> Snapshot:
	var snapshot: Snapshot = Snapshot.new()
	snapshot.tick = p_tick
	snapshot.tick_rate = RATE
	for id: int in p_bodies:
		snapshot.bodies[id] = p_bodies[id]
	return snapshot


static func _mark(p_usec: int) -> Snapshot.SampleMark:
	var mark: Snapshot.SampleMark = Snapshot.SampleMark.new()
	mark.time_usec = p_usec
	return mark


static func _at(p_x: float, p_turn: float) -> Transform3D:
	return Transform3D(Basis(Vector3.UP, p_turn), Vector3(p_x, 0.0, 0.0))

extends TestCase
## What the latency probe counts, and what it writes.

var _probe: LatencyProbe = LatencyProbe.new()
var _file: String = ""


func before_each() -> void:
	_file = OS.get_temp_dir().path_join("dismount_latency_%d.csv" % Time.get_ticks_usec())


func after_each() -> void:
	if FileAccess.file_exists(_file):
		DirAccess.remove_absolute(_file)


func test_a_sample_counts_when_the_frame_of_its_tick_is_drawn() -> void:
	_probe.arrived(_mark(1, 100, 1000000))
	_probe.shows(99.9)
	_probe.drawn(1020000)
	equal(_probe.total.count(), 0)
	_probe.shows(100.2)
	_probe.drawn(1030000)
	equal(_probe.total.count(), 1)
	almost_equal(_probe.total.mean(), 30.0, 1e-9)
	almost_equal(_probe.latest_ms, 30.0, 1e-9)
	_probe.shows(101.0)
	_probe.drawn(1050000)
	equal(_probe.total.count(), 1, "once")


func test_a_sample_that_several_snapshots_name_counts_once_and_people_do_not_mix() -> void:
	for tick: int in [100, 101, 102]:
		_probe.arrived(_mark(1, tick, 1000000))
	var other: LatencyMark = _mark(1, 102, 1000000)
	other.person = 2
	_probe.arrived(other)
	_probe.shows(200.0)
	_probe.drawn(1040000)
	equal(_probe.total.count(), 2)


func test_stages_add_up_to_the_total() -> void:
	for sample: int in 50:
		_probe.arrived(_mark(sample, sample, 1000000 + sample * 16667))
		_probe.shows(sample)
		_probe.drawn(1000000 + sample * 16667 + 21000)
	var sum: float = 0.0
	for stage: LatencyHistogram in _probe.stages:
		equal(stage.count(), 50)
		sum += stage.mean()
	almost_equal(sum, 21.0, 1e-6)
	almost_equal(_probe.total.mean(), 21.0, 1e-6)
	almost_equal(_probe.stages[2].mean(), 3.0, 1e-6, "simulation")


func test_what_is_not_known_is_not_counted() -> void:
	var mark: LatencyMark = LatencyMark.new()
	mark.sampled_usec = 1000000
	mark.arrival_usec = 1010000
	_probe.arrived(mark)
	_probe.shows(0.0)
	_probe.drawn(1015000)
	equal(_probe.total.count(), 1)
	equal(_probe.stages[0].count(), 0)
	almost_equal(_probe.stages[5].mean(), 5.0, 1e-9)
	var unknown: LatencyMark = LatencyMark.new()
	unknown.sample = 5
	_probe.arrived(unknown)
	_probe.shows(0.0)
	_probe.drawn(1020000)
	equal(_probe.total.count(), 1)


func test_a_stream_that_had_stopped_is_no_delay() -> void:
	_probe.arrived(_mark(1, 1, 1000000))
	_probe.shows(1.0)
	_probe.drawn(9000000)
	equal(_probe.total.count(), 0)


func test_memory_is_bounded() -> void:
	for sample: int in LatencyProbe.MAX_WAITING + 500:
		_probe.arrived(_mark(sample, sample, 1000000))
	_probe.shows(1e9)
	_probe.drawn(1010000)
	equal(_probe.total.count(), LatencyProbe.MAX_WAITING)


func test_a_new_server_begins_anew() -> void:
	_probe.arrived(_mark(7, 100000, 1000000))
	_probe.restart()
	_probe.shows(1e9)
	_probe.drawn(1010000)
	equal(_probe.total.count(), 0)
	_probe.arrived(_mark(7, 3, 1000000))
	_probe.shows(3.0)
	_probe.drawn(1010000)
	equal(_probe.total.count(), 1)


func test_the_histogram_knows_mean_deviation_and_percentiles() -> void:
	var histogram: LatencyHistogram = LatencyHistogram.new()
	var plain: Statistics = Statistics.new()
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 3
	var squares: float = 0.0
	for _i: int in 5000:
		var ms: float = random.randfn(20.0, 5.0)
		histogram.add(ms)
		plain.add(ms)
		squares += (ms - 20.0) * (ms - 20.0)
	histogram.add(NAN)
	histogram.add(INF)
	equal(histogram.count(), 5000)
	almost_equal(histogram.mean(), plain.mean(), 1e-6)
	almost_equal(histogram.deviation(), sqrt(squares / 5000.0), 0.02)
	for fraction: float in [0.01, 0.5, 0.95, 0.99]:
		almost_equal(
			histogram.percentile(fraction), plain.percentile(fraction), LatencyHistogram.BIN_MS
		)
	var sum: int = 0
	for count: int in histogram.coarse(0.0, 40.0, 20):
		sum += count
	is_true(sum > 4990 and sum <= 5000)


func test_percentiles_of_long_delays_are_of_the_same_delays_as_the_mean() -> void:
	var histogram: LatencyHistogram = LatencyHistogram.new()
	for i: int in 1000:
		histogram.add(400.0 + i)
	almost_equal(histogram.mean(), 899.5, 0.01)
	for fraction: float in [0.05, 0.2, 0.5, 0.95, 0.99]:
		var exact: float = 400.0 + 1000.0 * fraction
		almost_equal(histogram.percentile(fraction), exact, exact * LatencyHistogram.GROWTH - exact)
	is_true(histogram.percentile(1.0) > histogram.mean())
	histogram.add(1e9)
	is_true(histogram.percentile(1.0) > 60000.0)


func test_the_histogram_takes_any_delay() -> void:
	var histogram: LatencyHistogram = LatencyHistogram.new()
	equal(histogram.percentile(0.5), 0.0)
	equal(histogram.deviation(), 0.0)
	histogram.add(-1e9)
	histogram.add(1e9)
	equal(histogram.count(), 2)
	is_true(histogram.percentile(0.5) < 0.0)
	is_true(histogram.percentile(1.0) > 400.0)


func test_a_file_holds_a_line_for_each_sample_and_can_be_read_again() -> void:
	equal(_probe.write_to(_file), "")
	for sample: int in 20:
		_probe.arrived(_mark(sample, sample, 1795272192379273 + sample * 16667))
		_probe.shows(sample)
		_probe.drawn(1795272192379273 + sample * 16667 + 18000 + sample * 100)
	_probe.close()
	var lines: PackedStringArray = FileAccess.get_file_as_string(_file).strip_edges().split("\n")
	equal(lines.size(), 21)
	equal(lines[0], ",".join(LatencyMark.COLUMNS))
	is_true(lines[1].ends_with("18.000"))
	var again: LatencyProbe = LatencyReader.read(_file)
	equal(again.stats(), _probe.stats())


func test_a_file_that_is_none_is_refused() -> void:
	contains(_probe.write_to("/nowhere/at/all.csv"), "/nowhere/at/all.csv")
	is_null(LatencyReader.read("/nowhere/at/all.csv"))
	var file: FileAccess = FileAccess.open(_file, FileAccess.WRITE)
	file.store_string("what,is,this\n1,2,3\n")
	file.close()
	is_null(LatencyReader.read(_file))
	file = FileAccess.open(_file, FileAccess.WRITE)
	file.store_string(",".join(LatencyMark.COLUMNS) + "\nx,y\n" + "a,".repeat(10) + "b\n\n")
	file.close()
	equal(LatencyReader.read(_file).total.count(), 0)


func test_the_panel_opens_and_closes_with_its_key() -> void:
	var panel: LatencyPanel = LatencyPanel.new()
	panel.size = Vector2(390, 350)
	panel.probe = _probe
	add_child(panel)
	_probe.arrived(_mark(1, 1, 1000000))
	_probe.shows(1.0)
	_probe.drawn(1020000)
	is_false(panel.visible)
	for opened: bool in [true, false, true]:
		var key: InputEventKey = InputEventKey.new()
		key.keycode = KEY_L
		key.pressed = true
		panel._unhandled_key_input(key)
		equal(panel.visible, opened)
	await process_frames(3)
	panel.queue_free()


static func _mark(p_sample: int, p_tick: int, p_sampled: int) -> LatencyMark:
	var mark: LatencyMark = LatencyMark.new()
	mark.sample = p_sample
	mark.tick = p_tick
	mark.sampled_usec = p_sampled
	mark.sent_usec = p_sampled + 1000
	mark.received_usec = p_sampled + 2000
	mark.simulated_usec = p_sampled + 5000
	mark.snapshot_sent_usec = p_sampled + 6000
	mark.arrival_usec = p_sampled + 8000
	return mark

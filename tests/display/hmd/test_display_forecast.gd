extends TestCase
## When a frame is seen in a headset.

const _PERIOD_NS: int = 11_111_111

var _forecast: DisplayForecast = DisplayForecast.new()


func before_each() -> void:
	_forecast = DisplayForecast.new()


func test_nothing_is_known_at_first() -> void:
	_forecast.note(0, 5_000_000, 1_000_000, 0.0)
	equal(_forecast.due_usec, 0)
	equal(_forecast.rate_hz(), 0.0)


func test_a_runtime_on_the_systems_clock_is_exact() -> void:
	# The system has run for 5 s, the program for 1 s; the frame is seen in 22 ms.
	_forecast.note(5_022_000_000, 5_000_000, 1_000_000, 90.0)
	equal(_forecast.due_usec, 1_022_000)
	is_true(_forecast.is_exact)


func test_it_holds_for_the_whole_frame_and_never_goes_back() -> void:
	_forecast.note(5_022_000_000, 5_000_000, 1_000_000, 90.0)
	# Noted again in the same frame, later.
	_forecast.note(5_022_000_000, 5_008_000, 1_008_100, 90.0)
	equal(_forecast.due_usec, 1_022_000)
	# The clocks are read one after the other: another program came in between.
	_forecast.note(5_022_000_000 + _PERIOD_NS, 5_025_000, 1_011_000, 90.0)
	is_true(_forecast.due_usec >= 1_022_000, str(_forecast.due_usec))


func test_another_clock_is_guessed_two_refreshes_ahead() -> void:
	var now: int = 1_000_000
	var predicted: int = 900_000_000_000
	for i: int in 40:
		# Every third frame is woken 3 ms late: that brings it no nearer to being seen.
		var late: int = 3_000 if i % 3 == 2 else 0
		_forecast.note(predicted, now + 4_000_000, now + late, 0.0)
		if i > 2:
			almost_equal(float(_forecast.due_usec), now + 2.0 * 1e6 / 90.0, 20.0)
		now += 11_111
		predicted += 11_111_000
	is_false(_forecast.is_exact)
	almost_equal(_forecast.rate_hz(), 90.0, 0.01)


func test_a_pause_at_the_beginning_is_no_long_lead() -> void:
	# The second frame comes 3 s after the first: nothing is known of the rate yet.
	_forecast.note(900_000_000_000, 5_000_000, 1_000_000, 0.0)
	_forecast.note(903_000_000_000, 8_000_000, 4_000_000, 0.0)
	is_true(_forecast.due_usec <= 4_100_000, str(_forecast.due_usec))


func test_the_rate_is_the_shortest_step() -> void:
	var predicted: int = 5_000_000_000
	for steps: int in [1, 2, 1, 3]:
		predicted += steps * _PERIOD_NS
		_forecast.note(predicted, predicted / 1000 - 20_000, predicted / 1000, 0.0)
	almost_equal(_forecast.rate_hz(), 90.0, 0.001)

extends TestCase
## What a client tells of how well it sees.


func test_round_trip() -> void:
	var told: Dictionary = StatsMessage.decode(StatsMessage.encode(12.34, 40.0, 8.0, 59.6))
	almost_equal(told["display_latency_ms_p50"], 12.3, 0.051)
	almost_equal(told["display_latency_ms_p95"], 40.0, 0.051)
	almost_equal(told["smoothing_delay_ms"], 8.0, 0.051)
	equal(told["frames_per_second"], 60)


func test_numbers_that_do_not_fit() -> void:
	var told: Dictionary = StatsMessage.decode(StatsMessage.encode(1e9, -5.0, NAN, INF))
	almost_equal(told["display_latency_ms_p50"], 6553.5, 0.01)
	equal(told["display_latency_ms_p95"], 0.0)
	equal(told["smoothing_delay_ms"], 0.0)
	equal(told["frames_per_second"], 0)


func test_what_is_none() -> void:
	equal(StatsMessage.decode(PackedByteArray()), {})
	var bytes: PackedByteArray = StatsMessage.encode(1.0, 2.0, 3.0, 4.0)
	equal(StatsMessage.decode(bytes.slice(0, 8)), {})
	bytes.append(0)
	equal(StatsMessage.decode(bytes), {})

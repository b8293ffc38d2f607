extends TestCase
## What a benchmark's exit code says.


func test_a_lead_can_be_too_big() -> void:
	for value: float in [3.9, -3.9, 0.0]:
		equal(_finish(value, BenchReport.Goal.WITHIN), 0, "%f" % value)
	for value: float in [4.1, -4.1, NAN, -INF]:
		equal(_finish(value, BenchReport.Goal.WITHIN), BenchReport.GOALS_MISSED, "%f" % value)
	equal(_finish(-100.0, BenchReport.Goal.AT_MOST), 0)
	equal(_finish(-100.0, BenchReport.Goal.AT_LEAST), BenchReport.GOALS_MISSED)
	equal(_finish(-100.0, BenchReport.Goal.NONE), 0)


func test_what_is_left_out_counts_more_than_a_missed_goal() -> void:
	var report: BenchReport = BenchReport.new("test", true)
	report.add("all", "lag", 9.0, "ms", BenchReport.Goal.WITHIN, 4.0)
	is_true(report.open_clip("res://tests/bench/no_such_file.bvh") == null)
	equal(report.finish(), BenchReport.LEFT_OUT)


func _finish(p_value: float, p_kind: BenchReport.Goal) -> int:
	var report: BenchReport = BenchReport.new("test", true)
	report.add("all", "lag", p_value, "ms", p_kind, 4.0)
	return report.finish()

extends TestCase
## The last values of a stream count, and no others.


func test_percentiles() -> void:
	var values: RecentStatistics = RecentStatistics.new()
	for value: int in range(100, 0, -1):
		values.add(value)
	equal(values.count(), 100)
	almost_equal(values.percentile(0.5), 50.0)
	almost_equal(values.percentile(0.95), 95.0)
	almost_equal(values.percentile(1.0), 100.0)
	almost_equal(values.percentile(0.0), 1.0)
	almost_equal(values.percentile(7.0), 100.0)
	almost_equal(values.percentile(-7.0), 1.0)


func test_without_values() -> void:
	var values: RecentStatistics = RecentStatistics.new()
	equal([values.count(), values.percentile(0.5)], [0, 0.0])


func test_a_single_value() -> void:
	var values: RecentStatistics = RecentStatistics.new()
	values.add(-3.0)
	for fraction: float in [0.0, 0.5, 0.99, 1.0]:
		almost_equal(values.percentile(fraction), -3.0)


func test_old_values_are_forgotten() -> void:
	var values: RecentStatistics = RecentStatistics.new()
	for _old: int in RecentStatistics.KEPT:
		values.add(1000.0)
	for _new: int in RecentStatistics.KEPT - 1:
		values.add(1.0)
	equal(values.count(), RecentStatistics.KEPT)
	almost_equal(values.percentile(1.0), 1000.0)
	values.add(1.0)
	equal(values.count(), RecentStatistics.KEPT)
	almost_equal(values.percentile(1.0), 1.0)

extends TestCase
## Means and percentiles, against a slow but plain way to find them.


func test_nothing() -> void:
	var statistics: Statistics = Statistics.new()
	equal([statistics.count(), statistics.mean(), statistics.percentile(0.5)], [0, 0.0, 0.0])


func test_known_values() -> void:
	var statistics: Statistics = Statistics.new()
	for value: int in [4, 1, 3, 2, 5, 10, 9, 8, 7, 6]:
		statistics.add(value)
	equal(statistics.count(), 10)
	almost_equal(statistics.mean(), 5.5)
	var wanted: Dictionary[float, float] = {0.0: 1.0, 0.5: 5.0, 0.51: 6.0, 0.95: 10.0, 1.0: 10.0}
	for fraction: float in wanted:
		equal(statistics.percentile(fraction), wanted[fraction], "%f" % fraction)


func test_a_percentile_is_the_least_value_that_a_fraction_does_not_exceed() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 1
	for _round: int in 50:
		var statistics: Statistics = Statistics.new()
		var values: Array[float] = []
		for _value: int in random.randi_range(1, 40):
			values.append(random.randi_range(-5, 5))
			statistics.add(values[-1])
		var fraction: float = random.randf()
		var found: float = statistics.percentile(fraction)
		is_true(_share(values, found, true) >= fraction)
		is_true(_share(values, found, false) < fraction)


func test_recent_percentiles() -> void:
	var values: Statistics = Statistics.recent()
	equal(values.percentile(0.5), 0.0, "none")
	for value: int in 100:
		values.add(value + 1.0)
	equal(values.percentile(0.5), 50.0)
	equal(values.percentile(1.0), 100.0)
	equal(values.percentile(1.0, 1000), 100.0, "more than there are")
	equal(values.percentile(0.0, 10), 91.0)
	equal(values.percentile(0.5, 10), 95.0)


func test_the_recent_ones_also_where_the_oldest_are_replaced() -> void:
	var values: Statistics = Statistics.recent()
	for value: int in Statistics.RECENT + 5:
		values.add(value)
	equal(values.count(), Statistics.RECENT)
	equal(values.percentile(0.0), 5.0)
	equal(values.percentile(0.0, 10), Statistics.RECENT - 5.0)
	equal(values.percentile(1.0, 10), Statistics.RECENT + 4.0)
	equal(values.percentile(0.0, 3), Statistics.RECENT + 2.0)


## The share of values below a limit, or at most it.
func _share(p_values: Array[float], p_limit: float, p_with: bool) -> float:
	var below: int = 0
	for value: float in p_values:
		below += 1 if value < p_limit or (p_with and value == p_limit) else 0
	return below / float(p_values.size())

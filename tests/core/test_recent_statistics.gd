extends TestCase
## Percentiles of the last values of a stream.


func test_percentiles() -> void:
	var values: RecentStatistics = RecentStatistics.new()
	equal(values.percentile(0.5), 0.0, "none")
	for value: int in 100:
		values.add(value + 1.0)
	equal(values.percentile(0.5), 50.0)
	equal(values.percentile(1.0), 100.0)
	equal(values.percentile(1.0, 1000), 100.0, "more than there are")
	equal(values.percentile(0.0, 10), 91.0)
	equal(values.percentile(0.5, 10), 95.0)


func test_the_last_ones_also_where_the_oldest_are_replaced() -> void:
	var values: RecentStatistics = RecentStatistics.new()
	for value: int in RecentStatistics.KEPT + 5:
		values.add(value)
	equal(values.count(), RecentStatistics.KEPT)
	equal(values.percentile(0.0), 5.0)
	equal(values.percentile(0.0, 10), RecentStatistics.KEPT - 5.0)
	equal(values.percentile(1.0, 10), RecentStatistics.KEPT + 4.0)
	equal(values.percentile(0.0, 3), RecentStatistics.KEPT + 2.0)


func test_a_thread_that_works_is_counted() -> void:
	var begin: int = ThreadClock.get_usec()
	var sum: int = 0
	while ThreadClock.get_usec() - begin < 2000:
		sum += 1
	is_true(sum > 0)
	# Who sleeps does not work.
	var before: int = ThreadClock.get_usec()
	OS.delay_msec(50)
	is_true(ThreadClock.get_usec() - before < 25000)

extends TestCase
## Times of samples that wait on their way for different times.


func test_a_sender_s_clock_is_free_of_the_network_s_jitter() -> void:
	for counts: bool in [false, true]:
		var time: StreamTime = StreamTime.new()
		var random: RandomNumberGenerator = RandomNumberGenerator.new()
		random.seed = 4
		var worst: int = 0
		var arrival: int = 0
		for number: int in 2000:
			var taken: int = 5_000_000_000 + number * 4167
			arrival = maxi(arrival, taken + 2000 + random.randi_range(0, 6000))
			var found: int = 0
			if counts:
				found = time.at_count(number, arrival)
			else:
				# Another clock, which is a hundred parts in a million slow.
				found = time.at(roundi(number * 4167 * 0.9999), arrival)
			if number > 1000:
				worst = maxi(worst, absi(found - taken - 2000))
		is_true(worst < 900, "%d µs" % worst)


func test_a_clock_that_stands_still_is_not_believed() -> void:
	var time: StreamTime = StreamTime.new()
	for number: int in 400:
		var arrival: int = 1_000_000_000 + number * 10000
		var found: int = time.at(7, arrival)
		if number > 150:
			equal(found, arrival)


func test_times_never_go_back() -> void:
	var time: StreamTime = StreamTime.new()
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 2
	var last: int = 0
	for number: int in 1000:
		var arrival: int = 1_000_000_000 + number * 5000 + random.randi_range(0, 4000)
		var found: int = time.at(number * 5000, arrival)
		is_true(found > last)
		last = found

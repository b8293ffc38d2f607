extends TestCase
## Buckets of tokens.


func test_a_burst_and_so_many_a_second() -> void:
	var allowance: Allowance = Allowance.new(3.0, 2.0)
	var taken: int = 0
	for tick: int in 600:
		taken += 1 if allowance.take("a", tick / 60.0) else 0
	is_true(absi(taken - 3 - 20) <= 1, "%d in 10 s" % taken)
	is_true(allowance.take("b", 0.0), "another key")


func test_how_long_to_wait() -> void:
	var allowance: Allowance = Allowance.new(1.0, 0.1)
	equal(allowance.wait_s("a", 0.0), 0.0)
	is_true(allowance.take("a", 0.0))
	almost_equal(allowance.wait_s("a", 4.0), 6.0, 0.001)
	allowance.give_back("a")
	is_true(allowance.has("a", 4.0))


func test_what_is_remembered_is_bounded() -> void:
	var allowance: Allowance = Allowance.new(2.0, 0.001)
	for key: int in Allowance.MAX_KEYS + 100:
		allowance.take(key, 0.0)
	is_true(allowance._left.size() <= Allowance.MAX_KEYS)
	is_false(allowance.has("x", 0.0) and not allowance.take("x", 0.0))

extends TestCase
## How often passwords may be tried without sealing: what one address, its surroundings and all
## together have, and that newcomers have a budget of their own.


func test_an_address_has_five_tries_then_one_in_two_seconds() -> void:
	var limit: LoginRateLimiter = LoginRateLimiter.new()
	for _guess: int in LoginRateLimiter.BURST:
		is_true(limit.take("10.0.0.1", 0.0))
	is_false(limit.take("10.0.0.1", 1.9))
	is_true(limit.take("10.2.0.1", 1.9), "another address")
	is_true(limit.take("10.0.0.1", 2.0))
	is_false(limit.take("10.0.0.1", 2.1))


func test_success_alone_gives_a_try_back() -> void:
	var limit: LoginRateLimiter = LoginRateLimiter.new()
	for _try: int in 100:
		is_true(limit.take("10.0.0.1", 0.0))
		limit.give_back("10.0.0.1")
	for _guess: int in LoginRateLimiter.BURST:
		is_true(limit.take("10.0.0.1", 0.0))
	is_false(limit.take("10.0.0.1", 0.0))


func test_addresses_around_share_a_budget() -> void:
	var pairs: Array[PackedStringArray] = [
		["10.0.0.%d", "10.0.1.1"], ["2001:db8:1:%x::1", "2001:db8:2::1"]
	]
	for pair: PackedStringArray in pairs:
		var limit: LoginRateLimiter = LoginRateLimiter.new()
		var taken: int = 0
		for number: int in 200:
			taken += 1 if limit.take(pair[0] % (number + 1), 0.0) else 0
		equal(taken, 8)
		is_true(limit.take(pair[1], 0.0), "from elsewhere")


func test_one_address_with_a_whole_64_is_one_address() -> void:
	var limit: LoginRateLimiter = LoginRateLimiter.new()
	var taken: int = 0
	for number: int in 200:
		taken += 1 if limit.take("2001:db8:1:1::%x" % number, 0.0) else 0
	equal(taken, LoginRateLimiter.BURST)


func test_guessers_everywhere_use_up_what_is_theirs() -> void:
	var limit: LoginRateLimiter = LoginRateLimiter.new()
	var now: float = 0.0
	for network: int in 200:
		now += 0.2
		limit.take("10.%d.0.1" % network, now)
	# From now on all of them have guessed wrongly before.
	now += 10.0
	var taken: int = 0
	for round: int in 100:
		now += 0.1
		for network: int in 200:
			taken += 1 if limit.take("10.%d.0.1" % network, now) else 0
	is_true(taken <= 4 + 15, "%d in 10 s" % taken)
	is_true(limit.take("192.168.7.7", now), "a newcomer is not kept out")


func test_what_is_remembered_is_bounded() -> void:
	var limit: LoginRateLimiter = LoginRateLimiter.new()
	for number: int in 3 * LoginRateLimiter.MAX_NETWORKS:
		limit.take("10.%d.%d.1" % [number >> 8, number & 255], number * 1.0)
	is_true(limit._seen_s.size() <= LoginRateLimiter.MAX_NETWORKS)
	is_true(limit._open.size() <= LoginRateLimiter.MAX_NETWORKS)
	is_true(limit._of_network._left.size() <= Allowance.MAX_KEYS)

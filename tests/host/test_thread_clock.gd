extends TestCase
## The CPU time of a thread.


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

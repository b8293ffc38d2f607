extends TestCase
## How many datagrams of a kind are let through.


func test_first_bytes_that_count_as_one_kind() -> void:
	var guard: TransportGuard = TransportGuard.new()
	guard.limits.max_fast = {1: 10}
	guard.limits.high_from = 128
	guard.limits.high_kind = 1
	var from: TransportConnection = TransportConnection.new(2, null, 0)
	from.stage = TransportConnection.Stage.ADMITTED
	var passed: int = 0
	for first: int in [1, 128, 200, 255]:
		for _datagram: int in 5:
			var verdict: TransportGuard.Verdict = guard.judge_fast(from, [first, 0])
			passed += 1 if verdict == TransportGuard.Verdict.PASS else 0
	equal(passed, 10)
	contains(guard.reason, "kind 1")
	equal(guard.judge_fast(from, [127, 0]), TransportGuard.Verdict.PASS, "another kind")
	from.restart_window()
	equal(guard.judge_fast(from, [130, 0]), TransportGuard.Verdict.PASS, "another second")

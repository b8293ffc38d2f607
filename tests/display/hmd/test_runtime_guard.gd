extends TestCase
## The watch over a headset's runtime: what the next process is told, and when it is quick.


func after_each() -> void:
	OS.unset_environment(HmdCommand.LOST)


func test_it_is_quick_only_after_some_frames() -> void:
	var guard: RuntimeGuard = RuntimeGuard.new()
	guard.begin()
	is_false(guard.is_warm())
	for i: int in 40:
		guard.hold()
		guard.beat()
	is_true(guard.is_warm())
	guard.end()


func test_the_next_process_is_told_why_only_while_it_watches() -> void:
	var guard: RuntimeGuard = RuntimeGuard.new()
	guard.begin()
	is_true("stalled" in OS.get_environment(HmdCommand.LOST))
	guard.end()
	equal(OS.get_environment(HmdCommand.LOST), "")

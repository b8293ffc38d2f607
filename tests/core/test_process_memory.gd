extends TestCase
## What this process takes is what the system counts.


func test_what_is_taken_is_counted() -> void:
	var before: int = ProcessMemory.resident_bytes()
	is_true(before > 10 << 20, "an engine takes more than 10 MB: %d" % before)
	var taken: PackedByteArray = []
	taken.resize(64 << 20)
	taken.fill(1)
	is_true(ProcessMemory.resident_bytes() > before + (32 << 20))
	equal(taken[-1], 1)

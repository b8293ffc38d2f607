extends TestCase
## What this process takes is what the system counts.


func test_what_is_taken_is_counted() -> void:
	var before: int = ProcessMemory.resident_bytes()
	is_true(before > 10 << 20, "an engine takes more than 10 MB")
	# The C library may hold memory that tests before have freed: it is given out first, and counts
	# already.
	var taken: Array[PackedByteArray] = []
	while taken.size() < 20 and ProcessMemory.resident_bytes() < before + (32 << 20):
		var block: PackedByteArray = []
		block.resize(64 << 20)
		block.fill(1)
		taken.append(block)
	is_true(taken.size() < 20, "%d blocks of 64 MB are not counted" % taken.size())
	equal(taken[-1][-1], 1)

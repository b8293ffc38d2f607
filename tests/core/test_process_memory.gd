extends TestCase
## What this process takes is what the system counts.


func test_what_is_taken_is_counted() -> void:
	is_true(ProcessMemory.resident_bytes() > 10 << 20, "an engine takes more than 10 MB")
	var grown: PackedInt64Array = []
	# Other threads may give memory back at the same moment, such as that of the test before.
	while grown.size() < 10 and (grown.is_empty() or grown[-1] < 32 << 20):
		var before: int = ProcessMemory.resident_bytes()
		var taken: PackedByteArray = []
		taken.resize(64 << 20)
		taken.fill(1)
		grown.append(ProcessMemory.resident_bytes() - before)
		equal(taken[-1], 1)
	is_true(grown[-1] >= 32 << 20, "64 MB taken, counted: %s" % grown)

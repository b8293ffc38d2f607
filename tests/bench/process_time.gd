extends RefCounted
## Processor time of this process, with all its threads.


## What has been used so far, ms.
static func used_ms() -> float:
	var sum: float = 0.0
	for thread: String in DirAccess.get_directories_at("/proc/self/task"):
		var file: FileAccess = FileAccess.open(
			"/proc/self/task/%s/schedstat" % thread, FileAccess.READ
		)
		if file != null:
			sum += file.get_line().get_slice(" ", 0).to_float() / 1e6
	return sum


## What it takes in a second, ms: the median of some spells, as other programs on the same cores
## disturb it.
static func busy_ms(p_tree: SceneTree) -> float:
	var spells: PackedFloat64Array = []
	for _spell: int in 5:
		var before: float = used_ms()
		var begin: int = Time.get_ticks_usec()
		await p_tree.create_timer(1.5).timeout
		spells.append((used_ms() - before) / ((Time.get_ticks_usec() - begin) / 1e6))
	spells.sort()
	return spells[spells.size() / 2]

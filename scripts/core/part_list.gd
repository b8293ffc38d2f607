class_name PartList
extends RefCounted
## The parts of a program, in their order: makes them, opens them, and ends them in the opposite
## order, as far as they were opened.

## All parts, in their order.
var parts: Array[ProgramPart] = []
## Exit code of the fault that [method begin] has found.
var fault_code: int = 0

var _opened: Array[ProgramPart] = []


## Makes the parts whose scripts have these paths, as children of a node.
func make(p_paths: PackedStringArray, p_parent: Node) -> void:
	for path: String in p_paths:
		var part: ProgramPart = (load(path) as GDScript).new()
		part.name = path.get_file().get_basename().to_pascal_case()
		parts.append(part)
		p_parent.add_child(part)


## Opens all by [code]func(part: ProgramPart) -> String[/code]. Returns the first fault, or an empty
## text.
func open(p_open: Callable) -> String:
	for part: ProgramPart in parts:
		_opened.append(part)
		var fault: String = p_open.call(part)
		if fault != "":
			return fault
	return ""


## Begins with all. Returns the first fault, or an empty text.
func begin() -> String:
	for part: ProgramPart in parts:
		var fault: String = part.begin()
		if fault != "":
			fault_code = part.fault_code
			return fault
	return ""


## What all that are open report.
func report() -> Dictionary:
	var report: Dictionary = {}
	for part: ProgramPart in _opened:
		report.merge(part.report())
	return report


## Waits until nothing of the parts runs any more.
func finish() -> void:
	for part: ProgramPart in _opened.duplicate():
		# Of some parts it is a coroutine.
		@warning_ignore("redundant_await")
		await part.finish()


## Closes all, once.
func close() -> void:
	while not _opened.is_empty():
		(_opened.pop_back() as ProgramPart).close()

class_name LevelCheck
extends RefCounted
## Looks for what is wrong in a level: see [enum LevelFault.Kind].
##
## The level must be in the tree for two physics frames, so that the engine knows its bodies. It
## changes nothing in it.

## What was found, the worst first.
var faults: Array[LevelFault] = []

var _level: Level = null


func _init(p_level: Level) -> void:
	_level = p_level


## Does the work: up to a second or two for a town.
func run() -> void:
	faults.clear()
	PlaceCheck.new(self).run()
	BuildCheck.new(self).run()
	FlickerCheck.new(self).run()
	WalkCheck.new(self).run()
	faults.sort_custom(func(a: LevelFault, b: LevelFault) -> bool: return a.severity > b.severity)


## The level that is looked at.
func get_level() -> Level:
	return _level


## How many are faults, not hints.
func count_faults() -> int:
	return (
		faults
		. filter(func(one: LevelFault) -> bool: return one.severity == LevelFault.Severity.FAULT)
		. size()
	)


## Notes that somebody cannot play in the level as it is meant. Of a node, or null for the level.
func add_fault(p_kind: LevelFault.Kind, p_node: Node3D, p_text: String) -> void:
	_add(p_kind, LevelFault.Severity.FAULT, p_node, p_text)


## Notes what could be better.
func add_hint(p_kind: LevelFault.Kind, p_node: Node3D, p_text: String) -> void:
	_add(p_kind, LevelFault.Severity.HINT, p_node, p_text)


func _add(
	p_kind: LevelFault.Kind, p_severity: LevelFault.Severity, p_node: Node3D, p_text: String
) -> void:
	var path: NodePath = NodePath()
	var place: Vector3 = Vector3.ZERO
	if p_node != null:
		path = _level.get_path_to(p_node)
		place = p_node.global_position
	faults.append(LevelFault.make(p_kind, p_severity, path, place, p_text))

class_name LevelFindings
extends RefCounted
## What the checks of a level have found: see [LevelCheck].

## The level that is looked at.
var level: Level = null
## What was found, in the order in which it was.
var faults: Array[LevelFault] = []


func _init(p_level: Level) -> void:
	level = p_level


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
		path = level.get_path_to(p_node)
		place = p_node.global_position
	faults.append(LevelFault.make(p_kind, p_severity, path, place, p_text))

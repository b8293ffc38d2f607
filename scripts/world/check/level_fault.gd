class_name LevelFault
extends RefCounted
## Something in a level that is wrong or will surprise people, and how to set it right.

## How bad it is.
enum Severity {
	## The level works, but not as well as it could.
	HINT,
	## Somebody cannot play in it as it is meant.
	FAULT,
}

## What is wrong.
enum Kind {
	NO_SPAWN_POINT,
	SPAWN_POINT_IN_WALL,
	SPAWN_POINT_IN_AIR,
	PROP_IN_WALL,
	NO_COLLISION,
	SCALED,
	TOO_MANY_BODIES,
	NOT_BAKED,
	UNREACHABLE,
	CAMERA_IN_WALL,
	FLICKERS,
}

## What is wrong.
var kind: Kind = Kind.NO_SPAWN_POINT
## How bad it is.
var severity: Severity = Severity.FAULT
## What is wrong and how to set it right, for people.
var text: String = ""
## The node, from the level's root; empty for the level itself.
var path: NodePath = NodePath()
## Where it is, m.
var place: Vector3 = Vector3.ZERO


static func make(
	p_kind: Kind, p_severity: Severity, p_path: NodePath, p_place: Vector3, p_text: String
) -> LevelFault:
	var fault: LevelFault = LevelFault.new()
	fault.kind = p_kind
	fault.severity = p_severity
	fault.path = p_path
	fault.place = p_place
	fault.text = p_text
	return fault


## One line of text about the stream, for the user.
func describe() -> String:
	var level: String = "fault" if severity == Severity.FAULT else "hint"
	var node: String = String(path) if not path.is_empty() else "the level"
	return "%s: %s at (%.1f, %.1f, %.1f): %s" % [level, node, place.x, place.y, place.z, text]

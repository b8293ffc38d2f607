class_name EntityRow
extends RefCounted
## One row of an [EntityTable]: an entity's number, type, owner and node.

## Where the entity's node comes from.
enum Source {
	## It has none: the world itself, or a person, whose scene every client knows.
	NONE,
	## It is part of the level: [member path] leads to it.
	LEVEL,
	## It is an instance of the scene at [member path].
	SCENE,
}

## Number of the entity, 0 to 65535; see [EntityTable].
var id: int = 0
## Number of its type in the table.
var type_number: int = 0
## Its type.
var type: EntityType = null
## The server's tick at which it came.
var tick: int = 0
## Session that it belongs to; 0 none.
var owner: int = 0
## Where its node comes from.
var source: Source = Source.NONE
## Path below the level's root, or of a scene; of a person the name of the avatar.
var path: String = ""
## Of an instance of a scene: where its root is in the level when it comes.
var transform: Transform3D = Transform3D.IDENTITY
## Values of its fields when it came, as both ends restore them.
var values: PackedFloat32Array = PackedFloat32Array()
## Version of the table in which it came; of the server's table only.
var version: int = 0
## The encoded row; made when it is first sent, as every late joiner gets it.
var encoded: PackedByteArray = PackedByteArray()
## Of a person: which of its session's people it is.
var person_index: int = 0
## Of a person: the name, shown to the others.
var person_name: String = ""
## Of a person: how the limbs hang together; empty where nobody needs it.
var skeleton: PersonSkeleton = PersonSkeleton.new()


## Whether it is a person.
func is_person() -> bool:
	return type.body == EntityType.Body.PERSON


## What people call it: a person's name, or that of its node.
func title() -> String:
	if is_person():
		return person_name
	# The node of an entity without a body of its own lies below what people see.
	var parts: PackedStringArray = path.split("/", false)
	var is_named: bool = parts.size() > 1 and parts[-1] == "Entity"
	return parts[-2] if is_named else path.get_file()


## For the log.
func describe() -> String:
	var what: String = person_name if is_person() else path
	return "%s %d%s" % [type.name, id, " (%s)" % what if what != "" else ""]

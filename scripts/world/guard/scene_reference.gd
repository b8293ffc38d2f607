class_name SceneReference
extends RefCounted
## A value of a text scene that names something else of the scene: a resource, or a list of them.

## What is named.
enum Kind {
	## A resource of the same file.
	SUB,
	## A file of the program.
	EXTERNAL,
	## Several references.
	LIST,
}

## What is named.
var kind: Kind = Kind.SUB
## Its id in the file.
var id: String = ""
## The references of a [constant Kind.LIST].
var items: Array[SceneReference] = []


## A reference to one thing.
static func of(p_kind: Kind, p_id: String) -> SceneReference:
	var made: SceneReference = SceneReference.new()
	made.kind = p_kind
	made.id = p_id
	return made

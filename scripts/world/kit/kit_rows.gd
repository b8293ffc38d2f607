@tool
@abstract class_name KitRows
extends RefCounted
## What a feature lets levels from elsewhere have besides blocks ([KitEntry]), such as the vehicles:
## a class that extends this one is found by that alone.

## The rows of [LevelKit].
@abstract func rows() -> Array[KitClass]


## What the editor's dock offers of it.
func items() -> Array[KitItem]:
	return []


## One of each of the classes that there are, sorted by the paths of their scripts.
static func all() -> Array[KitRows]:
	var found: Array[KitRows] = []
	for path: String in ClassPaths.extending(&"KitRows"):
		found.append((load(path) as GDScript).new())
	return found


static func _path(p_class: GDScript) -> String:
	return p_class.resource_path

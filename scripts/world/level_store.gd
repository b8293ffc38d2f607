class_name LevelStore
extends RefCounted
## The levels that this machine has: [code]scenes/world/NAME/NAME.tscn[/code].

## Folder of the levels.
const ROOT: String = "res://scenes/world"
## The level that a server has by default.
const DEFAULT: String = "hangar"
## Longest name of a level, characters.
const MAX_NAME: int = 40


## Names of all levels, in the order of the alphabet.
static func names() -> PackedStringArray:
	var found: PackedStringArray = []
	for entry: String in ResourceLoader.list_directory(ROOT):
		var name: String = entry.trim_suffix("/")
		if entry.ends_with("/") and has(name):
			found.append(name)
	found.sort()
	return found


## Whether there is a level of a name. Names are lower-case letters, digits and underscores, so that
## no name leads out of the folder.
static func has(p_name: String) -> bool:
	return is_name(p_name) and ResourceLoader.exists(path_of(p_name), "PackedScene")


## Whether a text can be the name of a level.
static func is_name(p_name: String) -> bool:
	var letters: RegEx = RegEx.create_from_string("^[a-z][a-z0-9_]*$")
	return p_name.length() <= MAX_NAME and letters.search(p_name) != null


## Path of the scene of a level.
static func path_of(p_name: String) -> String:
	return "%s/%s/%s.tscn" % [ROOT, p_name, p_name]


## A level, not in the tree yet; null if there is none of the name or its root is no [Level].
static func instantiate(p_name: String) -> Level:
	if not has(p_name):
		return null
	var scene: PackedScene = load(path_of(p_name))
	var node: Node = scene.instantiate() if scene != null else null
	if node is Level:
		return node
	if node != null:
		node.free()
	return null


## Why there is no level of a name, for people who have others besides.
static func describe_missing(p_name: String, p_others: PackedStringArray = []) -> String:
	var known: PackedStringArray = names() + p_others
	var text: String = "there is no world '%s' here: %s" % [p_name.left(MAX_NAME), ", ".join(known)]
	return text + Nearest.suggest(p_name, known)

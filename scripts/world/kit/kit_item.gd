@tool
class_name KitItem
extends RefCounted
## One thing that can be placed in a level.

## Where in a level it belongs.
enum Place {
	STATIC,
	PROPS,
	SPAWNS,
	ROOT,
}

## What people call it.
var title: String = ""
## Further words by which it is found.
var words: String = ""
## Its script or scene, or the name of a class of the engine.
var source: String = ""
## Where it belongs.
var place: Place = Place.STATIC
## Values of its properties.
var values: Dictionary = {}
## Height of its origin above what it stands on, m.
var lift: float = 0.0


func _init(
	p_title: String,
	p_words: String,
	p_source: String,
	p_place: Place,
	p_values: Dictionary = {},
	p_lift: float = 0.0
) -> void:
	title = p_title
	words = p_words
	source = p_source
	place = p_place
	values = p_values
	lift = p_lift


## Whether it is what somebody looks for.
func fits(p_search: String) -> bool:
	var text: String = (title + " " + words).to_lower()
	for word: String in p_search.to_lower().split(" ", false):
		if not text.contains(word):
			return false
	return true


## A new one, outside the tree.
func make() -> Node3D:
	var node: Node3D = null
	if source.ends_with(".tscn"):
		var scene: PackedScene = load(source)
		node = scene.instantiate(PackedScene.GEN_EDIT_STATE_INSTANCE)
	elif source.ends_with(".gd"):
		node = (load(source) as GDScript).new()
	else:
		node = ClassDB.instantiate(source)
	node.name = title.to_pascal_case()
	for property: StringName in values:
		node.set(property, values[property])
	return node


## Changes when its picture may have.
func key() -> String:
	var date: int = FileAccess.get_modified_time(source) if source.contains("/") else 0
	return "%s %s %s %d" % [title, source, values, date]

@tool
class_name KitClass
extends RefCounted
## A row of [LevelKit]: a class of nodes or resources, a kit script or a kit scene that a received
## level may use, and which of its properties it may set.

## What a row is about.
enum Kind {
	## A node of an engine class, or of one with a script of the kit.
	NODE,
	## A resource of an engine class, or of one with a script of the kit.
	RESOURCE,
	## A scene of the kit: an instance of it is a node of the level, what is in it stays as it is.
	SCENE,
}

## Materials that a mesh may have, for [method PropertyRule.resource].
const MATERIALS: PackedStringArray = ["StandardMaterial3D", "ShaderMaterial", "Material"]

## The name by which rules name it: of the engine class or of the script's class; of a scene its
## path.
var key: String = ""
## What it is.
var kind: Kind = Kind.NODE
## Class of the engine; empty for a scene.
var base: String = ""
## Path of the script or scene; empty for an engine class.
var path: String = ""
## Path of the script that the root of a scene has: a level may name it again.
var root_script: String = ""
## The properties that a level may set, by name.
var rules: Dictionary[String, PropertyRule] = {}
## Whether a level may put nodes below it.
var takes_children: bool = true
## How many of these a level may have.
var most: int = 20000
## Nodes of a scene that paths of the level may lead to: their paths in it, and their keys.
var inner: Dictionary[String, String] = {}
## Physics bodies that one makes.
var bodies: int = 0


## A row of a node of an engine class.
static func node(
	p_class: String,
	p_rules: Dictionary[String, PropertyRule],
	p_more: Dictionary[String, PropertyRule] = {}
) -> KitClass:
	var row: KitClass = _row(p_class, KitClass.Kind.NODE, p_rules)
	row.base = p_class
	row.rules.merge(p_more)
	return row


## A row of a node with a script of the kit.
static func scripted(
	p_key: String,
	p_class: String,
	p_path: String,
	p_rules: Dictionary[String, PropertyRule],
	p_more: Dictionary[String, PropertyRule] = {}
) -> KitClass:
	var row: KitClass = node(p_class, p_rules, p_more)
	row.key = p_key
	row.path = p_path
	return row


## A row of a scene of the kit.
static func scene(
	p_path: String,
	p_rules: Dictionary[String, PropertyRule],
	p_more: Dictionary[String, PropertyRule] = {}
) -> KitClass:
	var row: KitClass = _row(p_path, KitClass.Kind.SCENE, p_rules)
	row.rules.merge(p_more)
	row.path = p_path
	return row.without_children().with_bodies(1)


## A row of a resource of an engine class.
static func resource(p_class: String, p_rules: Dictionary[String, PropertyRule]) -> KitClass:
	var row: KitClass = _row(p_class, KitClass.Kind.RESOURCE, p_rules)
	row.base = p_class
	return row


## The rules of every physics body.
static func body_rules() -> Dictionary[String, PropertyRule]:
	# The layers of PhysicsLayers and no others.
	var layers: PropertyRule = PropertyRule.whole(0, 7)
	return {
		"collision_layer": layers,
		"collision_mask": layers,
		"physics_material_override": PropertyRule.resource(["PhysicsMaterial"]),
	}


## Lets a level have so many at most.
func at_most(p_count: int) -> KitClass:
	most = p_count
	return self


## Says how many physics bodies one makes. A body must not be scaled.
func with_bodies(p_count: int) -> KitClass:
	bodies = p_count
	return self


## Says which script the root of a scene has.
func with_script(p_path: String) -> KitClass:
	root_script = p_path
	return self


## Lets paths of the level lead to nodes of a scene: their paths in it, and their keys.
func with_nodes(p_nodes: Dictionary[String, String]) -> KitClass:
	inner = p_nodes
	return self


## Says that nothing may be put below it.
func without_children() -> KitClass:
	takes_children = false
	return self


static func _row(
	p_key: String, p_kind: KitClass.Kind, p_rules: Dictionary[String, PropertyRule]
) -> KitClass:
	var row: KitClass = KitClass.new()
	row.key = p_key
	row.kind = p_kind
	row.rules = p_rules.duplicate()
	if p_kind != KitClass.Kind.RESOURCE:
		row.rules["transform"] = PropertyRule.transform()
		row.rules["visible"] = PropertyRule.flag()
		for name: String in ["metadata/_edit_lock_", "metadata/_edit_group_"]:
			row.rules[name] = PropertyRule.ignored()
		row.rules["editor_description"] = PropertyRule.ignored()
	return row

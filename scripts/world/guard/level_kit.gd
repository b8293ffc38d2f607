class_name LevelKit
extends RefCounted
## What a received level may be made of, as data: a row for each class, with the properties that a
## level may set and their ranges. What has no row here is refused by [LevelReader].
##
## A class is added by a row. Scripts and scenes named here are the program's own; a level names
## them by their path and can name no others.

## Folders of the program whose pictures, materials, meshes and shapes levels may use.
const ASSET_FOLDERS: PackedStringArray = ["res://assets/world/", "res://scenes/world/"]
## Classes that such a file may be declared as, and be: nothing that runs.
const ASSET_TYPES: PackedStringArray = [
	"Texture2D",
	"CompressedTexture2D",
	"Material",
	"StandardMaterial3D",
	"ShaderMaterial",
	"Mesh",
	"Shape3D",
	"ArrayMesh",
	"ConvexPolygonShape3D",
	"ConcavePolygonShape3D",
	"PhysicsMaterial",
]
## Endings of such files: no scenes and no scripts.
const ASSET_ENDINGS: PackedStringArray = ["png", "jpg", "webp", "exr", "obj", "res", "tres"]
## Groups that a node of a level may be in.
const GROUPS: PackedStringArray = ["props"]
## Where the vehicles are, and which a level may have: of each so many at most, with so many bodies.
const VEHICLE_FOLDER: String = "res://scenes/vehicle"
const VEHICLES: PackedStringArray = ["tank", "carrier", "truck", "scootmobile"]
const MAX_VEHICLES: int = 20
const VEHICLE_BODIES: int = 12
## Physics bodies of a level.
const MAX_BODIES: int = 8000

static var _rows: Dictionary[String, KitClass] = {}


static func _static_init() -> void:
	for rows: Array[KitClass] in [
		_kit_nodes(),
		_scenes(),
		_vehicles(),
		KitBlocks.rows(),
		KitMarks.rows(),
		EngineClasses.rows()
	]:
		for row: KitClass in rows:
			_add(row)


## The row of a node or resource of an engine class, or of one with a script; null if it has none.
static func find(p_base: String, p_script: String = "") -> KitClass:
	return _rows.get(p_base + p_script)


## Whether there is a row of an engine class, with or without a script.
static func knows(p_base: String) -> bool:
	return _rows.values().any(func(row: KitClass) -> bool: return row.base == p_base)


## The engine's classes that have rows.
static func bases() -> PackedStringArray:
	var found: Dictionary[String, bool] = {}
	for row: KitClass in _rows.values():
		if row.base != "":
			found[row.base] = true
	return PackedStringArray(found.keys())


## The row of a scene, or null.
static func find_scene(p_path: String) -> KitClass:
	return _rows.get(p_path)


## Whether a level may name a file of the program.
static func allows_file(p_type: String, p_path: String) -> bool:
	if p_type == "PackedScene":
		return find_scene(p_path) != null
	if p_type == "Script":
		return _rows.values().any(
			func(row: KitClass) -> bool: return row.path == p_path or row.root_script == p_path
		)
	if not (ASSET_TYPES.has(p_type) and ASSET_ENDINGS.has(p_path.get_extension())):
		return false
	if p_path.contains("..") or p_path.contains("::"):
		return false
	for folder: String in ASSET_FOLDERS:
		if p_path.begins_with(folder):
			return true
	return false


## Names of all rows, for people who ask what is allowed.
static func names() -> PackedStringArray:
	var found: PackedStringArray = []
	for row: KitClass in _rows.values():
		found.append(row.key)
	return found


# What the kit builds of: nodes with a script of ours.
static func _kit_nodes() -> Array[KitClass]:
	return [
		(
			KitClass
			. scripted(
				"Level",
				"Node3D",
				_path(Level),
				{
					"title": PropertyRule.text(),
					"static_root": PropertyRule.node(),
					"props_root": PropertyRule.node(),
					"default_avatar": PropertyRule.text(),
					"world": PropertyRule.node(["Entity"]),
					"spawnable": PropertyRule.resources(["PackedScene"], 64),
				}
			)
		),
		(
			KitClass
			. scripted(
				"Door",
				"RigidBody3D",
				_path(Door),
				{
					"size": PropertyRule.vector2(0.3, 5.0),
					"opens": PropertyRule.whole(0, Door.Way.BOTH),
					"right_hinge": PropertyRule.flag(),
					"widest": PropertyRule.number(10.0, Door.MAX_DEG),
					"ajar": PropertyRule.number(-Door.MAX_DEG, Door.MAX_DEG),
					"friction": PropertyRule.number(0.1, 10.0),
					"layer": PropertyRule.whole(0, SurfaceLayers.Layer.size() - 1),
					"tint": PropertyRule.whole(0, SurfaceTints.Tint.size() - 1),
					"angular_damp": PropertyRule.number(0.0, 10.0),
					"mass": PropertyRule.number(0.05, 5000.0),
				},
				KitClass.body_rules()
			)
			. with_bodies(1)
			. at_most(500)
		),
		(
			KitClass
			. scripted(
				"Terrain",
				"StaticBody3D",
				_path(Terrain),
				{
					"height_file": PropertyRule.file("height"),
					"material": PropertyRule.resource(["Material"]),
					"has_hills": PropertyRule.flag(),
					"has_walls": PropertyRule.flag(),
					"stones": PropertyRule.whole(0, 60),
					"bushes": PropertyRule.whole(0, 20),
				},
				KitClass.body_rules()
			)
			. with_bodies(1)
			. at_most(4)
		),
		(
			KitClass
			. scripted(
				"WorldLamp",
				"OmniLight3D",
				_path(WorldLamp),
				{
					"lit_energy": PropertyRule.number(0.0, 16.0),
					"flicker": PropertyRule.number(0.0, 0.8),
				},
				_lamp_rules()
			)
			. at_most(256)
		),
		(
			KitClass
			. scripted(
				"EffectEmitter",
				"Node3D",
				_path(EffectEmitter),
				{
					"effect": PropertyRule.text(EffectFile.MAX_NAME),
					"amount": PropertyRule.number(0.0, 1.0),
					"entity": PropertyRule.node(["Entity"]),
					"inputs": PropertyRule.text(EffectEmitter.MAX_INPUTS_TEXT),
					"plays_at": PropertyRule.text(),
				}
			)
			. at_most(100)
		),
	]


# Scenes of ours that a level may hold instances of.
static func _scenes() -> Array[KitClass]:
	return [
		_crate("res://scenes/world/props/crate_small.tscn"),
		_crate("res://scenes/world/props/crate.tscn"),
		_crate("res://scenes/world/props/crate_large.tscn"),
		(
			KitClass
			. scene(
				"res://scenes/world/sky/world_sky.tscn",
				{
					"time_of_day": PropertyRule.number(0.0, 24.0),
					"weather": PropertyRule.whole(0, WorldConditions.Weather.size() - 1),
					"weather_strength": PropertyRule.number(0.0, 1.0),
					"shadow_distance": PropertyRule.number(10.0, 300.0),
					"entity": PropertyRule.node(["Entity"]),
				}
			)
			. with_script(_path(WorldSky))
			. with_nodes({"World": "Entity"})
			. with_bodies(0)
			. at_most(1)
		),
		KitClass.scene("res://scenes/world/town/town_blocks.tscn", {}).with_bodies(1000).at_most(1),
		KitClass.scene("res://examples/01_door/door.tscn", {}).at_most(500),
		KitClass.scene("res://examples/02_turntable/turntable.tscn", {}).at_most(100),
	]


static func _vehicles() -> Array[KitClass]:
	var rows: Array[KitClass] = []
	for name: String in VEHICLES:
		var path: String = VEHICLE_FOLDER.path_join(name).path_join(name + ".tscn")
		rows.append(KitClass.scene(path, {}).with_bodies(VEHICLE_BODIES).at_most(MAX_VEHICLES))
	return rows


static func _crate(p_path: String) -> KitClass:
	return KitClass.scene(
		p_path,
		{"mass": PropertyRule.number(0.05, 5000.0), "continuous_cd": PropertyRule.flag()},
		KitClass.body_rules()
	)


static func _lamp_rules() -> Dictionary[String, PropertyRule]:
	var rules: Dictionary[String, PropertyRule] = EngineClasses.light_rules()
	rules.merge(EngineClasses.omni_rules())
	return rules


static func _path(p_class: GDScript) -> String:
	return p_class.resource_path


static func _add(p_row: KitClass) -> void:
	_rows[p_row.path if p_row.kind == KitClass.Kind.SCENE else p_row.base + p_row.path] = p_row

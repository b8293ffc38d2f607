@tool
class_name KitNodes
extends KitRows
## The rows of [LevelKit] for what levels are built of besides blocks: the level itself, doors,
## ground, lamps, effects, and scenes such as crates and the sky.


func rows() -> Array[KitClass]:
	return _kit_nodes() + _scenes()


func items() -> Array[KitItem]:
	var moves: int = KitItem.Place.PROPS
	var root: int = KitItem.Place.ROOT
	var crates: String = "res://scenes/world/props/crate"
	var terrain: String = _path(Terrain)
	return [
		KitItem.new("Terrain", "ground sand hills road", terrain, KitItem.Place.STATIC),
		KitItem.new("Crate", "box prop", crates + ".tscn", moves, {}, 0.25),
		KitItem.new("Small crate", "box prop", crates + "_small.tscn", moves, {}, 0.15),
		KitItem.new("Large crate", "box prop", crates + "_large.tscn", moves, {}, 0.4),
		KitItem.new("Door", "hinge swing push", _path(Door), moves),
		KitItem.new("Sliding door", "entity button", "res://examples/01_door/door.tscn", moves),
		KitItem.new("Turntable", "entity", "res://examples/02_turntable/turntable.tscn", moves),
		KitItem.new("World lamp", "light torch", _path(WorldLamp), root, {}, 2.2),
		KitItem.new("Effect", "particles smoke fire dust emitter", _path(EffectEmitter), root),
	]


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
					"effect": PropertyRule.text(EffectLimits.MAX_NAME),
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

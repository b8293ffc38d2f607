class_name KitBlocks
extends RefCounted
## The rows of [LevelKit] for the blocks of the kit.
##
## What a hint in the inspector limits has the same limits here; what is without one is named.

## Openings of a wall, gaps of a railing.
const MAX_OPENINGS: int = 64
## Where they may be, m.
const FARTHEST_OPENING: float = 250.0


## All of them.
static func rows() -> Array[KitClass]:
	return _plain() + _town() + _hall() + _stage()


static func _plain() -> Array[KitClass]:
	var material: PropertyRule = PropertyRule.resource(KitClass.MATERIALS)
	return [
		_block(
			"Block",
			Block,
			{"size": PropertyRule.vector3(0.01, 2000.0), "material": material},
			20000
		),
		_block("Stairs", Stairs, {"material": material}, 500),
		_block("House", House, {"size": PropertyRule.vector2(4.0, House.MAX_M)}, 150),
	]


static func _town() -> Array[KitClass]:
	var openings: PropertyRule = PropertyRule.rects(MAX_OPENINGS, FARTHEST_OPENING)
	var size: PropertyRule = PropertyRule.vector3(0.05, 100.0)
	return [
		_block("Wall", Wall, {"size": size, "openings": openings}, 3000),
		_block("Road", Road, _road(), 1000),
		_block("Gate", Gate, {}, 50),
		_block("Tower", Tower, {}, 50),
		_block("Stall", Stall, {}, 200),
		_block("StreetLamp", StreetLamp, {}, 256),
		_block("Palm", Palm, {}, 500),
		_block("Wire", Wire, {"end": PropertyRule.vector3(-60.0, 60.0)}, 500),
		_block("Barrels", Barrels, {}, 500),
		_block("Sandbags", Sandbags, {}, 500),
		_block("Rubble", Rubble, {}, 500),
	]


static func _road() -> Dictionary[String, PropertyRule]:
	var gaps: PropertyRule = PropertyRule.points2(MAX_OPENINGS, FARTHEST_OPENING)
	return {"size": PropertyRule.vector2(0.5, 200.0), "left_gaps": gaps, "right_gaps": gaps}


static func _hall() -> Array[KitClass]:
	var sides: Dictionary[String, PropertyRule] = {"size": PropertyRule.vector3(2.5, 200.0)}
	for side: String in ["south", "north", "east", "west"]:
		sides[side] = PropertyRule.rects(MAX_OPENINGS, FARTHEST_OPENING)
	var gallery: Dictionary[String, PropertyRule] = {
		"size": PropertyRule.vector3(0.5, 100.0),
		"front": PropertyRule.points2(MAX_OPENINGS, FARTHEST_OPENING),
	}
	return [
		_block("SteelHall", SteelHall, sides, 20),
		_block("Gallery", Gallery, gallery, 200),
		_block("SteelStairs", SteelStairs, {}, 200),
		_block("Ramp", Ramp, {"size": PropertyRule.vector3(0.05, 100.0)}, 500),
		_block("Ladder", Ladder, {}, 200),
		_block("PalletRack", PalletRack, {}, 300),
		_block("Pallets", Pallets, {}, 1000),
		_block("ShippingContainer", ShippingContainer, {}, 500),
		_block("SheetFence", SheetFence, {}, 500),
		_block("FloorMarking", FloorMarking, {"size": PropertyRule.vector2(0.05, 100.0)}, 1000),
		_block("CeilingLamp", CeilingLamp, {}, 256),
	]


static func _stage() -> Array[KitClass]:
	var podium: Dictionary[String, PropertyRule] = {"size": PropertyRule.vector3(0.2, 60.0)}
	var cloth: Dictionary[String, PropertyRule] = {"size": PropertyRule.vector2(0.2, 60.0)}
	var screen: Dictionary[String, PropertyRule] = {
		"camera": PropertyRule.node(["FilmCamera"]), "size": PropertyRule.vector2(0.2, 40.0)
	}
	var printed: Dictionary[String, PropertyRule] = {
		"picture": PropertyRule.resource(["Texture2D", "CompressedTexture2D"]),
		"size": PropertyRule.vector2(0.5, 60.0)
	}
	return [
		_block("StagePodium", StagePodium, podium, 20),
		_block("Curtain", Curtain, cloth, 100),
		_block("Backdrop", Backdrop, printed, 20),
		_block("CameraScreen", CameraScreen, screen, 4),
		_block("StageLight", StageLight, {"colour": PropertyRule.colour()}, 64),
		_block("Truss", Truss, {}, 200),
		_block("Loudspeakers", Loudspeakers, {}, 100),
		_block("SeatRow", SeatRow, {}, 200),
		_block("CrowdBarrier", CrowdBarrier, {}, 200),
		_block("MixingDesk", MixingDesk, {}, 50),
		_block("FlightCase", FlightCase, {"size": PropertyRule.vector3(0.3, 4.0)}, 500),
	]


static func _block(
	p_key: String, p_class: GDScript, p_named: Dictionary[String, PropertyRule], p_most: int
) -> KitClass:
	var rules: Dictionary[String, PropertyRule] = p_named.duplicate()
	for property: Dictionary in p_class.get_script_property_list():
		var is_export: bool = property["usage"] & PROPERTY_USAGE_EDITOR != 0
		var rule: PropertyRule = PropertyRule.from_hint(property) if is_export else null
		if rule != null and not rules.has(property["name"]):
			rules[property["name"]] = rule
	var path: String = p_class.resource_path
	var row: KitClass = KitClass.scripted(p_key, "StaticBody3D", path, rules, KitClass.body_rules())
	return row.with_bodies(1).at_most(p_most)

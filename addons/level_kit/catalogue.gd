@tool
extends RefCounted
## What the dock offers. A new thing is one row here.

const KitItem: GDScript = preload("kit_item.gd")
const _KIT: String = "res://scripts/world/kit/"
const _TOWN: String = "res://scripts/world/kit/town/"
const _PROPS: String = "res://scenes/world/props/"
const _HALL: String = "res://scripts/world/kit/hall/"
const _STAGE: String = "res://scripts/world/kit/stage/"
const _VEHICLES: String = "res://scenes/vehicle/"
const _EMITTER: String = "res://scripts/effects/effect_emitter.gd"
const _WORLD: String = "res://scripts/world/"


## All of it, in the order in which it is shown.
static func items() -> Array:
	return _building() + _street() + _hall() + _stage() + _moving() + _vehicles() + _marks()


static func _building() -> Array:
	var fixed: int = KitItem.Place.STATIC
	var block: String = _KIT + "block.gd"
	var wall: String = _TOWN + "wall.gd"
	var house: String = _KIT + "house/house.gd"
	var door: Array[Rect2] = [Rect2(1.5, 0.0, 1.0, 2.1)]
	var window: Array[Rect2] = [Rect2(1.4, 0.9, 1.2, 1.2)]
	return [
		KitItem.new(
			"Floor", "block ground plate", block, fixed, {&"size": Vector3(4, 0.2, 4)}, 0.1
		),
		KitItem.new("Block", "box cube", block, fixed, {}, 0.5),
		KitItem.new("Platform", "block step", block, fixed, {&"size": Vector3(2, 1, 2)}, 0.5),
		KitItem.new("Terrain", "ground sand hills road", _WORLD + "terrain/terrain.gd", fixed),
		KitItem.new("Wall", "fence", wall, fixed),
		KitItem.new("Wall with door", "opening", wall, fixed, {&"openings": door}),
		KitItem.new("Wall with window", "opening", wall, fixed, {&"openings": window}),
		KitItem.new("Low wall", "cover", wall, fixed, {&"size": Vector3(3, 1.1, 0.4)}),
		KitItem.new("Stairs", "steps", _KIT + "stairs.gd", fixed),
		KitItem.new("House", "building rooms", house, fixed, {&"size": Vector2(8.5, 10)}),
		KitItem.new(
			"Shop", "house building", house, fixed, {&"size": Vector2(8.5, 10), &"shop": true}
		),
		KitItem.new("Closed house", "building shut", house, fixed, {&"entered": false}),
		KitItem.new("Tower", "building", _TOWN + "tower.gd", fixed),
		KitItem.new("Gate", "arch", _TOWN + "gate.gd", fixed),
	]


static func _street() -> Array:
	var fixed: int = KitItem.Place.STATIC
	var crossing: Dictionary = {
		&"size": Vector2(6, 4), &"markings": Road.Markings.CROSSING, &"has_left_kerb": false
	}
	crossing[&"has_right_kerb"] = false
	var track: Dictionary = {&"surface": Road.Surface.DIRT, &"markings": Road.Markings.NONE}
	track.merge({&"has_left_kerb": false, &"has_right_kerb": false, &"size": Vector2(4, 8)})
	return [
		KitItem.new("Road", "street asphalt kerb way", _TOWN + "road.gd", fixed),
		KitItem.new("Road crossing", "zebra street way", _TOWN + "road.gd", fixed, crossing),
		KitItem.new("Dirt road", "track gravel way", _TOWN + "road.gd", fixed, track),
		KitItem.new("Stall", "market", _TOWN + "stall.gd", fixed),
		KitItem.new("Barrels", "drum", _TOWN + "barrels.gd", fixed),
		KitItem.new("Sandbags", "cover", _TOWN + "sandbags.gd", fixed),
		KitItem.new("Rubble", "stones", _TOWN + "rubble.gd", fixed),
		KitItem.new("Palm", "tree plant", _TOWN + "palm.gd", fixed),
		KitItem.new("Street lamp", "light", _TOWN + "street_lamp.gd", fixed),
		KitItem.new("Wire", "cable washing", _TOWN + "wire.gd", fixed, {}, 3.0),
	]


static func _hall() -> Array:
	var fixed: int = KitItem.Place.STATIC
	return [
		KitItem.new("Ramp", "slope", _HALL + "ramp.gd", fixed),
		KitItem.new("Ladder", "rungs", _HALL + "ladder.gd", fixed),
		KitItem.new("Container", "box goods", _HALL + "shipping_container.gd", fixed),
		KitItem.new("Pallet rack", "shelf goods", _HALL + "pallet_rack.gd", fixed),
		KitItem.new("Pallets", "goods", _HALL + "pallets.gd", fixed),
		KitItem.new("Gallery", "platform railing", _HALL + "gallery.gd", fixed),
		KitItem.new("Steel stairs", "steps", _HALL + "steel_stairs.gd", fixed),
		KitItem.new("Steel hall", "building hangar", _HALL + "steel_hall.gd", fixed),
		KitItem.new("Sheet fence", "wall", _HALL + "sheet_fence.gd", fixed),
		KitItem.new("Ceiling lamp", "light", _HALL + "ceiling_lamp.gd", fixed, {}, 4.0),
	]


static func _stage() -> Array:
	var fixed: int = KitItem.Place.STATIC
	return [
		KitItem.new("Stage", "podium platform", _STAGE + "stage_podium.gd", fixed),
		KitItem.new("Curtain", "cloth drape wing", _STAGE + "curtain.gd", fixed),
		KitItem.new("Backdrop", "cloth picture", _STAGE + "backdrop.gd", fixed),
		KitItem.new("Camera screen", "video wall", _STAGE + "camera_screen.gd", fixed, {}, 3.0),
		KitItem.new("Film camera", "screen view", _STAGE + "film_camera.gd", fixed, {}, 1.6),
		KitItem.new("Stage light", "spot beam lamp", _STAGE + "stage_light.gd", fixed, {}, 4.0),
		KitItem.new("Truss", "beam tower", _STAGE + "truss.gd", fixed, {}, 4.0),
		KitItem.new("Loudspeakers", "sound", _STAGE + "loudspeakers.gd", fixed, {}, 5.0),
		KitItem.new("Seats", "chair row audience", _STAGE + "seat_row.gd", fixed),
		KitItem.new("Crowd barrier", "fence railing", _STAGE + "crowd_barrier.gd", fixed),
		KitItem.new("Mixing desk", "table sound light", _STAGE + "mixing_desk.gd", fixed),
		KitItem.new("Flight case", "box", _STAGE + "flight_case.gd", fixed),
	]


static func _moving() -> Array:
	var moves: int = KitItem.Place.PROPS
	return [
		KitItem.new("Crate", "box prop", _PROPS + "crate.tscn", moves, {}, 0.25),
		KitItem.new("Small crate", "box prop", _PROPS + "crate_small.tscn", moves, {}, 0.15),
		KitItem.new("Large crate", "box prop", _PROPS + "crate_large.tscn", moves, {}, 0.4),
		KitItem.new("Door", "hinge swing push", _KIT + "door.gd", moves),
		KitItem.new("Sliding door", "entity button", "res://examples/01_door/door.tscn", moves),
		KitItem.new("Turntable", "entity", "res://examples/02_turntable/turntable.tscn", moves),
	]


static func _vehicles() -> Array:
	var moves: int = KitItem.Place.PROPS
	var tank: String = _VEHICLES + "tank/tank.tscn"
	var carrier: String = _VEHICLES + "carrier/carrier.tscn"
	var scoot: String = _VEHICLES + "scootmobile/scootmobile.tscn"
	return [
		KitItem.new("Battle tank", "vehicle tracks gun drive", tank, moves, {}, 0.1),
		KitItem.new("Carrier", "vehicle tracks drive", carrier, moves, {}, 0.1),
		KitItem.new(
			"Truck", "vehicle car wheels drive", _VEHICLES + "truck/truck.tscn", moves, {}, 0.1
		),
		KitItem.new("Scootmobile", "vehicle scooter wheels drive", scoot, moves, {}, 0.05),
	]


static func _marks() -> Array:
	var spawns: int = KitItem.Place.SPAWNS
	var root: int = KitItem.Place.ROOT
	return [
		KitItem.new("Spawn point", "start person", _WORLD + "spawn_point.gd", spawns),
		KitItem.new("Trigger zone", "area event mark", _WORLD + "trigger_zone.gd", root),
		KitItem.new("Waypoint path", "points way route", _WORLD + "waypoint_path.gd", root),
		KitItem.new("Observer view", "camera", _WORLD + "observer_camera.gd", root, {}, 2.5),
		KitItem.new("World lamp", "light torch", _WORLD + "sky/world_lamp.gd", root, {}, 2.2),
		KitItem.new("Effect", "particles smoke fire dust emitter", _EMITTER, root),
	]

extends SceneTree
## Lays out the world [code]town[/code] of blocks of the level kit and saves it:
## [code]godot --headless --path . -s tools/assets/worlds/build_town.gd[/code]. Then bake it:
## [code]./run level bake town[/code].
##
## Two scenes: [code]town_blocks.tscn[/code] with the blocks, which the desert has at its edge too,
## and [code]town.tscn[/code], the level.

const FOLDER: String = "res://scenes/world/town"
const Scenes: GDScript = preload("res://tools/assets/worlds/world_scenes.gd")
const Plan: GDScript = preload("res://tools/assets/worlds/town_plan.gd")
## Vehicles to drive, at the gate and behind it, m.
const VEHICLES: Dictionary[String, Vector3] = {
	"truck": Vector3(3.5, 0.1, 54.0),
	"scootmobile": Vector3(-3.4, 0.05, 37.0),
}


func _initialize() -> void:
	_build.call_deferred()


func _build() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)
	var plan: RefCounted = Plan.new()
	var blocks: Node3D = plan.call(&"lay_out")
	var blocks_path: String = FOLDER.path_join("town_blocks.tscn")
	if not Scenes.save(blocks, blocks_path):
		quit(1)
		return
	var level: Level = _level(load(blocks_path), plan)
	if not Scenes.save(level, FOLDER.path_join("town.tscn")):
		quit(1)
		return
	print("%d houses, %d of them entered" % [plan.get(&"houses"), plan.get(&"entered")])
	blocks.free()
	level.free()
	quit()


func _level(p_blocks: PackedScene, p_plan: RefCounted) -> Level:
	var level: Level = Level.new()
	level.name = "Town"
	level.title = "Desert town"
	level.static_root = Scenes.branch(level, "Static")
	level.static_root.add_child(p_blocks.instantiate())
	level.props_root = Scenes.branch(level, "Props")
	var spawns: Node3D = Scenes.branch(level, "Spawns")
	for place: Transform3D in p_plan.get(&"starts"):
		var point: SpawnPoint = SpawnPoint.new()
		point.name = "Spawn%d" % (spawns.get_child_count() + 1)
		point.transform = place
		spawns.add_child(point)
	var crate: PackedScene = load("res://scenes/world/props/crate.tscn")
	for place: Vector3 in p_plan.get(&"crates"):
		var prop: Node3D = crate.instantiate()
		prop.name = "Crate%d" % (level.props_root.get_child_count() + 1)
		prop.position = place
		level.props_root.add_child(prop)
	for name: String in VEHICLES:
		var path: String = "res://scenes/vehicle/%s/%s.tscn" % [name, name]
		var vehicle: Node3D = (load(path) as PackedScene).instantiate()
		vehicle.position = VEHICLES[name]
		level.props_root.add_child(vehicle)
	var sky: Node = (load("res://scenes/world/sky/world_sky.tscn") as PackedScene).instantiate()
	level.add_child(sky)
	level.world = sky.get_node(^"World")
	return level

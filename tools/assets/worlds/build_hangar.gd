extends SceneTree
## Lays out the world [code]hangar[/code] of blocks of the level kit and saves it:
## [code]godot --headless --path . -s tools/assets/worlds/build_hangar.gd[/code]. Then bake it:
## [code]./run level bake hangar[/code].

const FOLDER: String = "res://scenes/world/hangar"
const Scenes: GDScript = preload("res://tools/assets/worlds/world_scenes.gd")
const Plan: GDScript = preload("res://tools/assets/worlds/hangar_plan.gd")
const EDGES: Dictionary[String, float] = {"crate_small": 0.3, "crate": 0.5, "crate_large": 0.8}


func _initialize() -> void:
	_build.call_deferred()


func _build() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)
	var plan: RefCounted = Plan.new()
	var level: Level = Level.new()
	level.name = "Hangar"
	level.title = "Hangar"
	level.static_root = plan.call(&"lay_out")
	level.static_root.name = "Static"
	level.add_child(level.static_root)
	level.props_root = Scenes.branch(level, "Props")
	_add_crates(level, plan.get(&"crates"))
	var spawns: Node3D = Scenes.branch(level, "Spawns")
	for number: int in 9:
		var point: SpawnPoint = SpawnPoint.new()
		point.name = "Spawn%d" % (number + 1)
		# The first has crates in his way: what ./run shows. The others have the free middle.
		point.position = Plan.START
		if number > 0:
			point.position = Vector3(-4.5 + 3.0 * ((number - 1) % 4), 0.0, 3.0 * ((number - 1) / 4))
		spawns.add_child(point)
	var sky: Node = (load("res://scenes/world/sky/world_sky.tscn") as PackedScene).instantiate()
	level.add_child(sky)
	level.world = sky.get_node(^"World")
	if not Scenes.save(level, FOLDER.path_join("hangar.tscn")):
		quit(1)
		return
	print("%d blocks" % level.static_root.get_child_count())
	level.free()
	quit()


func _add_crates(p_level: Level, p_crates: Array[Array]) -> void:
	for row: Array in p_crates:
		var scene: PackedScene = load("res://scenes/world/props/%s.tscn" % row[0])
		var prop: Node3D = scene.instantiate()
		prop.name = "Crate%d" % (p_level.props_root.get_child_count() + 1)
		var up: Vector3 = Vector3.UP * EDGES[row[0]] / 2.0
		prop.position = (row[1] as Vector3) + up
		prop.rotation.y = deg_to_rad(row[2])
		p_level.props_root.add_child(prop)

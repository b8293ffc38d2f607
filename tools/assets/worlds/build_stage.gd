extends SceneTree
## Lays out the world [code]stage[/code] of blocks of the level kit and saves it:
## [code]godot --headless --path . -s tools/assets/worlds/build_stage.gd[/code]. Then bake it:
## [code]./run level bake stage[/code].

const FOLDER: String = "res://scenes/world/stage"
const Scenes: GDScript = preload("res://tools/assets/worlds/world_scenes.gd")
const Plan: GDScript = preload("res://tools/assets/worlds/stage_plan.gd")


func _initialize() -> void:
	_build.call_deferred()


func _build() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)
	var plan: RefCounted = Plan.new()
	var level: Level = Level.new()
	level.name = "Stage"
	level.title = "Stage"
	level.default_avatar = "show"
	level.static_root = plan.call(&"lay_out")
	level.static_root.name = "Static"
	level.add_child(level.static_root)
	level.props_root = Scenes.branch(level, "Props")
	for place: Transform3D in plan.get(&"crates"):
		var scene: PackedScene = load("res://scenes/world/props/crate.tscn")
		var crate: Node3D = scene.instantiate()
		crate.name = "Crate%d" % (level.props_root.get_child_count() + 1)
		crate.transform = place
		level.props_root.add_child(crate)
	var spawns: Node3D = Scenes.branch(level, "Spawns")
	for place: Transform3D in plan.get(&"starts"):
		var point: SpawnPoint = SpawnPoint.new()
		point.name = "Spawn%d" % (spawns.get_child_count() + 1)
		point.transform = place
		spawns.add_child(point)
	var views: Node3D = Scenes.branch(level, "Views")
	var places: Dictionary[String, Transform3D] = plan.get(&"views")
	for title: String in places:
		var view: ObserverCamera = ObserverCamera.new()
		view.name = title
		view.transform = places[title]
		view.fov = 60.0
		views.add_child(view)
	var sky: Node = (load("res://scenes/world/sky/world_sky.tscn") as PackedScene).instantiate()
	sky.set(&"time_of_day", 19.0)
	level.add_child(sky)
	level.world = sky.get_node(^"World")
	if not Scenes.save(level, FOLDER.path_join("stage.tscn")):
		quit(1)
		return
	print("%d nodes" % level.static_root.get_child_count())
	level.free()
	quit()

@tool
extends RefCounted
## Makes new levels: ground, sky, spawn points.

const SKY_PATH: String = "res://scenes/world/sky/world_sky.tscn"
## Height of the ground's block, m.
const GROUND_M: float = 1.0
## Distance of spawn points, m.
const APART_M: float = 2.5

## What people call it.
var title: String = "New level"
## Edge of its ground, m.
var size: float = 40.0
## What the ground is made of.
var surface: SurfaceLayers.Layer = SurfaceLayers.Layer.CONCRETE
## How many people start apart from one another.
var spawn_points: int = 4
## Time of day, hours.
var time_of_day: float = 10.0


## Why a level cannot get a name; empty if it can.
static func find_fault(p_name: String) -> String:
	if not LevelStore.is_name(p_name):
		return "Use lower-case letters, digits and underscores, a letter first."
	if FileAccess.file_exists(LevelStore.path_of(p_name)):
		return "There is a level '%s' already." % p_name
	return ""


## The level, outside the tree.
func make() -> Level:
	var level: Level = Level.new()
	level.name = title.to_pascal_case()
	level.title = title
	level.static_root = _add(level, level, Node3D.new(), "Static")
	level.props_root = _add(level, level, Node3D.new(), "Props")
	var spawns: Node3D = _add(level, level, Node3D.new(), "Spawns")
	var ground: Block = Block.new()
	ground.size = Vector3(size, GROUND_M, size)
	ground.surface = surface
	ground.position.y = -GROUND_M / 2.0
	_add(level, level.static_root, ground, "Ground")
	for index: int in spawn_points:
		var point: SpawnPoint = SpawnPoint.new()
		point.position.x = (index - (spawn_points - 1) / 2.0) * APART_M
		_add(level, spawns, point, "Spawn%d" % (index + 1))
	var scene: PackedScene = load(SKY_PATH)
	var sky: WorldSky = scene.instantiate(PackedScene.GEN_EDIT_STATE_INSTANCE)
	sky.time_of_day = time_of_day
	_add(level, level, sky, "Sky")
	level.world = sky.get_node(^"World")
	return level


## Writes the level to a scene. Returns what went wrong, or OK.
func save(p_path: String) -> Error:
	DirAccess.make_dir_recursive_absolute(p_path.get_base_dir())
	var level: Level = make()
	var scene: PackedScene = PackedScene.new()
	var error: Error = scene.pack(level)
	level.free()
	return error if error != OK else ResourceSaver.save(scene, p_path)


static func _add(p_level: Level, p_parent: Node, p_node: Node3D, p_name: String) -> Node3D:
	p_node.name = p_name
	p_parent.add_child(p_node)
	p_node.owner = p_level
	return p_node

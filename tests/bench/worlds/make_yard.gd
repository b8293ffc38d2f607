extends SceneTree
## Saves a level such as docs/tutorial.md makes, a house and a yard with crates, as the world that
## the first argument names.

const LevelTemplate: GDScript = preload("res://addons/level_kit/level_template.gd")
const CRATE: PackedScene = preload("res://scenes/world/props/crate.tscn")
## Edge of the yard and where it begins, m.
const EDGE_M: float = 8.0
const BEGIN: Vector3 = Vector3(6.0, 0.0, 4.0)
const WALL_M: float = 4.0


func _initialize() -> void:
	var name: String = OS.get_cmdline_user_args()[0]
	var path: String = LevelStore.path_of(name)
	DirAccess.make_dir_recursive_absolute(path.get_base_dir())
	var template: RefCounted = LevelTemplate.new()
	template.set(&"title", name)
	var level: Level = template.call(&"make")
	_add(level, level.static_root, House.new(), Vector3(-4.25, 0.0, -5.0))
	for index: int in 4:
		var shift: float = index % 2 * WALL_M
		var is_far: float = index / 2 * EDGE_M
		_add(level, level.static_root, Wall.new(), BEGIN + Vector3(shift, 0.0, -is_far))
		var wall: Node3D = Wall.new()
		wall.rotation.y = PI / 2.0
		_add(level, level.static_root, wall, BEGIN + Vector3(is_far, 0.0, -shift))
	for index: int in 3:
		_add(level, level.props_root, CRATE.instantiate(), Vector3(9.0 + index, 0.25, 0.0))
	var scene: PackedScene = PackedScene.new()
	var error: Error = scene.pack(level)
	level.free()
	quit(0 if error == OK and ResourceSaver.save(scene, path) == OK else 1)


static func _add(p_level: Level, p_parent: Node, p_node: Node3D, p_at: Vector3) -> void:
	p_parent.add_child(p_node, true)
	p_node.owner = p_level
	p_node.position = p_at

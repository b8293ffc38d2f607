extends SceneTree
## Saves a level with many fountains as the world that the first argument names: the second is how
## many.

const LevelTemplate: GDScript = preload("res://addons/level_kit/level_template.gd")
## Between two fountains, m.
const APART_M: float = 2.5


func _initialize() -> void:
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	var path: String = LevelStore.path_of(arguments[0])
	DirAccess.make_dir_recursive_absolute(path.get_base_dir())
	var template: RefCounted = LevelTemplate.new()
	template.set(&"title", arguments[0])
	var level: Level = template.call(&"make")
	var side: int = ceili(sqrt(arguments[1].to_float()))
	for index: int in arguments[1].to_int():
		var emitter: EffectEmitter = EffectEmitter.new()
		emitter.effect = "fountain"
		level.props_root.add_child(emitter, true)
		emitter.owner = level
		var row: Vector2 = Vector2(index % side, index / side) - Vector2.ONE * side * 0.5
		emitter.position = Vector3(row.x, 0.0, row.y) * APART_M
	var scene: PackedScene = PackedScene.new()
	var error: Error = scene.pack(level)
	level.free()
	quit(0 if error == OK and ResourceSaver.save(scene, path) == OK else 1)

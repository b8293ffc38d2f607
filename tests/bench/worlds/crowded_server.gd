extends SceneTree
## A server whose world has many crates more: what it is started with after [code]--[/code] are the
## options of a server, and --crates=N. [code]./run bench worlds[/code] starts it.

const CRATE: PackedScene = preload("res://scenes/world/props/crate.tscn")
## Distance of the crates, m, and how many lie beside one another.
const APART_M: float = 1.1
const ROW: int = 10


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	var arguments: PackedStringArray = []
	var crates: int = 0
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with("--crates="):
			crates = argument.get_slice("=", 1).to_int()
		else:
			arguments.append(argument)
	var options: Options = ProgramOptions.parse(arguments, ProgramRoles.SERVER)
	if options.error != "":
		printerr(options.error)
		quit(2)
		return
	_crowd(options.text("world"), crates)
	var server: Node = (load("res://scenes/server/server.tscn") as PackedScene).instantiate()
	server.call("configure", ProgramRoles.SERVER, options)
	root.add_child(server)


## Replaces the scene of a world, in this process, by one with more crates around its spawn points.
func _crowd(p_world: String, p_crates: int) -> void:
	var level: Level = LevelStore.instantiate(p_world)
	var spawns: Array[SpawnPoint] = level.get_spawn_points()
	for number: int in p_crates:
		var crate: RigidBody3D = CRATE.instantiate()
		var spawn: SpawnPoint = spawns[number % spawns.size()]
		var place: int = number / spawns.size()
		var beside: Vector3 = Vector3(place % ROW - ROW / 2, 0.0, 2.0 + place / ROW) * APART_M
		crate.position = spawn.position + beside + Vector3.UP * 0.3
		crate.name = "BenchCrate%d" % number
		level.props_root.add_child(crate)
		crate.owner = level
	var scene: PackedScene = PackedScene.new()
	scene.pack(level)
	scene.take_over_path(LevelStore.path_of(p_world))
	level.free()
	# The cache forgets what nobody holds.
	set_meta(&"scene", scene)

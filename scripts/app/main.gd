extends Node
## Starts the role that the options name: the exported dedicated server is a server by itself, every
## other build an observer unless told otherwise.
##
## Exit codes: 0 done, 1 failed, 2 wrong options, 3 refused by the server, 4 no server.

const _ROLES: PackedStringArray = ["server", "trainee", "observer", "instructor", "replay", "load"]
const _SERVER: String = "res://scenes/server/server.tscn"
const _CLIENT: String = "res://scenes/client/client.tscn"
const _LOAD: String = "res://scenes/load/load.tscn"


func _ready() -> void:
	get_tree().auto_accept_quit = true
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	if arguments.has("--help"):
		print("Options of Dismount (after --):\n" + ProgramOptions.describe())
		get_tree().quit(0)
		return
	var options: Options = ProgramOptions.parse(arguments)
	var role: String = options.text("role")
	if role == "":
		role = "server" if OS.has_feature("dedicated_server") else "observer"
	if options.error == "" and not role in _ROLES:
		options.error = "there is no role '%s'" % role
	if options.error != "":
		Log.error("app", options.error + " (--help lists all options)")
		get_tree().quit(2)
		return
	var version: String = ProjectSettings.get_setting("application/config/version")
	Log.info("app", "Dismount %s, %s" % [version, role])
	_start(role, options)


func _start(p_role: String, p_options: Options) -> void:
	var paths: Dictionary[String, String] = {"server": _SERVER, "load": _LOAD}
	var path: String = paths.get(p_role, _CLIENT)
	var scene: Node = (load(path) as PackedScene).instantiate()
	scene.call("configure", p_role, p_options)
	add_child(scene)

extends Node
## Starts the role that the options name, see [ProgramRoles].
##
## Exit codes: 0 done, 1 failed, 2 wrong options, 3 refused by the server, 4 no server.

## Prints the text of docs/options.md, for the gate that compares it.
const _DOCUMENT: String = "--help=document"


func _ready() -> void:
	get_tree().auto_accept_quit = true
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	var role: String = ProgramRoles.find_in(arguments)
	if arguments.has("--help") or arguments.has(_DOCUMENT):
		var is_named: bool = "--role" in " ".join(arguments)
		var text: String = OptionsHelp.describe(role if is_named else "")
		print(OptionsHelp.document() if arguments.has(_DOCUMENT) else text)
		get_tree().quit(0)
		return
	var options: Options = ProgramOptions.parse(arguments, role)
	if not ProgramRoles.names().has(role):
		options = ProgramOptions.parse(["--role=" + role])
	if options.error != "":
		Log.error("app", options.error + " (--help lists all options)")
		get_tree().quit(2)
		return
	var version: String = ProjectSettings.get_setting("application/config/version")
	Log.info("app", "Dismount %s, %s" % [version, role])
	var scene: Node = (load(ProgramRoles.scene_of(role)) as PackedScene).instantiate()
	scene.call("configure", role, options)
	add_child(scene)

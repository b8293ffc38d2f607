extends Node
## Starts the role that the options name, see [ProgramRoles]; the start screen is a [ShellFlow].
##
## Exit codes: 0 done, 1 failed, 2 wrong options, 3 refused by the server, 4 no server.

const _SCENES: Dictionary[String, String] = {
	ProgramRoles.SERVER: "res://scenes/server/server.tscn",
	ProgramRoles.LOAD: "res://scenes/load/load.tscn",
	ProgramRoles.START: "res://scenes/app/shell/shell_flow.tscn",
}
const _CLIENT: String = "res://scenes/client/client.tscn"
## Prints the text of docs/options.md, for the gate that compares it.
const _DOCUMENT: String = "--help=document"
## Prints what --help prints of each role, for the same gate.
const _ROLES: String = "--help=roles"


func _ready() -> void:
	EngineErrors.leave_out_harmless()
	get_tree().auto_accept_quit = true
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	if EditorSession.is_wanted(arguments):
		arguments = EditorSession.begin()
	var role: String = ProgramRoles.find_in(arguments)
	var version: String = ProjectSettings.get_setting("application/config/version")
	var answer: String = _answer(arguments, role, version)
	if answer != "":
		print(answer)
		get_tree().quit(0)
		return
	var options: Options = ProgramOptions.parse(arguments, role)
	if not ProgramRoles.names().has(role):
		options = ProgramOptions.parse(["--role=" + role])
	if options.error == "":
		options.refuse(Log.open(options.text("log-level"), options.file("log-file")))
	if options.error != "":
		Log.error("app", options.error + " (--help lists all options)")
		get_tree().quit(2)
		return
	Log.info("app", "Dismount %s, %s" % [version, role])
	_begin(role, options)


func _begin(p_role: String, p_options: Options) -> void:
	var path: String = _SCENES.get(p_role, _CLIENT)
	var program: Node = (load(path) as PackedScene).instantiate()
	match p_role:
		ProgramRoles.SERVER:
			program.call("configure", p_options, ProgramParts.SERVER)
		ProgramRoles.LOAD, ProgramRoles.START:
			program.call("configure", p_options)
		_:
			program.call("configure", p_role, p_options, ProgramParts.of_client(p_role))
	program.connect("left", _on_left.bind(program))
	add_child(program)


func _on_left(p_exit_code: int, p_program: Node) -> void:
	await MixerRelease.release(p_program)
	get_tree().quit(p_exit_code)


## What arguments ask for that starts nothing; empty if they ask for nothing like that.
func _answer(p_arguments: PackedStringArray, p_role: String, p_version: String) -> String:
	if p_arguments.has("--version"):
		return "Dismount " + p_version
	if p_arguments.has(_DOCUMENT):
		return OptionsHelp.document()
	if p_arguments.has(_ROLES):
		return OptionsHelp.all_roles()
	if p_arguments.has("--help") or p_arguments.has("-h"):
		return OptionsHelp.describe(p_role if "--role" in " ".join(p_arguments) else "")
	return ""

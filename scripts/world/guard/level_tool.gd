extends SceneTree
## What [code]./run level VERB[/code] does with levels. Each verb is a row of [constant VERBS] and a
## method of the same name that returns the exit code.
##
## [codeblock lang=text]
## godot --headless --path . -s scripts/world/guard/level_tool.gd -- VERB NAME [--out=DIR]
## [/codeblock]
## Exit code 0; 1 if the level is not fit; 2 with one line on the error output if the call is wrong.

## What it can do: verb, what it is for.
const VERBS: Dictionary[String, String] = {
	"bake": "works out the light of a level and what can be seen from where",
	"check": "looks for what is wrong in a level and says how to set it right",
	"pack": "makes a folder of a level that a server can offer, if all in it may be sent",
	"verify": "says whether a folder that was made by pack can be used",
}
## Exit code where the level is not fit.
const EXIT_UNFIT: int = 1
## Exit code for a wrong call.
const EXIT_USAGE: int = 2

var _words: PackedStringArray = []
var _out: String = "levels"


func _initialize() -> void:
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with("--out="):
			_out = argument.get_slice("=", 1)
		else:
			_words.append(argument)
	if _words.size() != 2 or not VERBS.has(_words[0]):
		printerr("usage: level %s NAME [--out=DIR]" % "|".join(VERBS.keys()))
		quit(EXIT_USAGE)
		return
	_run.call_deferred()


# The tree takes no nodes before its first frame.
func _run() -> void:
	quit(await call("_" + _words[0], _words[1]))


## Works out what is kept beside a level of the program.
func _bake(p_name: String) -> int:
	var level: Level = LevelStore.instantiate(p_name)
	if level == null:
		printerr(LevelStore.describe_missing(p_name))
		return EXIT_USAGE
	root.add_child(level)
	var begin: int = Time.get_ticks_msec()
	var baker: LevelBaker = LevelBaker.new()
	baker.prepare(level)
	baker.run()
	var path: String = Level.bake_path_of(LevelStore.path_of(p_name))
	var fault: Error = baker.bake.save_file(path)
	if fault != OK:
		printerr("%s: %s" % [path, error_string(fault)])
		return EXIT_UNFIT
	var seconds: float = (Time.get_ticks_msec() - begin) / 1000.0
	print("%s: %s, %.1f s" % [path, baker.bake.describe(), seconds])
	level.free()
	return 0


## Says what is wrong in a level of the program.
func _check(p_name: String) -> int:
	var level: Level = LevelStore.instantiate(p_name)
	if level == null:
		printerr(LevelStore.describe_missing(p_name))
		return EXIT_USAGE
	root.add_child(level)
	# Until then the engine does not know its bodies.
	await physics_frame
	await physics_frame
	var begin: int = Time.get_ticks_msec()
	var check: LevelCheck = LevelCheck.new(level)
	check.run()
	for fault: LevelFault in check.faults:
		print(fault.describe())
	var parts: Array = [p_name, check.count_faults(), check.faults.size() - check.count_faults()]
	parts.append((Time.get_ticks_msec() - begin) / 1000.0)
	print("%s: %d faults, %d hints, %.1f s" % parts)
	level.free()
	return EXIT_UNFIT if check.count_faults() > 0 else 0


## Makes the folder of a level of the program, or of a folder with a scene of its name.
func _pack(p_name: String) -> int:
	var name: String = p_name.get_file()
	var from: String = p_name
	if LevelStore.has(p_name):
		from = LevelStore.path_of(p_name).get_base_dir()
	elif not LevelStore.is_name(name):
		printerr("%s is no name of a level: lower-case letters, digits and underscores" % name)
		return EXIT_USAGE
	elif not FileAccess.file_exists(from.path_join(name + ".tscn")):
		printerr(LevelStore.describe_missing(p_name))
		return EXIT_USAGE
	var archive: LevelArchive = LevelArchive.new()
	if archive.pack(name, from, _out):
		var parts: Array = [_out.path_join(name), archive.manifest.files.size()]
		parts.append(archive.manifest.total_size() / 1048576.0)
		print("%s: %d files, %.1f MB, " % parts + archive.manifest.content_hash())
		return 0
	printerr("world '%s' cannot be sent:" % name)
	for fault: String in archive.faults:
		printerr("  " + fault)
	return EXIT_UNFIT


## Says whether a folder can be used.
func _verify(p_path: String) -> int:
	var folder: LevelFolder = LevelFolder.new(p_path)
	var level: Level = folder.build()
	if level == null:
		printerr("%s: %s" % [p_path, folder.error])
		return EXIT_UNFIT
	level.free()
	var parts: Array = [p_path, folder.manifest.title, folder.manifest.content_hash()]
	print("%s: '%s' can be used, %s" % parts)
	return 0

class_name ProgramPaths
extends RefCounted
## Where the other programs of Dismount are: the dedicated server, and the command
## [code]./run[/code] of a checkout, which has the editor and the studio.

## Environment variable with the path of [code]./run[/code], set by it.
const RUN: String = "DISMOUNT_RUN"
const _SERVER: String = "dismount-server.x86_64"
const _FLAGS: PackedStringArray = ["--headless", "--no-header"]


## The command that starts a dedicated server, without options of ours: the exported server where it
## lies beside this program or in the folder that [code]./run export[/code] makes, else this very
## program without a window.
static func server() -> PackedStringArray:
	var program: String = OS.get_executable_path()
	var folder: String = program.get_base_dir()
	if OS.has_feature("template"):
		for place: String in [folder, folder.path_join("../server").simplify_path()]:
			var found: String = place.path_join(_SERVER)
			if FileAccess.file_exists(found):
				return PackedStringArray([found]) + _FLAGS
		return PackedStringArray([program]) + _FLAGS
	var project: String = ProjectSettings.globalize_path("res://")
	return PackedStringArray([program]) + _FLAGS + PackedStringArray(["--path", project])


## The command that starts another client of this program without a window.
static func client() -> PackedStringArray:
	var command: PackedStringArray = PackedStringArray([OS.get_executable_path()]) + _FLAGS
	if not OS.has_feature("template"):
		command += PackedStringArray(["--path", ProjectSettings.globalize_path("res://")])
	return command


## Path of [code]./run[/code]; empty where the program was not started by it.
static func run() -> String:
	var path: String = OS.get_environment(RUN)
	return path if path != "" and FileAccess.file_exists(path) else ""

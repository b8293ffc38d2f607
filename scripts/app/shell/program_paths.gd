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
	var folder: String = OS.get_executable_path().get_base_dir()
	if OS.has_feature("template"):
		for place: String in [folder, folder.path_join("../server").simplify_path()]:
			var found: String = place.path_join(_SERVER)
			if FileAccess.file_exists(found):
				return PackedStringArray([found]) + _FLAGS
	return client()


## The command that starts this program once more, without a window and without options of ours.
static func client() -> PackedStringArray:
	var command: PackedStringArray = HmdCommand.of_this_process().program() + _FLAGS
	if not OS.has_feature("template"):
		command += PackedStringArray(["--path", ProjectSettings.globalize_path("res://")])
	return command


## Path of [code]./run[/code]; empty where the program was not started by it.
static func run() -> String:
	var path: String = OS.get_environment(RUN)
	return path if path != "" and FileAccess.file_exists(path) else ""

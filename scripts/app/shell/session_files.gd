class_name SessionFiles
extends RefCounted
## The recordings that the program keeps for its user, in a folder of its own.

## The folder.
const FOLDER: String = "user://recordings"
## How recordings end.
const EXTENSION: String = "dismount"


## Path of a recording that does not exist yet, named after a world and the moment; its folder is
## made.
static func new_recording(p_world: String) -> String:
	var folder: String = ProjectSettings.globalize_path(FOLDER)
	DirAccess.make_dir_recursive_absolute(folder)
	var moment: String = Time.get_datetime_string_from_system().replace(":", "-").replace("T", "_")
	var stem: String = folder.path_join("%s_%s" % [moment, p_world])
	var path: String = "%s.%s" % [stem, EXTENSION]
	var number: int = 2
	while FileAccess.file_exists(path):
		path = "%s_%d.%s" % [stem, number, EXTENSION]
		number += 1
	return path


## Full paths of all recordings in the folder, the newest first.
static func recordings() -> PackedStringArray:
	var folder: String = ProjectSettings.globalize_path(FOLDER)
	var found: PackedStringArray = []
	if not DirAccess.dir_exists_absolute(folder):
		return found
	for file: String in DirAccess.get_files_at(folder):
		if file.get_extension() == EXTENSION:
			found.append(folder.path_join(file))
	found.sort()
	found.reverse()
	return found

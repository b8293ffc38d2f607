class_name LevelShare
extends RefCounted
## The folders of levels that a server offers beside the program's own: each with the name of its
## level, on a disk or on a share of the network.

## Path of the folder that holds them; empty for none.
var root: String = ""


func _init(p_root: String) -> void:
	root = p_root


## Names of the levels that are there, in the order of the alphabet. Whether they can be used is
## found when one is loaded.
func names() -> PackedStringArray:
	var found: PackedStringArray = []
	if root == "" or not DirAccess.dir_exists_absolute(root):
		return found
	for name: String in DirAccess.get_directories_at(root):
		if has(name):
			found.append(name)
	found.sort()
	return found


## Whether there is a folder of a level of a name.
func has(p_name: String) -> bool:
	if root == "" or not LevelStore.is_name(p_name):
		return false
	return FileAccess.file_exists(folder_of(p_name).path_join(LevelManifest.FILE))


## The folder of a level.
func folder_of(p_name: String) -> String:
	return root.path_join(p_name)


## What is wrong with the share itself, or an empty text.
func find_fault() -> String:
	if root == "" or DirAccess.dir_exists_absolute(root):
		return ""
	return "there is no folder %s: --levels names one with folders of levels" % root

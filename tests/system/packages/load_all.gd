extends SceneTree
## Loads every script and scene of the addons, as the export of a game would, and says how many.


func _initialize() -> void:
	print("loaded %d" % _load_below("res://addons"))
	quit()


func _load_below(p_folder: String) -> int:
	var count: int = 0
	for file: String in DirAccess.get_files_at(p_folder):
		if file.get_extension() in ["gd", "tscn"]:
			count += 1 if load(p_folder.path_join(file)) != null else 0
	for folder: String in DirAccess.get_directories_at(p_folder):
		count += _load_below(p_folder.path_join(folder))
	return count

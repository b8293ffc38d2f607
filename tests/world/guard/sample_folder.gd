class_name SampleFolder
extends RefCounted
## Makes folders of levels for tests, below a folder that is taken away again.

## The folder of all.
const ROOT: String = "user://sample_levels"


## Makes the folder of a sound level with a file of so many further bytes; returns its path.
static func make(p_name: String = "range", p_bytes: int = 0) -> String:
	var source: String = ROOT.path_join("source/" + p_name)
	DirAccess.make_dir_recursive_absolute(source)
	store(source.path_join(p_name + ".tscn"), LevelTexts.level().to_utf8_buffer())
	if p_bytes > 0:
		var bytes: PackedByteArray = []
		bytes.resize(p_bytes)
		for index: int in range(0, p_bytes, 997):
			bytes[index] = index % 251
		store(source.path_join(p_name + ".bake"), bytes)
	var archive: LevelArchive = LevelArchive.new()
	if not archive.pack(p_name, source, ROOT.path_join("share")):
		return ""
	return ROOT.path_join("share/" + p_name)


## Writes a file.
static func store(p_path: String, p_bytes: PackedByteArray) -> void:
	var file: FileAccess = FileAccess.open(p_path, FileAccess.WRITE)
	file.store_buffer(p_bytes)


## A manifest as it lies in a folder, with some of its text replaced.
static func edit_manifest(p_folder: String, p_what: String, p_with: String) -> void:
	var path: String = p_folder.path_join(LevelManifest.FILE)
	var text: String = FileAccess.get_file_as_string(path).replace(p_what, p_with)
	store(path, text.to_utf8_buffer())


## Takes everything away.
static func clean_up(p_folder: String = ROOT) -> void:
	# While the engine ends, the user's folder is not known any more and the project's stands for it.
	var is_ours: bool = ProjectSettings.globalize_path(p_folder).contains("/" + ROOT.get_file())
	if not is_ours or not DirAccess.dir_exists_absolute(p_folder):
		return
	if FileAccess.file_exists(p_folder.path_join("project.godot")):
		return
	var folder: DirAccess = DirAccess.open(p_folder)
	for name: String in folder.get_directories():
		if folder.is_link(name):
			folder.remove(name)
		else:
			clean_up(p_folder.path_join(name))
	for name: String in folder.get_files():
		folder.remove(name)
	DirAccess.remove_absolute(p_folder)

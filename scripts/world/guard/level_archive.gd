class_name LevelArchive
extends RefCounted
## Makes the folder of a level for the share: its scene and the files beside it with a manifest, if
## all that it holds may be sent.

## Faults that are named at most.
const MAX_FAULTS: int = 40

## What keeps the level from being sent, with file and line.
var faults: PackedStringArray = []
## The manifest of the folder that was made.
var manifest: LevelManifest = LevelManifest.new()


## Makes the folder of a level in another folder. Returns whether it has been made; if not,
## [member faults] says why.
func pack(p_name: String, p_from: String, p_out: String) -> bool:
	faults.clear()
	manifest = LevelManifest.new()
	manifest.name = p_name
	var names: PackedStringArray = _find_files(p_from, p_name)
	if not names.has(manifest.scene_file()):
		faults.append("there is no %s" % p_from.path_join(manifest.scene_file()))
		return false
	var contents: Array[PackedByteArray] = []
	for file: String in names:
		contents.append(FileAccess.get_file_as_bytes(p_from.path_join(file)))
		_add(file, contents[-1])
	_check(contents[names.find(manifest.scene_file())], p_from)
	manifest.encode()
	var fault: String = LevelManifest.decode(manifest.bytes).error
	if fault != "":
		faults.append(fault)
	if not faults.is_empty():
		return false
	return _write(p_out.path_join(p_name), names, contents)


## Files of a level that may be sent; what else lies there stays.
func _find_files(p_from: String, p_name: String) -> PackedStringArray:
	var names: PackedStringArray = []
	if not DirAccess.dir_exists_absolute(p_from):
		return names
	for file: String in DirAccess.get_files_at(p_from):
		var is_scene: bool = file == p_name + ".tscn"
		var is_other: bool = file.get_extension() != "tscn" and LevelManifest.is_file_name(file)
		if is_scene or is_other:
			names.append(file)
	return names


func _add(p_file: String, p_bytes: PackedByteArray) -> void:
	var entry: LevelManifest.Entry = LevelManifest.Entry.new()
	entry.name = p_file
	entry.size = p_bytes.size()
	entry.sha256 = LevelManifest.sha256_of(p_bytes)
	manifest.files.append(entry)


func _check(p_scene: PackedByteArray, p_from: String) -> void:
	var reader: SceneReader = SceneReaders.make()
	reader.most_faults = MAX_FAULTS
	var paths: Dictionary[String, String] = {}
	for entry: LevelManifest.Entry in manifest.files:
		paths[entry.name] = p_from.path_join(entry.name)
	var level: Level = reader.build(p_scene, manifest.scene_file(), paths)
	faults = reader.faults
	if level != null:
		manifest.title = level.title if level.title != "" else manifest.name.capitalize()
		manifest.title = manifest.title.left(LevelManifest.MAX_TITLE)
		level.free()


func _write(
	p_folder: String, p_names: PackedStringArray, p_contents: Array[PackedByteArray]
) -> bool:
	var error: Error = DirAccess.make_dir_recursive_absolute(p_folder)
	if error != OK:
		faults.append("%s cannot be made: %s" % [p_folder, error_string(error)])
		return false
	for index: int in p_names.size():
		_store(p_folder.path_join(p_names[index]), p_contents[index])
	# Last: a folder without it is no level yet.
	_store(p_folder.path_join(LevelManifest.FILE), manifest.bytes)
	return faults.is_empty()


func _store(p_path: String, p_bytes: PackedByteArray) -> void:
	var file: FileAccess = FileAccess.open(p_path, FileAccess.WRITE)
	if file == null or not file.store_buffer(p_bytes):
		faults.append("%s cannot be written" % p_path)

class_name LevelFolder
extends RefCounted
## A folder with a level and its manifest: of the share of a server, or of the levels that a client
## has received. Nothing in it is trusted. May be used in a thread.

## Bytes that are hashed at a time.
const _SLICE: int = 1 << 20

## Path of the folder.
var path: String = ""
## Its manifest, once [method open] has read it.
var manifest: LevelManifest = null
## Why the folder or the level in it is refused, or an empty text.
var error: String = ""
## How much of [method build] is done, 0 to 1. Other threads may read it.
var progress: float = 0.0

var _hashed: int = 0
var _scene: PackedByteArray = PackedByteArray()
var _reader: SceneReader = null


func _init(p_path: String) -> void:
	path = p_path


## Reads the manifest. Returns whether the folder has one that can be used; its files are not looked
## at yet.
func open() -> bool:
	error = ""
	var bytes: PackedByteArray = _read(LevelManifest.FILE, LevelManifest.MAX_BYTES)
	if error == "":
		manifest = LevelManifest.decode(bytes)
		error = manifest.error
	return error == ""


## Checks that every file is there as the manifest says.
func verify() -> bool:
	var is_open: bool = manifest != null and manifest.error == ""
	if not is_open and not open():
		return false
	_hashed = 0
	for entry: LevelManifest.Entry in manifest.files:
		_verify_file(entry)
		if error != "":
			return false
	return true


## The level, not in the tree; null if anything is wrong with it.
func build() -> Level:
	progress = 0.0
	if not verify():
		return null
	_reader = SceneReaders.make()
	var level: Level = _reader.build(_scene, manifest.scene_file(), _paths())
	error = _reader.refusal
	if level != null:
		level.folder = path
		level.bake_path = path.path_join(manifest.name + ".bake")
	_scene = PackedByteArray()
	progress = 1.0
	return level


## How much of [method build] is done, 0 to 1: half of it is checking the files.
func total_progress() -> float:
	var reader: SceneReader = _reader
	return 0.5 * progress + (0.5 * reader.progress if reader != null else 0.0)


func _paths() -> Dictionary[String, String]:
	var paths: Dictionary[String, String] = {}
	for entry: LevelManifest.Entry in manifest.files:
		paths[entry.name] = path.path_join(entry.name)
	return paths


func _verify_file(p_entry: LevelManifest.Entry) -> void:
	var file: FileAccess = _open(p_entry.name)
	if file == null:
		return
	if file.get_length() != p_entry.size:
		var parts: Array = [p_entry.name, file.get_length(), p_entry.size]
		error = "%s has %d bytes instead of %d" % parts
		return
	var context: HashingContext = HashingContext.new()
	context.start(HashingContext.HASH_SHA256)
	var is_scene: bool = p_entry.name == manifest.scene_file()
	var left: int = p_entry.size
	while left > 0:
		var slice: PackedByteArray = file.get_buffer(mini(left, _SLICE))
		if slice.is_empty():
			error = "%s cannot be read" % p_entry.name
			return
		context.update(slice)
		left -= slice.size()
		_hashed += slice.size()
		progress = float(_hashed) / maxi(manifest.total_size(), 1)
		if is_scene:
			# These bytes are built, and not what may be in the file a moment later.
			_scene.append_array(slice)
	if context.finish().hex_encode() != p_entry.sha256:
		error = "%s is not what %s says: its SHA-256 differs" % [p_entry.name, LevelManifest.FILE]


func _read(p_name: String, p_most: int) -> PackedByteArray:
	var file: FileAccess = _open(p_name)
	if file == null:
		return PackedByteArray()
	if file.get_length() > p_most:
		error = "%s has %d bytes, %d are the most" % [p_name, file.get_length(), p_most]
		return PackedByteArray()
	return file.get_buffer(file.get_length())


## Opens a file of the folder, which is to be no link to somewhere else.
func _open(p_name: String) -> FileAccess:
	var whole: String = path.path_join(p_name)
	var folder: DirAccess = DirAccess.open(path)
	if folder == null or not folder.file_exists(p_name):
		error = "%s is missing" % p_name
		return null
	if folder.is_link(p_name):
		error = "%s is a link" % p_name
		return null
	var file: FileAccess = FileAccess.open(whole, FileAccess.READ)
	if file == null:
		error = "%s cannot be read: %s" % [p_name, error_string(FileAccess.get_open_error())]
	return file

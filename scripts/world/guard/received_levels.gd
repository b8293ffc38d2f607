class_name ReceivedLevels
extends RefCounted
## The levels that a client has received, each in a folder named by its hash, and the files of those
## that are still on their way. What was used longest ago goes first when there is not enough room.

## Where they are by default.
const ROOT: String = "user://levels"
## Folder of files that are on their way, by the SHA-256 of what they are to become.
const PARTS: String = "parts"
## Bytes of all levels by default.
const DEFAULT_ROOM: int = 2048 << 20

const _USED: String = "used"

## Bytes that all levels together may have.
var room: int = DEFAULT_ROOM
## Path of the store.
var root: String = ROOT


func _init(p_root: String = ROOT, p_room: int = DEFAULT_ROOM) -> void:
	root = p_root
	room = p_room


## The folder of a level, by its hash. It may not be there.
func folder_of(p_hash: String) -> String:
	return root.path_join(p_hash)


## Whether a level seems to be there whole. What is in it is checked when it is loaded.
func has(p_hash: String) -> bool:
	if not LevelManifest.is_hash(p_hash):
		return false
	return FileAccess.file_exists(folder_of(p_hash).path_join(LevelManifest.FILE))


## Notes that a level is used now.
func touch(p_hash: String) -> void:
	var file: FileAccess = FileAccess.open(folder_of(p_hash).path_join(_USED), FileAccess.WRITE)
	if file != null:
		file.store_string("%d\n" % roundi(Time.get_unix_time_from_system() * 1000.0))


## Takes a level away, as it is not what it should be.
func remove(p_hash: String) -> void:
	if LevelManifest.is_hash(p_hash):
		_remove_folder(folder_of(p_hash))


## The file in which something of a SHA-256 is gathered by this process. What another process, which
## is gone, has gathered of it is taken over.
func claim_part(p_sha256: String) -> String:
	var folder: String = root.path_join(PARTS)
	DirAccess.make_dir_recursive_absolute(folder)
	var own: String = _part_path(p_sha256, OS.get_process_id())
	if FileAccess.file_exists(own):
		return own
	for name: String in DirAccess.get_files_at(folder):
		var owner: String = name.get_slice(".", 1)
		if name.get_slice(".", 0) == p_sha256 and not _is_alive(owner):
			# Of two who try only one succeeds.
			if DirAccess.rename_absolute(folder.path_join(name), own) == OK:
				return own
	return own


## Puts a level together of its files, which are all there and right. Returns why it cannot, or an
## empty text.
func adopt(p_manifest: LevelManifest) -> String:
	var content_hash: String = p_manifest.content_hash()
	var fresh: String = "%s.%d" % [folder_of(content_hash), OS.get_process_id()]
	_remove_folder(fresh)
	var error: Error = DirAccess.make_dir_recursive_absolute(fresh)
	for entry: LevelManifest.Entry in p_manifest.files:
		if error == OK:
			error = DirAccess.copy_absolute(
				_part_path(entry.sha256, OS.get_process_id()), fresh.path_join(entry.name)
			)
	var file: FileAccess = FileAccess.open(fresh.path_join(LevelManifest.FILE), FileAccess.WRITE)
	if error == OK and file != null and file.store_buffer(p_manifest.bytes):
		file.close()
		error = (
			DirAccess.rename_absolute(fresh, folder_of(content_hash))
			if not has(content_hash)
			else FAILED
		)
		if error != OK and has(content_hash):
			# Another process has been quicker.
			_remove_folder(fresh)
			error = OK
	elif error == OK:
		error = FileAccess.get_open_error()
	for entry: LevelManifest.Entry in p_manifest.files:
		_remove_file(_part_path(entry.sha256, OS.get_process_id()))
	if error != OK:
		_remove_folder(fresh)
		return "the level cannot be kept in %s: %s" % [root, error_string(error)]
	touch(content_hash)
	return ""


## Makes room for a level by taking away what was used longest ago. Returns why there is not enough,
## or an empty text.
func make_room(p_bytes: int, p_keep: String = "") -> String:
	if p_bytes > room:
		var parts: Array = [p_bytes >> 20, room >> 20]
		return "it has %d MB, --level-store allows %d MB" % parts
	var kept: Array[Dictionary] = _list(p_keep)
	kept.sort_custom(func(a: Dictionary, b: Dictionary) -> bool: return a["used"] < b["used"])
	var sum: int = p_bytes
	for each: Dictionary in kept:
		sum += each["size"]
	for each: Dictionary in kept:
		if sum <= room:
			break
		sum -= each["size"]
		each["remove"].call()
	return ""


## Everything that takes room but for one level: its size, when it was used, how it is removed.
func _list(p_keep: String) -> Array[Dictionary]:
	var found: Array[Dictionary] = []
	if not DirAccess.dir_exists_absolute(root):
		return found
	for name: String in DirAccess.get_directories_at(root):
		# What another process puts together has its number at the end.
		if name == p_keep or name == PARTS or _is_alive(name.get_slice(".", 1)):
			continue
		var folder: String = root.path_join(name)
		var size: int = 0
		for file: String in DirAccess.get_files_at(folder):
			size += _size_of(folder.path_join(file))
		found.append({"size": size, "used": _used(folder), "remove": _remove_folder.bind(folder)})
	var parts: String = root.path_join(PARTS)
	if not DirAccess.dir_exists_absolute(parts):
		return found
	for name: String in DirAccess.get_files_at(parts):
		var file: String = parts.path_join(name)
		if not _is_alive(name.get_slice(".", 1)):
			var used: int = FileAccess.get_modified_time(file) * 1000
			found.append({"size": _size_of(file), "used": used, "remove": _remove_file.bind(file)})
	return found


func _used(p_folder: String) -> int:
	var path: String = p_folder.path_join(_USED)
	if not FileAccess.file_exists(path):
		return 0
	return FileAccess.get_file_as_bytes(path).slice(0, 20).get_string_from_ascii().to_int()


func _part_path(p_sha256: String, p_process: int) -> String:
	return root.path_join(PARTS).path_join("%s.%d.part" % [p_sha256, p_process])


static func _is_alive(p_process: String) -> bool:
	return p_process.is_valid_int() and DirAccess.dir_exists_absolute("/proc/" + p_process)


static func _size_of(p_path: String) -> int:
	var file: FileAccess = FileAccess.open(p_path, FileAccess.READ)
	return file.get_length() if file != null else 0


static func _remove_file(p_path: String) -> void:
	if FileAccess.file_exists(p_path):
		DirAccess.remove_absolute(p_path)


## Takes a folder and its files away. There are no folders in it.
static func _remove_folder(p_path: String) -> void:
	if not DirAccess.dir_exists_absolute(p_path):
		return
	for file: String in DirAccess.get_files_at(p_path):
		DirAccess.remove_absolute(p_path.path_join(file))
	DirAccess.remove_absolute(p_path)

@tool
class_name StudioFile
extends RefCounted
## The file of the effect that the studio edits. Nothing that somebody typed is lost: a save
## replaces the file in one step and keeps what was there, and what is not saved is kept too.

## Where unsaved texts and what was replaced are kept.
const KEPT: String = "user://studio"
## Replaced versions that are kept of each effect.
const MAX_BACKUPS: int = 20

## Folder of the effects.
var folder: String = EffectFile.FOLDER
## Name of the effect; empty for none yet.
var name: String = ""
## The text as it is in the file.
var saved: String = ""
## Message of the last call; empty if all went well.
var error: String = ""
## Whether the file is no text: then it is neither shown nor saved over.
var is_foreign: bool = false

## The file as it was read or written last.
var _saved_bytes: PackedByteArray = []


## Names of the effects in the folder.
func names() -> PackedStringArray:
	var found: PackedStringArray = []
	if not DirAccess.dir_exists_absolute(folder):
		return found
	for file: String in DirAccess.get_files_at(folder):
		if file.get_extension() == EffectFile.EXTENSION:
			found.append(file.get_basename())
	found.sort()
	return found


## Path of the file.
func path() -> String:
	return "%s/%s.%s" % [folder, name, EffectFile.EXTENSION]


## Opens an effect. Returns its text: what was typed and not saved the last time, if there is such.
func open(p_name: String) -> String:
	error = ""
	name = p_name
	_saved_bytes = []
	if FileAccess.file_exists(path()):
		_saved_bytes = FileAccess.get_file_as_bytes(path())
	var read: EffectText = EffectText.new(_saved_bytes)
	saved = read.text
	is_foreign = read.failed
	if is_foreign:
		error = "%s is no text in UTF-8: it stays as it is" % path()
		return ""
	var kept: String = _kept_path()
	if FileAccess.file_exists(kept):
		var text: String = FileAccess.get_file_as_string(kept)
		if text != saved and text != "":
			error = "this text was not saved the last time: Ctrl+S saves it, Undo leaves it"
			return text
	return saved


## Whether there is an effect of this name, in the folder or not saved yet.
func is_taken(p_name: String) -> bool:
	return p_name == name or names().has(p_name) or FileAccess.file_exists(_kept_path(p_name))


## Whether a text differs from the file.
func is_changed(p_text: String) -> bool:
	return p_text != saved


## Keeps a text that is not saved, so that a crash loses nothing.
func keep(p_text: String) -> void:
	if name == "" or is_foreign:
		return
	if not is_changed(p_text):
		if FileAccess.file_exists(_kept_path()):
			DirAccess.remove_absolute(_kept_path())
		return
	DirAccess.make_dir_recursive_absolute(KEPT)
	_write(_kept_path(), p_text)


## Saves a text. Returns whether that went well; if not, the file is as it was.
func save(p_text: String) -> bool:
	error = ""
	if not EffectLimits.is_name(name):
		error = "an effect's name has small letters, digits and _, not '%s'" % name
		return false
	if is_foreign:
		error = "%s is no text in UTF-8: it stays as it is" % path()
		return false
	if not _back_up(p_text.to_utf8_buffer()) or not _write(path(), p_text):
		return false
	saved = p_text
	_saved_bytes = p_text.to_utf8_buffer()
	keep(p_text)
	return true


## A path in the folder of pictures and films that nothing has yet.
static func next_picture(p_name: String, p_extension: String) -> String:
	var to: String = OS.get_environment("DISMOUNT_OUT")
	if to == "":
		to = ProjectSettings.globalize_path(KEPT)
	DirAccess.make_dir_recursive_absolute(to)
	var path: String = "%s/%s.%s" % [to, p_name, p_extension]
	var number: int = 2
	while FileAccess.file_exists(path):
		path = "%s/%s_%d.%s" % [to, p_name, number, p_extension]
		number += 1
	return path


## Keeps what is in the file now byte by byte, also what somebody else has put there. Returns
## whether it is safe.
func _back_up(p_new: PackedByteArray) -> bool:
	if not FileAccess.file_exists(path()):
		return true
	var there: PackedByteArray = FileAccess.get_file_as_bytes(path())
	if there == p_new:
		return true
	DirAccess.make_dir_recursive_absolute(KEPT)
	var failed: Error = DirAccess.copy_absolute(path(), _backup_path())
	if failed != OK:
		error = "not saved, as %s cannot be kept: %s" % [path(), error_string(failed)]
		return false
	if there != _saved_bytes:
		error = "somebody else has changed the file: their text is in %s" % KEPT
	_forget_old_backups()
	return true


## A path that no backup has yet: several may be of one second.
func _backup_path() -> String:
	var time: String = Time.get_datetime_string_from_system().replace(":", "-")
	var number: int = 0
	while FileAccess.file_exists("%s/%s.%s.%03d.backup" % [KEPT, name, time, number]):
		number += 1
	return "%s/%s.%s.%03d.backup" % [KEPT, name, time, number]


func _forget_old_backups() -> void:
	var old: PackedStringArray = []
	for file: String in DirAccess.get_files_at(KEPT):
		if file.begins_with(name + ".") and file.ends_with(".backup"):
			old.append(file)
	old.sort()
	for i: int in old.size() - MAX_BACKUPS:
		DirAccess.remove_absolute(KEPT.path_join(old[i]))


## Writes beside the file and puts the new one in its position in one step.
func _write(p_path: String, p_text: String) -> bool:
	var beside: String = p_path + ".tmp"
	var file: FileAccess = FileAccess.open(beside, FileAccess.WRITE)
	if file == null:
		error = "%s cannot be written: %s" % [p_path, error_string(FileAccess.get_open_error())]
		return false
	file.store_string(p_text)
	file.flush()
	var failed: Error = file.get_error()
	file.close()
	if failed == OK:
		failed = DirAccess.rename_absolute(beside, p_path)
	if failed != OK:
		error = "%s cannot be written: %s" % [p_path, error_string(failed)]
		DirAccess.remove_absolute(beside)
	return failed == OK


func _kept_path(p_name: String = name) -> String:
	# Effects of one name may be in several folders.
	var where: String = ProjectSettings.globalize_path(folder).md5_text().left(8)
	return "%s/%s.%s.unsaved" % [KEPT, p_name, where]

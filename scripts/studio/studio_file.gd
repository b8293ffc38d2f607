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
## What the last call has to say; empty if all went well.
var error: String = ""


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
	saved = FileAccess.get_file_as_string(path()) if FileAccess.file_exists(path()) else ""
	var kept: String = _kept_path()
	if FileAccess.file_exists(kept):
		var text: String = FileAccess.get_file_as_string(kept)
		if text != saved and text != "":
			error = "this text was not saved the last time: Ctrl+S saves it, Undo leaves it"
			return text
	return saved


## Whether a text differs from the file.
func is_changed(p_text: String) -> bool:
	return p_text != saved


## Keeps a text that is not saved, so that a crash loses nothing.
func keep(p_text: String) -> void:
	if name == "":
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
	if not EffectFile.is_name(name):
		error = "an effect's name has small letters, digits and _, not '%s'" % name
		return false
	_back_up(p_text)
	if not _write(path(), p_text):
		return false
	saved = p_text
	keep(p_text)
	return true


## Keeps what is in the file now, also what somebody else has put there.
func _back_up(p_text: String) -> void:
	if not FileAccess.file_exists(path()):
		return
	var there: String = FileAccess.get_file_as_string(path())
	if there == p_text:
		return
	if there != saved:
		error = "somebody else has changed the file: their text is in %s" % KEPT
	DirAccess.make_dir_recursive_absolute(KEPT)
	var time: String = Time.get_datetime_string_from_system().replace(":", "-")
	_write("%s/%s.%s.backup" % [KEPT, name, time], there)
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


func _kept_path() -> String:
	# Effects of one name may be in several folders.
	var where: String = ProjectSettings.globalize_path(folder).md5_text().left(8)
	return "%s/%s.%s.unsaved" % [KEPT, name, where]

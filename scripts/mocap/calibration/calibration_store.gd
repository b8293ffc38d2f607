class_name CalibrationStore
extends RefCounted
## Keeps a [PersonProfile] for each person in a folder: NAME.json.

## Where they are by default.
const FOLDER: String = "user://calibrations"
## Maximum size of a profile, bytes.
const MAX_BYTES: int = 1 << 20

## The folder.
var folder: String = FOLDER
## What went wrong last: file, field and reason; or an empty text.
var error: String = ""


func _init(p_folder: String = FOLDER) -> void:
	folder = p_folder


## Names of the people of whom there is a file, sorted.
func list() -> PackedStringArray:
	var found: PackedStringArray = []
	if DirAccess.dir_exists_absolute(folder):
		for file: String in DirAccess.get_files_at(folder):
			var name: String = file.get_basename()
			if file.get_extension() == "json" and PersonProfile.find_name_fault(name) == "":
				found.append(name)
	found.sort()
	return found


## The file of a person.
func path_of(p_name: String) -> String:
	return folder.path_join(p_name + ".json")


## A person's profile; null (and a reason in [member error]) if there is none or it is damaged.
func read(p_name: String) -> PersonProfile:
	error = PersonProfile.find_name_fault(p_name)
	if error != "":
		return null
	var path: String = path_of(p_name)
	var file: FileAccess = FileAccess.open(path, FileAccess.READ)
	if file == null:
		error = "%s: cannot be read: %s" % [path, error_string(FileAccess.get_open_error())]
		return null
	if file.get_length() > MAX_BYTES:
		error = "%s: %d bytes are too many for a calibration" % [path, file.get_length()]
		return null
	var bytes: PackedByteArray = file.get_buffer(file.get_length())
	var reader: ProfileReader = ProfileReader.new()
	var profile: PersonProfile = null
	if bytes.has(0):
		error = "%s: it is no text" % path
		return null
	profile = reader.read(bytes.get_string_from_utf8())
	if profile == null:
		error = "%s: %s" % [path, reader.error]
	elif profile.name != p_name:
		error = "%s: name: it is that of '%s'" % [path, profile.name]
	return profile if error == "" else null


## Writes a person's profile; the file is replaced as a whole. Returns whether it was written.
func write(p_profile: PersonProfile) -> bool:
	error = PersonProfile.find_name_fault(p_profile.name)
	if error != "":
		return false
	var path: String = path_of(p_profile.name)
	DirAccess.make_dir_recursive_absolute(folder)
	var file: FileAccess = FileAccess.open(path + ".part", FileAccess.WRITE)
	if file == null:
		error = "%s: cannot be written: %s" % [path, error_string(FileAccess.get_open_error())]
		return false
	file.store_string(ProfileReader.write(p_profile))
	file.flush()
	var fault: Error = file.get_error()
	file.close()
	if fault == OK:
		fault = DirAccess.rename_absolute(path + ".part", path)
	if fault != OK:
		error = "%s: cannot be written: %s" % [path, error_string(fault)]
	return error == ""


## Removes a person's file.
func remove(p_name: String) -> void:
	error = PersonProfile.find_name_fault(p_name)
	if error == "" and FileAccess.file_exists(path_of(p_name)):
		DirAccess.remove_absolute(path_of(p_name))

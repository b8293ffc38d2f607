extends TestCase
## Nothing that somebody typed is lost.

const FOLDER: String = "user://test_studio"

var _file: StudioFile = null


func before_each() -> void:
	_clean_up()
	DirAccess.make_dir_recursive_absolute(FOLDER)
	_file = _open()


func after_each() -> void:
	_clean_up()


func test_what_is_saved_is_there() -> void:
	is_true(_file.save("one"))
	equal(FileAccess.get_file_as_string(_file.path()), "one")
	equal(_open().saved, "one")
	equal(_file.names(), PackedStringArray(["test_studio"]))


func test_an_unsaved_text_comes_back() -> void:
	_file.save("one")
	_file.keep("two")
	var again: StudioFile = _open()
	equal(again.open("test_studio"), "two")
	equal([again.saved, again.is_changed("two")], ["one", true])
	contains(again.error, "not saved the last time")
	again.save("two")
	equal(_open().open("test_studio"), "two")
	equal(_open().error, "")


func test_what_somebody_else_has_put_there_is_kept() -> void:
	_file.save("one")
	var other: FileAccess = FileAccess.open(_file.path(), FileAccess.WRITE)
	other.store_string("theirs")
	other.close()
	is_true(_file.save("mine"))
	contains(_file.error, "somebody else")
	equal(FileAccess.get_file_as_string(_file.path()), "mine")
	is_true(_backups().any(func(text: String) -> bool: return text == "theirs"))


func test_backups_of_one_second_are_all_kept() -> void:
	for text: String in ["one", "two", "three", "four"]:
		is_true(_file.save(text))
	var texts: Array[String] = _backups()
	texts.sort()
	equal(texts, ["one", "three", "two"] as Array[String])


func test_what_is_no_text_stays_as_it_is() -> void:
	_put([0xFF, 0xFE, 0x41])
	equal(_file.open("test_studio"), "")
	_file.keep("mine")
	is_false(_file.save("mine"))
	contains(_file.error, "UTF-8")
	equal(FileAccess.get_file_as_bytes(_file.path()), PackedByteArray([0xFF, 0xFE, 0x41]))
	# Who has opened it before keeps the bytes.
	_file.name = ""
	DirAccess.remove_absolute(FOLDER + "/test_studio.gdshader")
	_file = _open()
	_put([0xFF, 0xFE, 0x41])
	is_true(_file.save("mine"))
	var kept: PackedByteArray = []
	for name: String in DirAccess.get_files_at(StudioFile.KEPT):
		if name.begins_with("test_studio.") and name.ends_with(".backup"):
			kept = FileAccess.get_file_as_bytes(StudioFile.KEPT.path_join(name))
	equal(kept, PackedByteArray([0xFF, 0xFE, 0x41]))


func test_pictures_are_numbered() -> void:
	var before: String = OS.get_environment("DISMOUNT_OUT")
	OS.set_environment("DISMOUNT_OUT", ProjectSettings.globalize_path(FOLDER))
	var paths: PackedStringArray = []
	for i: int in 3:
		paths.append(StudioFile.next_picture("test_studio", "avi"))
		FileAccess.open(paths[-1], FileAccess.WRITE).close()
	OS.set_environment("DISMOUNT_OUT", before)
	var names: Array = Array(paths).map(func(path: String) -> String: return path.get_file())
	equal(names, ["test_studio.avi", "test_studio_2.avi", "test_studio_3.avi"])


func test_a_folder_that_cannot_be_written_changes_nothing() -> void:
	_file.folder = "user://no/such/folder"
	is_false(_file.save("one"))
	contains(_file.error, "cannot be written")


func test_a_bad_name_is_not_saved() -> void:
	_file.name = "../evil"
	is_false(_file.save("one"))
	contains(_file.error, "small letters")


func _open() -> StudioFile:
	var file: StudioFile = StudioFile.new()
	file.folder = FOLDER
	file.open("test_studio")
	return file


func _put(p_bytes: PackedByteArray) -> void:
	var other: FileAccess = FileAccess.open(_file.path(), FileAccess.WRITE)
	other.store_buffer(p_bytes)
	other.close()


func _backups() -> Array[String]:
	var texts: Array[String] = []
	for name: String in DirAccess.get_files_at(StudioFile.KEPT):
		if name.begins_with("test_studio.") and name.ends_with(".backup"):
			texts.append(FileAccess.get_file_as_string(StudioFile.KEPT.path_join(name)))
	return texts


func _clean_up() -> void:
	for folder: String in [FOLDER, StudioFile.KEPT]:
		if not DirAccess.dir_exists_absolute(folder):
			continue
		for name: String in DirAccess.get_files_at(folder):
			if name.begins_with("test_studio"):
				DirAccess.remove_absolute(folder.path_join(name))
	if DirAccess.dir_exists_absolute(FOLDER):
		DirAccess.remove_absolute(FOLDER)

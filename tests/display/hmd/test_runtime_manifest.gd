extends TestCase
## Which runtime the machine has, and what is wrong with its manifest.

var _folder: String = ""


func before_each() -> void:
	_folder = OS.get_temp_dir().path_join("manifest-%d" % OS.get_process_id())
	DirAccess.make_dir_recursive_absolute(_folder)


func after_each() -> void:
	for file: String in DirAccess.get_files_at(_folder):
		DirAccess.remove_absolute(_folder.path_join(file))
	DirAccess.remove_absolute(_folder)


func test_libraries_are_where_the_manifest_says() -> void:
	var cases: Dictionary[String, String] = {
		"/usr/lib/libx.so": "/usr/lib/libx.so",
		"libx.so": "libx.so",
		"../lib/libx.so": _folder.get_base_dir().path_join("lib/libx.so"),
	}
	for path: String in cases:
		var manifest: RuntimeManifest = _read('{"runtime": {"library_path": "%s"}}' % path)
		equal(manifest.error, "")
		equal(manifest.library, cases[path])


func test_what_is_wrong_is_said_with_what_to_do() -> void:
	var cases: Dictionary[String, String] = {
		"{": "no JSON",
		"[]": "no runtime.library_path",
		'{"runtime": 3}': "no runtime.library_path",
		'{"runtime": {"library_path": 3}}': "no runtime.library_path",
	}
	for text: String in cases:
		var error: String = _read(text).error
		is_true(cases[text] in error and "XR_RUNTIME_JSON" in error, error)
	is_true("is not there" in RuntimeManifest.read("/nonexistent.json").error)


func test_a_named_manifest_comes_before_the_machines() -> void:
	OS.set_environment("XR_RUNTIME_JSON", "/nonexistent/named.json")
	var error: String = RuntimeManifest.find().error
	OS.unset_environment("XR_RUNTIME_JSON")
	is_true("/nonexistent/named.json" in error, error)


func _read(p_text: String) -> RuntimeManifest:
	var path: String = _folder.path_join("runtime.json")
	var file: FileAccess = FileAccess.open(path, FileAccess.WRITE)
	file.store_string(p_text)
	file.close()
	return RuntimeManifest.read(path)

class_name RuntimeManifest
extends RefCounted
## Which OpenXR runtime this machine has: the manifest that the loader would choose, and the library
## that it names.

## What to do where there is none.
const HOW: String = (
	"install an OpenXR runtime (SteamVR, Monado or the headset's own) and make it the active one,"
	+ " or name its manifest in XR_RUNTIME_JSON"
)

## The library: a path, or a name that the system looks for; empty where there is none.
var library: String = ""
## What is wrong and how to mend it; empty where nothing is.
var error: String = ""
## The manifest.
var path: String = ""


## The machine's runtime.
static func find() -> RuntimeManifest:
	var named: String = OS.get_environment("XR_RUNTIME_JSON")
	if named != "":
		return read(named)
	for place: String in _places():
		if FileAccess.file_exists(place):
			return read(place)
	var manifest: RuntimeManifest = RuntimeManifest.new()
	manifest.error = "this machine has no OpenXR runtime: " + HOW
	return manifest


## A manifest by its path.
static func read(p_path: String) -> RuntimeManifest:
	var manifest: RuntimeManifest = RuntimeManifest.new()
	manifest.path = p_path
	if not FileAccess.file_exists(p_path):
		manifest.error = "the OpenXR runtime's manifest %s is not there: %s" % [p_path, HOW]
		return manifest
	var parser: JSON = JSON.new()
	if parser.parse(FileAccess.get_file_as_string(p_path)) != OK:
		manifest.error = (
			"line %d of the OpenXR runtime's manifest %s is no JSON (%s): %s"
			% [parser.get_error_line() + 1, p_path, parser.get_error_message(), HOW]
		)
		return manifest
	var data: Dictionary = parser.data if parser.data is Dictionary else {}
	var runtime: Dictionary = {}
	if data.get("runtime") is Dictionary:
		runtime = data["runtime"]
	if not runtime.get("library_path") is String or runtime["library_path"] == "":
		manifest.error = (
			"the OpenXR runtime's manifest %s names no runtime.library_path: %s" % [p_path, HOW]
		)
		return manifest
	manifest.library = _library(p_path, runtime["library_path"])
	return manifest


## A name without folders is looked for by the system; others begin at the manifest.
static func _library(p_manifest: String, p_library: String) -> String:
	if p_library.is_absolute_path() or not "/" in p_library:
		return p_library
	return p_manifest.get_base_dir().path_join(p_library).simplify_path()


## Where the loader looks, in its order.
static func _places() -> PackedStringArray:
	var home: String = OS.get_environment("HOME")
	var folders: PackedStringArray = [OS.get_environment("XDG_CONFIG_HOME")]
	if folders[0] == "":
		folders[0] = home.path_join(".config")
	var shared: String = OS.get_environment("XDG_CONFIG_DIRS")
	folders.append_array((shared if shared != "" else "/etc/xdg").split(":", false))
	folders.append("/etc")
	var places: PackedStringArray = []
	for folder: String in folders:
		for file: String in ["active_runtime.x86_64.json", "active_runtime.json"]:
			places.append(folder.path_join("openxr/1").path_join(file))
	return places

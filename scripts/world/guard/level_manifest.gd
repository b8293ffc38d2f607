class_name LevelManifest
extends RefCounted
## What a folder of a level holds: [code]level.json[/code], with the size and the SHA-256 of each
## file. The SHA-256 of the manifest's own bytes stands for the whole level.

## Name of the manifest in its folder.
const FILE: String = "level.json"
## Version of the format.
const FORMAT: int = 1
## Version of the level kit that levels are made of: a level of a later one is refused.
const KIT: int = 1
## Largest manifest, bytes.
const MAX_BYTES: int = 16384
## Files of a level.
const MAX_FILES: int = 64
## Bytes of all files of a level.
const MAX_TOTAL: int = 256 << 20
## Largest file, bytes, by the ending of its name; there are no other endings.
const MAX_SIZES: Dictionary[String, int] = {
	"tscn": SceneText.MAX_BYTES,
	"bake": 128 << 20,
	"height": 64 << 20,
	"png": 4 << 20,
}
## Longest title, characters.
const MAX_TITLE: int = 80

static var _file_name: RegEx = RegEx.create_from_string("^[a-z][a-z0-9_]{0,59}\\.[a-z]{3,6}$")
static var _hash: RegEx = RegEx.create_from_string("^[0-9a-f]{64}$")

## Name of the level, as [method LevelStore.is_name] has it.
var name: String = ""
## What people call it.
var title: String = ""
## Its files.
var files: Array[Entry] = []
## The manifest as bytes.
var bytes: PackedByteArray = PackedByteArray()
## Why it is none, or an empty text.
var error: String = ""


## A file of a level.
class Entry:
	extends RefCounted
	## Name in the folder, without any path.
	var name: String = ""
	## Bytes.
	var size: int = 0
	## SHA-256, 64 hexadecimal digits.
	var sha256: String = ""


## The manifest in some bytes; [member error] says why it is none.
static func decode(p_bytes: PackedByteArray) -> LevelManifest:
	var manifest: LevelManifest = LevelManifest.new()
	manifest.bytes = p_bytes
	manifest._read(p_bytes)
	return manifest


## Puts [member name], [member title] and [member files] into [member bytes].
func encode() -> void:
	var rows: Array[Dictionary] = []
	for entry: Entry in files:
		rows.append({"name": entry.name, "size": entry.size, "sha256": entry.sha256})
	var content: Dictionary = {
		"format": FORMAT, "kit": KIT, "name": name, "title": title, "files": rows
	}
	bytes = (JSON.stringify(content, "\t", false) + "\n").to_utf8_buffer()


## What stands for the level: the SHA-256 of the manifest, 64 hexadecimal digits.
func content_hash() -> String:
	return sha256_of(bytes)


## Name of the file with the level's scene.
func scene_file() -> String:
	return name + ".tscn"


## Bytes of all files.
func total_size() -> int:
	var sum: int = 0
	for entry: Entry in files:
		sum += entry.size
	return sum


## Whether a text is a SHA-256 in hexadecimal digits.
static func is_hash(p_text: String) -> bool:
	return _hash.search(p_text) != null


## Whether a text can be the name of a level's file.
static func is_file_name(p_text: String) -> bool:
	return _file_name.search(p_text) != null and MAX_SIZES.has(p_text.get_extension())


## The SHA-256 of some bytes, 64 hexadecimal digits.
static func sha256_of(p_bytes: PackedByteArray) -> String:
	var context: HashingContext = HashingContext.new()
	context.start(HashingContext.HASH_SHA256)
	context.update(p_bytes)
	return context.finish().hex_encode()


func _read(p_bytes: PackedByteArray) -> void:
	if p_bytes.size() > MAX_BYTES:
		error = "%s has %d bytes, %d are the most" % [FILE, p_bytes.size(), MAX_BYTES]
		return
	var is_text: bool = not p_bytes.has(0) and SceneText.is_utf8(p_bytes)
	# Without nesting that the engine's reader would follow down its stack.
	var is_flat: bool = p_bytes.count(0x5B) <= 2 and p_bytes.count(0x7B) <= MAX_FILES + 1
	var json: JSON = JSON.new()
	if not (is_text and is_flat) or json.parse(p_bytes.get_string_from_utf8()) != OK:
		error = "%s is no JSON of a level" % FILE
		return
	var content: Dictionary = json.data if json.data is Dictionary else {}
	if content.get("format") is not float or content["format"] != FORMAT:
		var parts: Array = [FILE, _show(content.get("format")), FORMAT]
		error = "%s has format %s; this program reads %d" % parts
	elif content.get("kit") is not float or content["kit"] > KIT or content["kit"] < 1:
		var parts: Array = [_show(content.get("kit")), KIT]
		error = "it needs level kit %s; this program has %d: update it" % parts
	elif content.get("name") is not String or not LevelStore.is_name(content["name"]):
		error = "'%s' is no name of a level" % _show(content.get("name"))
	elif content.get("title") is not String or (content["title"] as String).length() > MAX_TITLE:
		error = "%s has no title, or a longer one than %d characters" % [FILE, MAX_TITLE]
	elif content.get("files") is not Array or (content["files"] as Array).size() > MAX_FILES:
		error = "%s lists no files, or more than %d" % [FILE, MAX_FILES]
	else:
		name = content["name"]
		title = ByteReader.clean(content["title"])
		_read_files(content["files"])


func _read_files(p_rows: Array) -> void:
	var names: Dictionary[String, bool] = {}
	for row: Variant in p_rows:
		var entry: Entry = _read_entry(row if row is Dictionary else {})
		if error != "":
			return
		if names.has(entry.name):
			error = "%s lists '%s' twice" % [FILE, entry.name]
			return
		names[entry.name] = true
		files.append(entry)
	if not names.has(scene_file()):
		error = "%s lists no %s" % [FILE, scene_file()]
	elif total_size() > MAX_TOTAL:
		error = "its files have %d bytes, %d are the most" % [total_size(), MAX_TOTAL]


func _read_entry(p_row: Dictionary) -> Entry:
	var entry: Entry = Entry.new()
	var size: Variant = p_row.get("size")
	if p_row.get("name") is not String or not is_file_name(p_row["name"]):
		error = "%s lists '%s', which a level may not hold" % [FILE, _show(p_row.get("name"))]
		return entry
	entry.name = p_row["name"]
	var most: int = MAX_SIZES[entry.name.get_extension()]
	if size is not float or size != floorf(size) or size < 1.0 or size > most:
		var parts: Array = [entry.name, _show(size), most]
		error = "%s is said to have %s bytes: 1 to %d are allowed" % parts
		return entry
	entry.size = int(size as float)
	if p_row.get("sha256") is not String or not is_hash(p_row["sha256"]):
		error = "%s has no SHA-256 of %s" % [FILE, entry.name]
		return entry
	entry.sha256 = p_row["sha256"]
	return entry


## A part of a strange value that can be shown in a log.
static func _show(p_value: Variant) -> String:
	return ByteReader.clean(str(p_value).left(60)).trim_suffix(".0")

class_name LevelKit
extends RefCounted
## What a received level may be made of, as data: a row for each class, with the properties that a
## level may set and their ranges. What has no row here is refused by [LevelReader].
##
## A class of blocks brings its row ([KitEntry]), a feature those of all else ([KitRows]). Scripts
## and scenes named there are the program's own; a level names them by their path and can name no
## others.

## Folders of the program whose pictures, materials, meshes and shapes levels may use.
const ASSET_FOLDERS: PackedStringArray = ["res://assets/world/", "res://scenes/world/"]
## Classes that such a file may be declared as, and be: nothing that runs.
const ASSET_TYPES: PackedStringArray = [
	"Texture2D",
	"CompressedTexture2D",
	"Material",
	"StandardMaterial3D",
	"ShaderMaterial",
	"Mesh",
	"Shape3D",
	"ArrayMesh",
	"ConvexPolygonShape3D",
	"ConcavePolygonShape3D",
	"PhysicsMaterial",
]
## Endings of such files: no scenes and no scripts.
const ASSET_ENDINGS: PackedStringArray = ["png", "jpg", "webp", "exr", "obj", "res", "tres"]
## Groups that a node of a level may be in.
const GROUPS: PackedStringArray = ["props"]
## Physics bodies of a level.
const MAX_BODIES: int = 8000

static var _rows: Dictionary[String, KitClass] = {}


static func _static_init() -> void:
	for entry: KitEntry in KitEntry.all():
		_add(entry.row)
	for each: KitRows in KitRows.all():
		for row: KitClass in each.rows():
			_add(row)


## The row of a node or resource of an engine class, or of one with a script; null if it has none.
static func find(p_base: String, p_script: String = "") -> KitClass:
	return _rows.get(p_base + p_script)


## Whether there is a row of an engine class, with or without a script.
static func knows(p_base: String) -> bool:
	return _rows.values().any(func(row: KitClass) -> bool: return row.base == p_base)


## The engine's classes that have rows.
static func bases() -> PackedStringArray:
	var found: Dictionary[String, bool] = {}
	for row: KitClass in _rows.values():
		if row.base != "":
			found[row.base] = true
	return PackedStringArray(found.keys())


## The row of a scene, or null.
static func find_scene(p_path: String) -> KitClass:
	return _rows.get(p_path)


## Whether a level may name a file of the program.
static func allows_file(p_type: String, p_path: String) -> bool:
	if p_type == "PackedScene":
		return find_scene(p_path) != null
	if p_type == "Script":
		return _rows.values().any(
			func(row: KitClass) -> bool: return row.path == p_path or row.root_script == p_path
		)
	if not (ASSET_TYPES.has(p_type) and ASSET_ENDINGS.has(p_path.get_extension())):
		return false
	if p_path.contains("..") or p_path.contains("::"):
		return false
	for folder: String in ASSET_FOLDERS:
		if p_path.begins_with(folder):
			return true
	return false


## Names of all rows, for people who ask what is allowed.
static func names() -> PackedStringArray:
	var found: PackedStringArray = []
	for row: KitClass in _rows.values():
		found.append(row.key)
	return found


static func _add(p_row: KitClass) -> void:
	_rows[p_row.path if p_row.kind == KitClass.Kind.SCENE else p_row.base + p_row.path] = p_row

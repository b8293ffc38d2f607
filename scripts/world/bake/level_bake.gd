class_name LevelBake
extends RefCounted
## What is worked out of a level ahead of time and kept beside it, in [code]NAME.bake[/code]: light
## of the vertices, light in the air, what can be seen from where.
##
## A file may come from a stranger: sizes are checked before anything is read, and nothing in it
## acts. Little-endian: 8 bytes [code]DSMTBAKE[/code], u32 version, 32 bytes SHA-256 of the rest,
## then the sections of [enum Section], each u32 section, u32 bytes as they are, u32 bytes packed
## (zstd), and these bytes.

## The sections of a file.
enum Section { PARTS = 1, LIGHT, GRID, CELLS, SEEN_PARTS, SEEN_CELLS }

## What a file begins with.
const MAGIC: String = "DSMTBAKE"
## Version of the format.
const VERSION: int = 3
## Bytes of the light of a vertex: red, green and blue of the five sources.
const LIGHT_SIZE: int = 15
## Bytes of a point of the grid of light.
const POINT_SIZE: int = 31
## Limits of a file.
const MAX_BYTES: int = 64 * 1024 * 1024
const MAX_SECTION: int = 256 * 1024 * 1024
const MAX_PARTS: int = 8192
const MAX_CELLS: int = 8192
const MAX_DIVISIONS: int = 4
const MAX_POINTS: int = 4_000_000
const _HEAD: int = 8 + 4 + 32

## Keys of the parts, and how many vertices each has.
var keys: PackedStringArray = []
var counts: PackedInt32Array = []
## A hash of what was baked: of the vertices of all parts.
var source_hash: PackedByteArray = []
## Light of the vertices of all parts, one part after the other.
var light: PackedByteArray = []
## Light in the air: corner with the least coordinates, distances and numbers of the points, m, and
## [constant POINT_SIZE] bytes for each (see LevelTracer.make_grid).
var grid_origin: Vector3 = Vector3.ZERO
var grid_spacing: Vector3 = Vector3.ONE
var grid_counts: Vector3i = Vector3i.ZERO
var grid: PackedByteArray = []
## Cells: corner with the least coordinates, edge, m, and numbers along each axis.
var cell_origin: Vector3 = Vector3.ZERO
var cell_size: float = 4.0
var cell_counts: Vector3i = Vector3i.ZERO
## A byte for each small cell and part, parts fastest: 1 if some of the part is seen from the cell.
var seen_parts: PackedByteArray = []
## Small cells along the edge of a cell: sets of parts have smaller cells than sight between cells.
var divisions: int = 1
## A byte for each pair of cells (from, to): 1 if the one is seen from the other.
var seen_cells: PackedByteArray = []
## Why it could not be read; empty if it could.
var error: String = ""


## A hash of the parts of a level.
static func hash_of(p_parts: Array[SurfacePart]) -> PackedByteArray:
	var context: HashingContext = HashingContext.new()
	context.start(HashingContext.HASH_SHA256)
	for part: SurfacePart in p_parts:
		context.update(part.key.to_utf8_buffer())
		context.update(part.mesh.get_points().to_byte_array())
	return context.finish()


## Whether its light fits parts: the same ones with as many vertices.
func fits(p_parts: Array[SurfacePart]) -> bool:
	if p_parts.size() != keys.size():
		return false
	for index: int in keys.size():
		if p_parts[index].key != keys[index]:
			return false
		if p_parts[index].mesh.get_vertex_count() != counts[index]:
			return false
	return true


## The light of a part's vertices.
func light_of(p_part: int) -> PackedByteArray:
	var first: int = 0
	for index: int in p_part:
		first += counts[index]
	return light.slice(first * LIGHT_SIZE, (first + counts[p_part]) * LIGHT_SIZE)


## How much it holds, for people.
func describe() -> String:
	var vertices: int = light.size() / LIGHT_SIZE
	var cells: int = cell_counts.x * cell_counts.y * cell_counts.z
	var text: String = "%d parts, %d vertices, " % [keys.size(), vertices]
	text += "%d points in the air" % (grid.size() / POINT_SIZE)
	if cells == 0 or seen_parts.is_empty():
		return text
	var parts: float = 100.0 * seen_parts.count(1) / seen_parts.size()
	var open: float = 100.0 * seen_cells.count(1) / seen_cells.size()
	text += ", %d cells that see %.0f %% of the parts and " % [cells, parts]
	return text + "%.0f %% of the cells" % open


## Number of the cell in which a point of the level lies, or -1.
func cell_at(p_point: Vector3) -> int:
	var at: Vector3i = Vector3i(((p_point - cell_origin) / cell_size).floor())
	if at.clamp(Vector3i.ZERO, cell_counts - Vector3i.ONE) != at:
		return -1
	return (at.x * cell_counts.z + at.z) * cell_counts.y + at.y


## Number of the small cell in which a point of the level lies, or -1: of [member seen_parts].
func small_cell_at(p_point: Vector3) -> int:
	var at: Vector3i = Vector3i(((p_point - cell_origin) / cell_size * divisions).floor())
	var many: Vector3i = cell_counts * divisions
	if at.clamp(Vector3i.ZERO, many - Vector3i.ONE) != at:
		return -1
	return (at.x * many.z + at.z) * many.y + at.y


## Writes the file; returns what went wrong, or OK.
func save_file(p_path: String) -> Error:
	var body: PackedByteArray = []
	body.append_array(_packed(Section.PARTS, _parts_bytes()))
	body.append_array(_packed(Section.LIGHT, light))
	body.append_array(
		_packed(Section.GRID, _box_bytes(grid_origin, grid_spacing, grid_counts) + grid)
	)
	var edge: Vector3 = Vector3.ONE * cell_size
	body.append_array(_packed(Section.CELLS, _box_bytes(cell_origin, edge, cell_counts)))
	body.append_array(_packed(Section.SEEN_PARTS, seen_parts))
	body.append_array(_packed(Section.SEEN_CELLS, seen_cells))
	var file: FileAccess = FileAccess.open(p_path + ".part", FileAccess.WRITE)
	if file == null:
		return FileAccess.get_open_error()
	file.store_buffer(MAGIC.to_ascii_buffer())
	file.store_32(VERSION)
	file.store_buffer(_sha256(body))
	file.store_buffer(body)
	file.close()
	return DirAccess.rename_absolute(p_path + ".part", p_path)


## Reads a file. Where it cannot be read, [member error] names the file and the reason.
static func load_file(p_path: String) -> LevelBake:
	var bake: LevelBake = LevelBake.new()
	var file: FileAccess = FileAccess.open(p_path, FileAccess.READ)
	if file == null:
		bake.error = "%s: %s" % [p_path, error_string(FileAccess.get_open_error())]
	elif file.get_length() > MAX_BYTES:
		bake.error = "%s: larger than %d bytes" % [p_path, MAX_BYTES]
	else:
		var why: String = bake.read(file.get_buffer(file.get_length()))
		bake.error = "%s: %s" % [p_path, why] if why != "" else ""
	return bake


## Reads the bytes of a file. Returns why it cannot, or an empty text.
func read(p_bytes: PackedByteArray) -> String:
	if p_bytes.size() < _HEAD or p_bytes.slice(0, 8) != MAGIC.to_ascii_buffer():
		return "it is no baked level"
	var version: int = p_bytes.decode_u32(8)
	if version != VERSION:
		return "it has version %d; this program reads %d" % [version, VERSION]
	var body: PackedByteArray = p_bytes.slice(_HEAD)
	if _sha256(body) != p_bytes.slice(12, _HEAD):
		return "it is damaged: its SHA-256 is another"
	var sections: Dictionary[int, PackedByteArray] = {}
	var at: int = 0
	while at + 12 <= body.size():
		var size: int = body.decode_u32(at + 4)
		var packed: int = body.decode_u32(at + 8)
		if size > MAX_SECTION or packed > body.size() - at - 12:
			return "section %d is longer than it may be" % body.decode_u32(at)
		var bytes: PackedByteArray = body.slice(at + 12, at + 12 + packed)
		if size > 0:
			bytes = bytes.decompress(size, FileAccess.COMPRESSION_ZSTD)
		if bytes.size() != size:
			return "section %d cannot be unpacked" % body.decode_u32(at)
		sections[body.decode_u32(at)] = bytes
		at += 12 + packed
	return _take(sections)


func _take(p_sections: Dictionary[int, PackedByteArray]) -> String:
	for section: int in Section.values():
		if not p_sections.has(section):
			return "section %d is missing" % section
	if not _take_parts(p_sections[Section.PARTS]):
		return "its list of parts is broken"
	light = p_sections[Section.LIGHT]
	var vertices: int = 0
	for count: int in counts:
		vertices += count
	if light.size() != vertices * LIGHT_SIZE:
		return "it has light for %d bytes, not for %d vertices" % [light.size(), vertices]
	if not _take_grid(p_sections[Section.GRID]):
		return "its grid of light is broken"
	if not _take_cells(p_sections):
		return "its cells are broken"
	return ""


func _take_parts(p_bytes: PackedByteArray) -> bool:
	var reader: ByteReader = ByteReader.new(p_bytes)
	source_hash = reader.read_bytes(32)
	var count: int = reader.read_u32()
	if count > MAX_PARTS:
		return false
	for index: int in count:
		keys.append(reader.read_text(4 * SurfacePart.MAX_KEY))
		counts.append(reader.read_u32() & 0xffffff)
	return reader.is_complete()


func _take_grid(p_bytes: PackedByteArray) -> bool:
	if p_bytes.size() < 36:
		return false
	grid_origin = _vector(p_bytes, 0)
	grid_spacing = _vector(p_bytes, 12)
	grid_counts = Vector3i(_vector(p_bytes, 24))
	grid = p_bytes.slice(36)
	return (
		_is_box(grid_origin, grid_spacing, grid_counts, MAX_POINTS, true)
		and (grid.size() == grid_counts.x * grid_counts.y * grid_counts.z * POINT_SIZE)
	)


func _take_cells(p_sections: Dictionary[int, PackedByteArray]) -> bool:
	var bytes: PackedByteArray = p_sections[Section.CELLS]
	if bytes.size() != 36:
		return false
	cell_origin = _vector(bytes, 0)
	cell_size = _vector(bytes, 12).x
	cell_counts = Vector3i(_vector(bytes, 24))
	if not _is_box(cell_origin, Vector3.ONE * cell_size, cell_counts, MAX_CELLS, true):
		return false
	var cells: int = cell_counts.x * cell_counts.y * cell_counts.z
	seen_parts = p_sections[Section.SEEN_PARTS]
	seen_cells = p_sections[Section.SEEN_CELLS]
	# The number of bytes gives the size of the cells of the sets.
	divisions = 1
	while divisions < MAX_DIVISIONS and seen_parts.size() > cells * divisions ** 3 * keys.size():
		divisions += 1
	return (
		seen_parts.size() == cells * divisions ** 3 * keys.size()
		and seen_cells.size() == cells * cells
	)


static func _is_box(
	p_origin: Vector3, p_spacing: Vector3, p_counts: Vector3i, p_most: int, p_may_be_empty: bool
) -> bool:
	if (
		not p_origin.is_finite()
		or not p_spacing.is_finite()
		or p_spacing[p_spacing.min_axis_index()] <= 0.0
	):
		return false
	if p_counts == Vector3i.ZERO:
		return p_may_be_empty
	if p_counts[p_counts.min_axis_index()] < 1 or p_counts[p_counts.max_axis_index()] > p_most:
		return false
	return p_counts.x * p_counts.y * p_counts.z <= p_most


func _parts_bytes() -> PackedByteArray:
	var bytes: PackedByteArray = source_hash.duplicate()
	bytes.resize(32 + 4)
	bytes.encode_u32(32, keys.size())
	for index: int in keys.size():
		bytes.append_array(ByteReader.text_bytes(keys[index]))
		bytes.resize(bytes.size() + 4)
		bytes.encode_u32(bytes.size() - 4, counts[index])
	return bytes


static func _box_bytes(
	p_origin: Vector3, p_spacing: Vector3, p_counts: Vector3i
) -> PackedByteArray:
	return PackedVector3Array([p_origin, p_spacing, Vector3(p_counts)]).to_byte_array()


static func _vector(p_bytes: PackedByteArray, p_at: int) -> Vector3:
	return Vector3(
		p_bytes.decode_float(p_at), p_bytes.decode_float(p_at + 4), p_bytes.decode_float(p_at + 8)
	)


static func _packed(p_section: Section, p_bytes: PackedByteArray) -> PackedByteArray:
	var packed: PackedByteArray = []
	if not p_bytes.is_empty():
		packed = p_bytes.compress(FileAccess.COMPRESSION_ZSTD)
	var head: PackedByteArray = []
	head.resize(12)
	head.encode_u32(0, p_section)
	head.encode_u32(4, p_bytes.size())
	head.encode_u32(8, packed.size())
	return head + packed


static func _sha256(p_bytes: PackedByteArray) -> PackedByteArray:
	var context: HashingContext = HashingContext.new()
	context.start(HashingContext.HASH_SHA256)
	context.update(p_bytes)
	return context.finish()

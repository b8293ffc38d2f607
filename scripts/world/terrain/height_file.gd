@tool
class_name HeightFile
extends RefCounted
## Reads and writes files of a [HeightField], [code]*.height[/code]. A file may come from a
## stranger: nothing is believed, and nothing is allocated beyond what its checked size allows.
##
## Little-endian: 4 bytes [code]DMTH[/code], u16 version, u16 0, u32 columns, u32 rows, f32 distance
## of points, m, u32 length of what follows, then, compressed by Zstandard: f32 heights (m), 4 bytes
## of paint for each point, a byte of light for each point.

## First bytes of a file.
const MAGIC: String = "DMTH"
## Version of the format.
const VERSION: int = 1
## Bytes before the compressed part.
const HEADER: int = 24
## Most points: more would cost a client too much.
const MAX_POINTS: int = 4097 * 4097
## Bytes for each point: height, paint, light.
const POINT_BYTES: int = 9

## The field, or null if the file is invalid.
var field: HeightField = null
## Its lowest and highest point, m.
var lowest_m: float = 0.0
var highest_m: float = 0.0
## Why it is invalid, or an empty text.
var error: String = ""


## Reads a file.
static func read(p_path: String) -> HeightFile:
	var bytes: PackedByteArray = FileAccess.get_file_as_bytes(p_path)
	if bytes.is_empty():
		var result: HeightFile = HeightFile.new()
		result.error = "%s cannot be read: %s" % [p_path, error_string(FileAccess.get_open_error())]
		return result
	return parse(bytes)


## Reads the bytes of a file.
static func parse(p_bytes: PackedByteArray) -> HeightFile:
	var result: HeightFile = HeightFile.new()
	result.error = result._parse(p_bytes)
	if result.error != "":
		result.field = null
	return result


## Writes a field. Returns an empty text, or why it cannot.
static func write(p_path: String, p_field: HeightField) -> String:
	var file: FileAccess = FileAccess.open(p_path, FileAccess.WRITE)
	if file == null:
		return "%s cannot be written: %s" % [p_path, error_string(FileAccess.get_open_error())]
	file.store_buffer(encode(p_field))
	file.close()
	return ""


## A field as the bytes of a file. Heights are rounded to 1/1024 m, which compresses better.
static func encode(p_field: HeightField) -> PackedByteArray:
	var heights: PackedFloat32Array = p_field.heights.duplicate()
	for index: int in heights.size():
		heights[index] = roundf(heights[index] * 1024.0) / 1024.0
	var body: PackedByteArray = heights.to_byte_array() + p_field.paint + p_field.light
	body = body.compress(FileAccess.COMPRESSION_ZSTD)
	var bytes: PackedByteArray = MAGIC.to_ascii_buffer()
	bytes.resize(HEADER)
	bytes.encode_u16(4, VERSION)
	bytes.encode_u32(8, p_field.columns)
	bytes.encode_u32(12, p_field.rows)
	bytes.encode_float(16, p_field.cell_m)
	bytes.encode_u32(20, body.size())
	return bytes + body


func _parse(p_bytes: PackedByteArray) -> String:
	if p_bytes.size() < HEADER or p_bytes.slice(0, 4) != MAGIC.to_ascii_buffer():
		return "this is no file of heights: it does not begin with %s" % MAGIC
	if p_bytes.decode_u16(4) != VERSION:
		return "heights of version %d: this program knows %d" % [p_bytes.decode_u16(4), VERSION]
	field = HeightField.new()
	field.columns = p_bytes.decode_u32(8)
	field.rows = p_bytes.decode_u32(12)
	field.cell_m = p_bytes.decode_float(16)
	for side: int in [field.columns, field.rows]:
		if side < HeightField.MIN_SIDE or side > HeightField.MAX_SIDE:
			var limits: Array = [side, HeightField.MIN_SIDE, HeightField.MAX_SIDE]
			return "a side of %d points: it must be %d to %d" % limits
	# A comparison that NaN fails, too.
	if not (field.cell_m >= HeightField.MIN_CELL_M and field.cell_m <= HeightField.MAX_CELL_M):
		return "points at a distance of %f m" % field.cell_m
	if p_bytes.decode_u32(20) != p_bytes.size() - HEADER:
		return "the file is cut off or too long"
	return _unpack(p_bytes.slice(HEADER))


func _unpack(p_body: PackedByteArray) -> String:
	# The frame must say its size itself: the engine's decompressor complains about all else.
	var points: int = field.points()
	if _frame_size(p_body) != points * POINT_BYTES:
		return "its content is not that of %d points" % points
	var body: PackedByteArray = p_body.decompress(points * POINT_BYTES, FileAccess.COMPRESSION_ZSTD)
	if body.size() != points * POINT_BYTES:
		return "its content is damaged"
	field.heights = body.slice(0, points * 4).to_float32_array()
	field.paint = body.slice(points * 4, points * 8)
	field.light = body.slice(points * 8)
	var most: float = HeightField.MAX_HEIGHT_M
	lowest_m = most
	highest_m = -most
	for height: float in field.heights:
		# Few are lowest or highest so far; NaN is neither inside nor outside.
		if not (height >= lowest_m and height <= highest_m):
			if not (absf(height) <= most):
				return "a height of %f m" % height
			lowest_m = minf(lowest_m, height)
			highest_m = maxf(highest_m, height)
	return ""


## Size of the content that a Zstandard frame declares, or -1.
static func _frame_size(p_frame: PackedByteArray) -> int:
	if p_frame.size() < 14 or p_frame.decode_u32(0) != 0xFD2FB528:
		return -1
	var descriptor: int = p_frame[4]
	var is_single: bool = (descriptor & 0x20) != 0
	# No dictionaries: 4 to 8 bytes of window and size follow.
	if (descriptor & 0x03) != 0 or (descriptor & 0x08) != 0:
		return -1
	var at: int = 5 if is_single else 6
	match descriptor >> 6:
		0:
			return p_frame[at] if is_single else -1
		1:
			return p_frame.decode_u16(at) + 256
		2:
			return p_frame.decode_u32(at)
	return p_frame.decode_s64(at)

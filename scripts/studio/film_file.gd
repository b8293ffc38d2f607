@tool
class_name FilmFile
extends RefCounted
## A film of pictures without sound: AVI with a JPEG picture a frame, which every player knows.

## Longest film, frames.
const MAX_FRAMES: int = 1800
const QUALITY: float = 0.9

## Where it is.
var path: String = ""

var _file: FileAccess = null
var _size: Vector2i = Vector2i.ZERO
var _rate: int = 30
var _index: PackedByteArray = []
var _frames: int = 0
var _data_bytes: int = 4


## Opens a film for pictures of a size, pixels, at so many a second. Returns why it cannot be
## written, or an empty text.
func open(p_path: String, p_size: Vector2i, p_rate: int) -> String:
	_file = FileAccess.open(p_path, FileAccess.WRITE)
	if _file == null:
		return "%s cannot be written: %s" % [p_path, error_string(FileAccess.get_open_error())]
	path = p_path
	_size = p_size
	_rate = p_rate
	_index.clear()
	_frames = 0
	_data_bytes = 4
	_store_header()
	return ""


## Frames so far.
func frames() -> int:
	return _frames


## Adds a picture.
func add(p_image: Image) -> void:
	if _file == null or _frames >= MAX_FRAMES:
		return
	if p_image.get_size() != _size:
		p_image.resize(_size.x, _size.y)
	var picture: PackedByteArray = p_image.save_jpg_to_buffer(QUALITY)
	var length: int = picture.size()
	if length % 2 == 1:
		picture.append(0)
	_index.append_array("00dc".to_ascii_buffer())
	_index.append_array(PackedInt32Array([16, _data_bytes, length]).to_byte_array())
	_file.store_buffer("00dc".to_ascii_buffer())
	_file.store_32(length)
	_file.store_buffer(picture)
	_data_bytes += 8 + picture.size()
	_frames += 1


## Ends the film: now it can be played.
func close() -> void:
	if _file == null:
		return
	_file.store_buffer("idx1".to_ascii_buffer())
	_file.store_32(_index.size())
	_file.store_buffer(_index)
	_file.seek(0)
	_store_header()
	_file = null


## 224 bytes; written again at the end, when the numbers are known.
func _store_header() -> void:
	var total: int = 212 + _data_bytes + 8 + _index.size()
	_store("RIFF", [total])
	_store("AVI LIST", [192])
	_store("hdrlavih", [56, 1000000 / _rate, 0, 0, 16, _frames, 0, 1, 0, _size.x, _size.y])
	_store("", [0, 0, 0, 0])
	_store("LIST", [116])
	_store("strlstrh", [56])
	_store("vidsMJPG", [0, 0, 0, 1, _rate, 0, _frames, 0, -1, 0, 0, _size.x | _size.y << 16])
	_store("strf", [40, 40, _size.x, _size.y, 1 | 24 << 16])
	_store("MJPG", [_size.x * _size.y * 3, 0, 0, 0, 0])
	_store("LIST", [_data_bytes])
	_store("movi", [])


func _store(p_name: String, p_numbers: PackedInt32Array) -> void:
	_file.store_buffer(p_name.to_ascii_buffer())
	_file.store_buffer(p_numbers.to_byte_array())

class_name WebcamPicture
extends RefCounted
## What a webcam sees, for a panel: its newest small picture, and where people's landmarks are in
## it. One thread gives it, another one shows it.

## Pairs of landmarks between which a skeleton has a line.
const LINES: Array[Vector2i] = [
	Vector2i(11, 12),
	Vector2i(23, 24),
	Vector2i(11, 23),
	Vector2i(12, 24),
	Vector2i(11, 13),
	Vector2i(13, 15),
	Vector2i(15, 19),
	Vector2i(12, 14),
	Vector2i(14, 16),
	Vector2i(16, 20),
	Vector2i(23, 25),
	Vector2i(25, 27),
	Vector2i(27, 31),
	Vector2i(24, 26),
	Vector2i(26, 28),
	Vector2i(28, 32),
	Vector2i(0, 7),
	Vector2i(0, 8),
]
## A person of whom nothing has come for this time is not shown, µs.
const _SHOWN_USEC: int = 500000
## The greatest side of a picture, px.
const _MAX_PX: int = 1024
## Broken pictures after which no more are looked at.
const _MAX_BROKEN: int = 3

var _mutex: Mutex = Mutex.new()
var _jpeg: PackedByteArray = PackedByteArray()
var _number: int = 0
var _broken: int = 0
var _people: Dictionary[String, PackedVector3Array] = {}
var _usec: Dictionary[String, int] = {}


## Whether bytes begin as a JPEG does.
static func is_jpeg(p_bytes: PackedByteArray) -> bool:
	return p_bytes.size() > 3 and p_bytes.decode_u16(0) == 0xD8FF


## Takes a picture: a JPEG.
func take_picture(p_jpeg: PackedByteArray) -> void:
	_mutex.lock()
	_jpeg = p_jpeg
	_number += 1
	_mutex.unlock()


## Takes a person's landmarks at a time, µs: x and y in widths of the picture, from its top left
## corner, and how well each is seen.
func take_person(p_person: String, p_points: PackedVector3Array, p_usec: int) -> void:
	_mutex.lock()
	if _people.size() < PoseStream.MAX_PEOPLE or _people.has(p_person):
		_people[p_person] = p_points
		_usec[p_person] = p_usec
	_mutex.unlock()


## How many pictures have come.
func count() -> int:
	_mutex.lock()
	var found: int = _number
	_mutex.unlock()
	return found


## The newest picture, or null where there is none yet, or it is broken or large.
func image() -> Image:
	_mutex.lock()
	var jpeg: PackedByteArray = _jpeg
	_mutex.unlock()
	var size: Vector2i = size_of(jpeg)
	if _broken >= _MAX_BROKEN or mini(size.x, size.y) < 1 or maxi(size.x, size.y) > _MAX_PX:
		return null
	var found: Image = Image.new()
	if found.load_jpg_from_buffer(jpeg) == OK:
		return found
	# The engine complains of each: nobody is to fill the log with that.
	_broken += 1
	return null


## The size that a JPEG says it has, px; 0, 0 where it does not say.
static func size_of(p_jpeg: PackedByteArray) -> Vector2i:
	var at: int = 2
	while at + 9 <= p_jpeg.size() and p_jpeg[at] == 0xFF:
		var mark: int = p_jpeg[at + 1]
		# Begin of a frame: baseline or progressive. Its height and width are big-endian.
		if mark == 0xC0 or mark == 0xC2:
			var height: int = p_jpeg[at + 5] << 8 | p_jpeg[at + 6]
			return Vector2i(p_jpeg[at + 7] << 8 | p_jpeg[at + 8], height)
		at += 2 + (p_jpeg[at + 2] << 8 | p_jpeg[at + 3])
	return Vector2i.ZERO


## Landmarks of those who are seen at a time, µs.
func people(p_now_usec: int) -> Array[PackedVector3Array]:
	var found: Array[PackedVector3Array] = []
	_mutex.lock()
	for person: String in _people.keys():
		if p_now_usec - _usec[person] > _SHOWN_USEC:
			_people.erase(person)
			_usec.erase(person)
		else:
			found.append(_people[person])
	_mutex.unlock()
	return found

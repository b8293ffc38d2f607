class_name WalkerSet
extends RefCounted
## The motion set of one person who walks by a gait of his own: the bytes of a file, read and
## checked. Both ends read it in the same way.

## What stands for the set of everybody who has none, in reports.
const SHIPPED: String = "shipped"

## The set; null where the bytes are none that a walker can go by.
var motion: MotionSet = null
## The first 16 hexadecimal digits of the file's SHA-256.
var id: String = ""
## What is wrong with it, or an empty text.
var error: String = ""


## Reads the bytes of a file, some 15 ms for each MB: at a server not in the main thread.
static func read(p_bytes: PackedByteArray) -> WalkerSet:
	var made: WalkerSet = WalkerSet.new()
	made._read(p_bytes)
	return made


## Says that a set is too large.
static func describe_limit() -> String:
	var most: float = MotionSetMessage.MAX_BYTES / 1e6
	return "it is larger than %.1f MB, the most that a walker's set may have" % most


func _read(p_bytes: PackedByteArray) -> void:
	if p_bytes.size() > MotionSetMessage.MAX_BYTES:
		error = describe_limit()
		return
	var found: MotionSet = MotionSet.new()
	error = found.load_bytes(p_bytes)
	if error != "":
		return
	var missing: PackedStringArray = MotionSetFill.find_missing(found)
	if not missing.is_empty():
		error = "it lacks %s: nobody can walk by it" % " and ".join(missing)
		return
	motion = found
	var context: HashingContext = HashingContext.new()
	context.start(HashingContext.HASH_SHA256)
	context.update(p_bytes)
	id = context.finish().hex_encode().left(16)

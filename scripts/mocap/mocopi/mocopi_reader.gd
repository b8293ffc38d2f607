class_name MocopiReader
extends StreamReader
## Reads the UDP stream of Sony's mocopi app: boxes of a length, a name of four letters and what is
## in them, which may be boxes again (described by seagetch/mcp-receiver and
## t-34400/mocopi_protocol_supplement). Little-endian; Y up, right-handed, metres, the left to +X:
## Godot's frame. Rotations are on the bone above; "skdf" says how the bones lie at rest.

## Names of boxes, as numbers.
const HEAD: int = 0x64616568
const SKDF: int = 0x66646B73
const FRAM: int = 0x6D617266
const FTYP: int = 0x70797466
const FNUM: int = 0x6D756E66
const TIME: int = 0x656D6974
const UTTM: int = 0x6D747475
const BONS: int = 0x736E6F62
const BNDT: int = 0x74646E62
const BTRS: int = 0x73727462
const BTDT: int = 0x74647462
const BNID: int = 0x64696E62
const TRAN: int = 0x6E617274
## Name of the format in the header.
const FORMAT: String = "sony motion format"
## Number of bones, and the parent of each.
const BONES: int = 27
const PARENTS: PackedInt32Array = [
	-1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 7, 11, 12, 13, 7, 15, 16, 17, 0, 19, 20, 21, 0, 23, 24, 25
]
## Joint of each bone, -1 for those between joints: seven of the trunk, two of the neck. The arms
## hang on the seventh of the trunk.
const JOINTS: PackedInt32Array = [
	XRBodyTracker.JOINT_HIPS,
	-1,
	-1,
	XRBodyTracker.JOINT_SPINE,
	-1,
	XRBodyTracker.JOINT_CHEST,
	-1,
	XRBodyTracker.JOINT_UPPER_CHEST,
	XRBodyTracker.JOINT_NECK,
	-1,
	XRBodyTracker.JOINT_HEAD,
	XRBodyTracker.JOINT_LEFT_SHOULDER,
	XRBodyTracker.JOINT_LEFT_UPPER_ARM,
	XRBodyTracker.JOINT_LEFT_LOWER_ARM,
	XRBodyTracker.JOINT_LEFT_HAND,
	XRBodyTracker.JOINT_RIGHT_SHOULDER,
	XRBodyTracker.JOINT_RIGHT_UPPER_ARM,
	XRBodyTracker.JOINT_RIGHT_LOWER_ARM,
	XRBodyTracker.JOINT_RIGHT_HAND,
	XRBodyTracker.JOINT_LEFT_UPPER_LEG,
	XRBodyTracker.JOINT_LEFT_LOWER_LEG,
	XRBodyTracker.JOINT_LEFT_FOOT,
	XRBodyTracker.JOINT_LEFT_TOES,
	XRBodyTracker.JOINT_RIGHT_UPPER_LEG,
	XRBodyTracker.JOINT_RIGHT_LOWER_LEG,
	XRBodyTracker.JOINT_RIGHT_FOOT,
	XRBodyTracker.JOINT_RIGHT_TOES,
]
## Bytes of a rotation and a position.
const _TRAN_BYTES: int = 28
## Greatest number of boxes that are read in one datagram.
const _MAX_BOXES: int = 512
## Greatest number of senders whose bones at rest are kept.
const _MAX_SENDERS: int = 16

var _rest: Dictionary[String, Array] = {}
var _builder: PoseBuilder = PoseBuilder.new()
var _bytes: PackedByteArray = PackedByteArray()
var _turns: Array[Quaternion] = []
var _places: PackedVector3Array = PackedVector3Array()
var _known: PackedByteArray = PackedByteArray()
var _counter: int = -1
var _usec: int = -1
var _boxes: int = 0


func _init() -> void:
	_turns.resize(BONES)
	_places.resize(BONES)
	_known.resize(BONES)


func title() -> String:
	return "mocopi"


func read(p_bytes: PackedByteArray, p_sender: String) -> Array[StreamSample]:
	_bytes = p_bytes
	_known.fill(0)
	_counter = -1
	_usec = -1
	_boxes = 0
	var kind: int = 0
	var at: int = 0
	while at < p_bytes.size():
		var end: int = _end_of(at, p_bytes.size())
		if end < 0:
			return []
		var name: int = p_bytes.decode_u32(at + 4)
		if name == HEAD and not _is_format(at + 8, end):
			return refuse("its header is not of '%s'" % FORMAT)
		if name == SKDF or name == FRAM:
			kind = name
			if not _read_part(at + 8, end):
				return []
		at = end
	if kind == 0:
		return refuse("it has neither 'skdf' nor 'fram'")
	if _known[0] == 0:
		return refuse("it lacks the hips (bone 0)")
	if kind == SKDF:
		_keep_rest(p_sender)
		return []
	return _sample(_rest.get(p_sender, []))


## End of the box that begins at an offset, or -1 if no box can begin there.
func _end_of(p_at: int, p_limit: int) -> int:
	_boxes += 1
	if p_limit - p_at < 8 or _boxes > _MAX_BOXES:
		fault = "%d bytes are left where a box of 8 or more begins" % (p_limit - p_at)
		return -1
	var size: int = _bytes.decode_u32(p_at)
	if size > p_limit - p_at - 8:
		fault = "a box of %d bytes where %d are left" % [size, p_limit - p_at - 8]
		return -1
	return p_at + 8 + size


func _is_format(p_begin: int, p_end: int) -> bool:
	var end: int = _end_of(p_begin, p_end)
	if end < 0 or _bytes.decode_u32(p_begin + 4) != FTYP:
		return false
	return _bytes.slice(p_begin + 8, end) == FORMAT.to_ascii_buffer()


## Reads what is in "skdf", "fram", "bons" or "btrs". Returns false where it can't be read.
func _read_part(p_begin: int, p_end: int) -> bool:
	var at: int = p_begin
	while at < p_end:
		var end: int = _end_of(at, p_end)
		if end < 0:
			return false
		match _bytes.decode_u32(at + 4):
			FNUM:
				_counter = _bytes.decode_u32(at + 8) if end - at >= 12 else -1
			TIME:
				# Seconds since the app began; the time of day is more exact, and comes behind.
				var time_s: float = _bytes.decode_float(at + 8) if end - at >= 12 else NAN
				if _usec < 0 and time_s > 0.0 and time_s < 1e8:
					_usec = roundi(time_s * 1e6)
			UTTM:
				var unix_s: float = _bytes.decode_double(at + 8) if end - at >= 16 else NAN
				if unix_s > 0.0 and unix_s < 1e11:
					_usec = roundi(unix_s * 1e6)
			BONS, BTRS:
				if not _read_part(at + 8, end):
					return false
			BNDT, BTDT:
				if not _read_bone(at + 8, end):
					return false
		at = end
	return true


func _read_bone(p_begin: int, p_end: int) -> bool:
	var bone: int = -1
	var at: int = p_begin
	while at < p_end:
		var end: int = _end_of(at, p_end)
		if end < 0:
			return false
		var name: int = _bytes.decode_u32(at + 4)
		if name == BNID and end - at >= 10:
			bone = _bytes.decode_u16(at + 8)
		elif name == TRAN and bone >= 0 and bone < BONES:
			if end - at < 8 + _TRAN_BYTES:
				fault = "bone %d has %d bytes instead of %d" % [bone, end - at - 8, _TRAN_BYTES]
				return false
			return _take(bone, at + 8)
		at = end
	return true


func _take(p_bone: int, p_at: int) -> bool:
	var turn: Quaternion = Quaternion(
		_bytes.decode_float(p_at),
		_bytes.decode_float(p_at + 4),
		_bytes.decode_float(p_at + 8),
		_bytes.decode_float(p_at + 12)
	)
	var place: Vector3 = Vector3(
		_bytes.decode_float(p_at + 16),
		_bytes.decode_float(p_at + 20),
		_bytes.decode_float(p_at + 24)
	)
	# A comparison that NaN fails, too.
	if not absf(turn.length() - 1.0) < 0.1 or not place.length() < 1e4:
		fault = "bone %d has no rotation or place (%s, %s)" % [p_bone, turn, place]
		return false
	_turns[p_bone] = turn.normalized()
	_places[p_bone] = place
	_known[p_bone] = 1
	return true


## Keeps the global rotations of the bones at rest, and the height of the hips.
func _keep_rest(p_sender: String) -> void:
	if _rest.size() >= _MAX_SENDERS and not _rest.has(p_sender):
		_rest.erase(_rest.keys()[0])
	var turns: Array[Quaternion] = []
	for bone: int in BONES:
		var above: int = PARENTS[bone]
		var local: Quaternion = _turns[bone] if _known[bone] != 0 else Quaternion.IDENTITY
		turns.append(local if above < 0 else (turns[above] * local).normalized())
	_rest[p_sender] = [turns, _places[0].y, _places.duplicate()]


func _sample(p_rest: Array) -> Array[StreamSample]:
	var sample: StreamSample = StreamSample.new()
	_builder.clear()
	var turns: Array[Quaternion] = []
	var places: PackedVector3Array = []
	for bone: int in BONES:
		var above: int = PARENTS[bone]
		var turn: Quaternion = _turns[bone] if _known[bone] != 0 else Quaternion.IDENTITY
		var place: Vector3 = _places[bone]
		if _known[bone] == 0:
			place = p_rest[2][bone] if not p_rest.is_empty() else Vector3.ZERO
		if above >= 0:
			place = places[above] + turns[above] * place
			turn = (turns[above] * turn).normalized()
		turns.append(turn)
		places.append(place)
		if JOINTS[bone] >= 0:
			if not p_rest.is_empty():
				turn = turn * (p_rest[0][bone] as Quaternion).inverse()
			_builder.set_turn(JOINTS[bone], turn)
			_builder.set_position(JOINTS[bone], place)
	sample.pose = _builder.build()
	sample.hip_height = p_rest[1] if not p_rest.is_empty() else 0.0
	sample.counter = _counter
	sample.source_usec = _usec
	var samples: Array[StreamSample] = []
	if sample.pose != null:
		samples.append(sample)
	return samples

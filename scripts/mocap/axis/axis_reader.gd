class_name AxisReader
extends StreamReader
## Reads the BVH stream of Axis Studio and Axis Neuron (Perception Neuron): binary frames with
## Noitom's header of 64 bytes (NeuronDataReader's BvhDataHeader, versions 1.0 and 1.1), or lines of
## text, by UDP or TCP. Bones come in the order of Noitom's skeleton; the rotation's order is to be
## YXZ, its default. Y up, right-handed, centimetres and degrees; on the bone above.

## Number of bones of the skeleton, and the parent of each.
const BONES: int = 59
const PARENTS: PackedInt32Array = [
	-1,
	0,
	1,
	2,
	0,
	4,
	5,
	0,
	7,
	8,
	9,
	10,
	11,
	9,
	13,
	14,
	15,
	16,
	17,
	18,
	16,
	20,
	21,
	22,
	16,
	24,
	25,
	26,
	16,
	28,
	29,
	30,
	16,
	32,
	33,
	34,
	9,
	36,
	37,
	38,
	39,
	40,
	41,
	39,
	43,
	44,
	45,
	39,
	47,
	48,
	49,
	39,
	51,
	52,
	53,
	39,
	55,
	56,
	57
]
## Joint of each bone, -1 for bones between joints; joints of fingers are counted from the hand's.
const JOINTS: PackedInt32Array = [
	XRBodyTracker.JOINT_HIPS,
	XRBodyTracker.JOINT_RIGHT_UPPER_LEG,
	XRBodyTracker.JOINT_RIGHT_LOWER_LEG,
	XRBodyTracker.JOINT_RIGHT_FOOT,
	XRBodyTracker.JOINT_LEFT_UPPER_LEG,
	XRBodyTracker.JOINT_LEFT_LOWER_LEG,
	XRBodyTracker.JOINT_LEFT_FOOT,
	XRBodyTracker.JOINT_SPINE,
	XRBodyTracker.JOINT_CHEST,
	XRBodyTracker.JOINT_UPPER_CHEST,
	-1,
	XRBodyTracker.JOINT_NECK,
	XRBodyTracker.JOINT_HEAD,
	XRBodyTracker.JOINT_RIGHT_SHOULDER,
	XRBodyTracker.JOINT_RIGHT_UPPER_ARM,
	XRBodyTracker.JOINT_RIGHT_LOWER_ARM,
	XRBodyTracker.JOINT_RIGHT_HAND,
]
## First bone of each arm, and joints of the fingers after its hand, counted from the hand's.
const RIGHT_ARM: int = 13
const LEFT_ARM: int = 36
const FINGERS: PackedInt32Array = [
	3, 4, 5, -1, 8, 9, 10, -1, 13, 14, 15, -1, 18, 19, 20, -1, 23, 24, 25
]
## A header's bytes, its first and its last two.
const HEADER: int = 64
const BEGIN: int = 0xDDFF
const END: int = 0xEEFF
## Values of one frame: with displacement, or the hips' position and rotations only.
const VALUES: int = BONES * 6
const FEW_VALUES: int = 3 + BONES * 3
## Number of values of the reference that comes before the bones, if the header says so.
const REFERENCE: int = 6
## Greatest number of bytes of a TCP stream that wait for the rest of their frame.
const MAX_WAITING: int = 1 << 18
const _MAX_SENDERS: int = 16
## Greatest number of frames that are read from one piece of data.
const _MAX_FRAMES: int = 64

## Whether it is a TCP stream, in which frames may come in pieces.
var is_tcp: bool = false

var _waiting: Dictionary[String, PackedByteArray] = {}
# Last values of each avatar of each sender, by both their names.
var _last_values: Dictionary[String, PackedFloat32Array] = {}
var _counted: int = 0
# Sender of the datagram that is being read.
var _sender: String = ""
var _builder: PoseBuilder = PoseBuilder.new()
var _turns: Array[Quaternion] = []
var _places: PackedVector3Array = PackedVector3Array()


func _init() -> void:
	_turns.resize(BONES)
	_places.resize(BONES)


func title() -> String:
	return "Axis Studio"


func read(p_bytes: PackedByteArray, p_sender: String) -> Array[StreamSample]:
	var samples: Array[StreamSample] = []
	_sender = p_sender
	var bytes: PackedByteArray = _waiting.get(p_sender, PackedByteArray())
	bytes.append_array(p_bytes)
	var at: int = 0
	for _number: int in _MAX_FRAMES:
		var next: int = _read_frame(bytes, at, samples)
		if next <= at:
			break
		at = next
	var rest: PackedByteArray = bytes.slice(at)
	if not is_tcp:
		# A datagram is whole; a line of text may lack its end.
		if at == 0 and bytes.size() > 2 and bytes.decode_u16(0) != BEGIN:
			_read_text(bytes, samples)
		elif not rest.is_empty():
			fault = "%d bytes at a datagram's end are no whole frame" % rest.size()
		return samples
	if rest.size() > MAX_WAITING:
		rest = PackedByteArray()
		fault = "no end of a frame in %d bytes" % MAX_WAITING
	_waiting.erase(p_sender)
	if not rest.is_empty():
		if _waiting.size() >= _MAX_SENDERS:
			_waiting.erase(_waiting.keys()[0])
		_waiting[p_sender] = rest
	return samples


## Joint of a bone, or -1.
static func joint_of(p_bone: int) -> int:
	if p_bone < JOINTS.size():
		return JOINTS[p_bone]
	var is_left: bool = p_bone >= LEFT_ARM
	var step: int = p_bone - (LEFT_ARM if is_left else RIGHT_ARM)
	if step < 4:
		var arm: PackedInt32Array = [
			XRBodyTracker.JOINT_LEFT_SHOULDER,
			XRBodyTracker.JOINT_LEFT_UPPER_ARM,
			XRBodyTracker.JOINT_LEFT_LOWER_ARM,
			XRBodyTracker.JOINT_LEFT_HAND,
		]
		return arm[step]
	var finger: int = FINGERS[step - 4]
	if finger < 0:
		return -1
	return finger + (XRBodyTracker.JOINT_LEFT_HAND if is_left else XRBodyTracker.JOINT_RIGHT_HAND)


## Reads one frame that begins at an offset. Returns the offset of the next one, or the same offset
## if more bytes are needed.
func _read_frame(p_bytes: PackedByteArray, p_at: int, r_samples: Array[StreamSample]) -> int:
	if p_bytes.size() - p_at < 2:
		return p_at
	if p_bytes.decode_u16(p_at) == BEGIN:
		return _read_binary(p_bytes, p_at, r_samples)
	var begin: int = _find_token(p_bytes, p_at)
	var end: int = p_bytes.find(0x7C, p_at)
	var line: int = p_bytes.find(0x0A, p_at)
	if end < 0 or (line >= 0 and line < end):
		end = line
	if begin >= 0 and (end < 0 or begin < end):
		fault = "%d bytes before a frame are skipped" % (begin - p_at)
		return begin
	if end < 0:
		return p_at
	_read_text(p_bytes.slice(p_at, end), r_samples)
	# A frame of text ends with "||", perhaps with the end of a line behind it.
	while end < p_bytes.size() and p_bytes[end] in [0x7C, 0x0A, 0x0D, 0x20, 0x00]:
		end += 1
	return end


static func _find_token(p_bytes: PackedByteArray, p_from: int) -> int:
	var at: int = p_bytes.find(0xFF, p_from)
	while at >= 0 and at + 1 < p_bytes.size():
		if p_bytes[at + 1] == 0xDD:
			return at
		at = p_bytes.find(0xFF, at + 1)
	return -1


func _read_binary(p_bytes: PackedByteArray, p_at: int, r_samples: Array[StreamSample]) -> int:
	if p_bytes.size() - p_at < HEADER:
		return p_at
	if p_bytes.decode_u16(p_at + HEADER - 2) != END:
		fault = "a header does not end with 0x%04X" % END
		return p_at + 2
	# Version 1.0 has numbers of four bytes where 1.1 has two and one.
	var is_old: bool = p_bytes[p_at + 4] == 0
	var count: int = p_bytes.decode_u32(p_at + 6) if is_old else p_bytes.decode_u16(p_at + 6)
	var with_places: bool = p_bytes[p_at + (10 if is_old else 8)] != 0
	var with_reference: bool = p_bytes[p_at + (14 if is_old else 9)] != 0
	if count > 4 * VALUES:
		fault = "a frame of %d values" % count
		return p_at + HEADER
	var end: int = p_at + HEADER + 4 * count
	if p_bytes.size() < end:
		return p_at
	var values: PackedFloat32Array = p_bytes.slice(p_at + HEADER, end).to_float32_array()
	var first: int = REFERENCE if with_reference else 0
	var sample: StreamSample = _sample(values.slice(first), with_places)
	if sample != null:
		var name_at: int = p_at + (22 if is_old else 14)
		sample.person = str(p_bytes.decode_u32(p_at + (18 if is_old else 10)))
		sample.name = _name(p_bytes.slice(name_at, name_at + 32))
		sample.counter = -1 if is_old else p_bytes.decode_u32(p_at + 46)
		r_samples.append(sample)
	return end


func _read_text(p_bytes: PackedByteArray, r_samples: Array[StreamSample]) -> void:
	var words: PackedStringArray = p_bytes.get_string_from_ascii().split(" ", false)
	if words.size() < 3 or not words[0].is_valid_int():
		fault = "a line of %d words is no frame" % words.size()
		return
	var values: PackedFloat32Array = []
	for at: int in range(2, mini(words.size(), 2 + 2 * VALUES)):
		if not words[at].is_valid_float() or words[at].length() > 24:
			fault = "a frame has '%s' where a number is" % ByteReader.clean(words[at]).left(20)
			return
		values.append(words[at].to_float())
	var with_places: bool = values.size() >= VALUES
	var needed: int = VALUES if with_places else FEW_VALUES
	if values.size() == needed + REFERENCE:
		values = values.slice(REFERENCE)
	# Text has no count: over UDP what is the same came twice. On a TCP stream nothing does.
	var who: String = _sender + " " + words[0].left(8)
	if not is_tcp and _last_values.get(who) == values:
		return
	if _last_values.size() >= _MAX_SENDERS and not _last_values.has(who):
		_last_values.clear()
	_last_values[who] = values
	var sample: StreamSample = _sample(values, with_places)
	if sample != null:
		# Nothing gets lost on a TCP stream, so frames can be counted here.
		_counted += 1
		sample.counter = _counted if is_tcp else -1
		sample.person = words[0].left(8)
		sample.name = ByteReader.clean(words[1]).left(32)
		r_samples.append(sample)


static func _name(p_bytes: PackedByteArray) -> String:
	var end: int = p_bytes.find(0)
	return ByteReader.clean(p_bytes.slice(0, end if end >= 0 else 32).get_string_from_ascii())


## The pose of a frame's values, or null.
func _sample(p_values: PackedFloat32Array, p_with_places: bool) -> StreamSample:
	var needed: int = VALUES if p_with_places else FEW_VALUES
	if p_values.size() < needed:
		fault = "a frame of %d values instead of %d" % [p_values.size(), needed]
		return null
	for value: float in p_values:
		# A comparison that NaN fails, too.
		if not absf(value) < 1e6:
			fault = "a frame has a value that is no angle and no place"
			return null
	_builder.clear()
	for bone: int in BONES:
		var at: int = bone * 6 if p_with_places or bone == 0 else 6 + (bone - 1) * 3
		var place: Vector3 = Vector3.ZERO
		if p_with_places or bone == 0:
			place = Vector3(p_values[at], p_values[at + 1], p_values[at + 2]) * 0.01
			at += 3
		var degrees: Vector3 = Vector3(p_values[at + 1], p_values[at], p_values[at + 2])
		# Godot's usual order is about Y, then the new X, then the new Z: YXZ.
		var turn: Quaternion = Quaternion.from_euler(degrees * (PI / 180.0))
		var above: int = PARENTS[bone]
		if above >= 0:
			place = _places[above] + _turns[above] * place
			turn = (_turns[above] * turn).normalized()
		_turns[bone] = turn
		_places[bone] = place
		var joint: int = joint_of(bone)
		if joint >= 0:
			_builder.set_turn(joint, turn)
			if p_with_places or bone == 0:
				_builder.set_position(joint, place)
	var sample: StreamSample = StreamSample.new()
	sample.pose = _builder.build()
	return sample if sample.pose != null else null

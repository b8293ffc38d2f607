class_name WireCodings
extends RefCounted
## Every coding that the thesis names (7.2 and 7.3), on one motion, beside ours.

## Bytes of a root's place as three floats.
const _ROOT_BYTES: int = 12

var _clip: WireClip
var _every: int
var _max_error: float
var _age: int


func _init(p_clip: WireClip, p_every: int, p_age: int, p_max_error: float) -> void:
	_clip = p_clip
	_every = p_every
	_age = p_age
	_max_error = p_max_error


## All of them, in the order of the table.
func all() -> Array[WireMessages]:
	var raw: WireMessages = _posed("floats and positions", PoseCodec.FLOATS, 15, true)
	var small: WireMessages = _posed("3 x 10 bits, whole bytes", PoseCodec.SMALLEST_3, 10, false)
	var numbers: WireMessages = _numbers(small)
	var result: Array[WireMessages] = [
		raw,
		_posed("floats", PoseCodec.FLOATS, 15, false),
		_posed("12 bytes and positions", PoseCodec.THESIS_12, 15, true),
		_posed("12 bytes", PoseCodec.THESIS_12, 15, false),
		_posed("4 bytes polar", PoseCodec.THESIS_4, 15, false),
		_posed("smallest three, 15 bits", PoseCodec.SMALLEST_3, 15, false),
		_posed("smallest three, 12 bits", PoseCodec.SMALLEST_3, 12, false),
		_posed("smallest three, 10 bits", PoseCodec.SMALLEST_3, 10, false),
		_only_changed("only what changed"),
		_reckoned("dead reckoning"),
		raw.compressed(FileAccess.COMPRESSION_DEFLATE, "floats and positions, deflate"),
		raw.compressed(FileAccess.COMPRESSION_ZSTD, "floats and positions, zstd"),
		raw.compressed_whole(
			FileAccess.COMPRESSION_DEFLATE, "floats and positions, deflate over all"
		),
		raw.compressed_whole(FileAccess.COMPRESSION_ZSTD, "floats and positions, zstd over all"),
		numbers.compressed_whole(FileAccess.COMPRESSION_ZSTD, "3 x 10 bits, zstd over all"),
	]
	var delta: WireMessages = numbers.differences("3 x 10 bits, differences")
	result.append(delta.compressed(FileAccess.COMPRESSION_DEFLATE, "3 x 10 bits, delta, deflate"))
	result.append(
		delta.compressed_whole(
			FileAccess.COMPRESSION_DEFLATE, "3 x 10 bits, delta, deflate over all"
		)
	)
	result.append(
		delta.compressed_whole(FileAccess.COMPRESSION_ZSTD, "3 x 10 bits, delta, zstd over all")
	)
	result.append(_ours("ours"))
	return result


func _moments() -> Array:
	return range(0, _clip.poses.size(), _every)


func _posed(
	p_name: String, p_coding: PoseCodec.Coding, p_bits: int, p_placed: bool
) -> WireMessages:
	var result: WireMessages = WireMessages.named(p_name)
	for tick: int in _moments():
		var pose: PoseSample = _clip.poses[tick]
		var message: PackedByteArray = PoseCodec.encode(pose.orientations, p_coding, p_bits)
		var found: PackedFloat32Array = PoseCodec.decode(message, p_coding, p_bits)
		result.note(pose, pose.root, found)
		var places: PackedVector3Array = WireClip.places(pose.root, pose.orientations)
		message.append_array((places if p_placed else places.slice(0, 1)).to_byte_array())
		result.messages.append(message)
	return result


## The same with each component in two bytes of its own, low bytes first, and the root in
## millimetres: what a compressor that works on bytes can make something of.
func _numbers(p_small: WireMessages) -> WireMessages:
	var result: WireMessages = WireMessages.named("3 x 10 bits in bytes")
	result.worst_deg = p_small.worst_deg
	result.worst_mm = p_small.worst_mm
	for tick: int in _moments():
		var pose: PoseSample = _clip.poses[tick]
		var bytes: PackedByteArray = PackedByteArray()
		bytes.resize(Limbs.COUNT * 7 + _ROOT_BYTES)
		for limb: int in Limbs.COUNT:
			var rotation: Quaternion = pose.orientation(limb)
			var values: Array[float] = [rotation.x, rotation.y, rotation.z, rotation.w]
			var largest: int = 0
			for i: int in 4:
				largest = i if absf(values[i]) > absf(values[largest]) else largest
			bytes[limb] = largest
			var at: int = Limbs.COUNT + limb * 3
			for i: int in 4:
				if i != largest:
					var value: float = values[i] * signf(values[largest])
					var number: int = roundi((value * sqrt(2.0) + 1.0) * 0.5 * 1023.0)
					bytes[at] = number & 0xFF
					bytes[at + Limbs.COUNT * 3] = number >> 8
					at += 1
		for axis: int in 3:
			bytes.encode_s32(Limbs.COUNT * 7 + 4 * axis, roundi(pose.root[axis] * 1000.0))
		result.messages.append(bytes)
	return result


## A limb is sent (15 bits a component) when the receiver's is off by more than is allowed.
func _only_changed(p_name: String) -> WireMessages:
	var result: WireMessages = WireMessages.named(p_name)
	var held: PackedFloat32Array = PackedFloat32Array()
	for tick: int in _moments():
		var pose: PoseSample = _clip.poses[tick]
		var bits: int = Limbs.COUNT + 8 * _ROOT_BYTES
		if held.is_empty():
			held = pose.orientations.duplicate()
			bits += Limbs.COUNT * 47
		for limb: int in Limbs.COUNT:
			var old: Quaternion = WireClip.rotation_of(held, limb)
			if _angle(old, pose.orientation(limb)) > _max_error:
				bits += 47
				_hold(held, limb, pose.orientation(limb))
		result.note(pose, pose.root, held)
		result.messages.append(_empty(bits))
	return result


## A limb is sent with its angular velocity (3 x 16 bits) when the receiver, which turns it on at
## that velocity, is off by more than is allowed.
func _reckoned(p_name: String) -> WireMessages:
	var result: WireMessages = WireMessages.named(p_name)
	var shown: PackedFloat32Array = PackedFloat32Array()
	var turns: Array[Quaternion] = []
	var last: PoseSample = _clip.poses[0]
	for tick: int in _moments():
		var pose: PoseSample = _clip.poses[tick]
		var bits: int = Limbs.COUNT + 8 * _ROOT_BYTES
		if shown.is_empty():
			shown = pose.orientations.duplicate()
			turns.resize(Limbs.COUNT)
			turns.fill(Quaternion.IDENTITY)
			bits += Limbs.COUNT * 95
		for limb: int in Limbs.COUNT:
			var now: Quaternion = pose.orientation(limb).normalized()
			var next: Quaternion = turns[limb] * WireClip.rotation_of(shown, limb)
			if _angle(next, now) > _max_error:
				bits += 95
				turns[limb] = (now * last.orientation(limb).normalized().inverse()).normalized()
				next = now
			_hold(shown, limb, next)
		result.note(pose, pose.root, shown)
		result.messages.append(_empty(bits))
		last = pose
	return result


func _ours(p_name: String) -> WireMessages:
	var result: WireMessages = WireMessages.named(p_name)
	var stream: PersonStream = _clip.to_stream(PersonStream.resolution_for(_max_error))
	for tick: int in range(_age + _every, _clip.poses.size(), _every):
		result.messages.append(stream.encode(tick, tick - _age, tick - _age - _every))
		result.note(_clip.poses[tick], stream.restore_root(tick), stream.restore(tick))
	return result


static func _angle(p_one: Quaternion, p_other: Quaternion) -> float:
	var chord: float = minf((p_one - p_other).length(), (p_one + p_other).length())
	return rad_to_deg(4.0 * asin(minf(chord / 2.0, 1.0)))


static func _hold(r_orientations: PackedFloat32Array, p_limb: int, p_rotation: Quaternion) -> void:
	for i: int in 4:
		r_orientations[4 * p_limb + i] = [p_rotation.x, p_rotation.y, p_rotation.z, p_rotation.w][i]


static func _empty(p_bits: int) -> PackedByteArray:
	var bytes: PackedByteArray = PackedByteArray()
	bytes.resize(ceili(p_bits / 8.0))
	return bytes

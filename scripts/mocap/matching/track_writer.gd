class_name TrackWriter
extends RefCounted
## Writes a [MotionTrack] as BVH while it is recorded, in metres: a person of the wearer's size in
## the reset pose. After each half second the file is whole: what was written survives a kill.

## Frames between two moments at which the file is whole.
const FLUSH: int = 30

const _PLACES: PackedInt32Array = [
	BvhJoint.Channel.X_POSITION, BvhJoint.Channel.Y_POSITION, BvhJoint.Channel.Z_POSITION
]
const _TURNS: PackedInt32Array = [
	BvhJoint.Channel.Z_ROTATION, BvhJoint.Channel.X_ROTATION, BvhJoint.Channel.Y_ROTATION
]

## What is wrong, or an empty text.
var error: String = ""

var _file: FileAccess = null
var _joints: PackedVector3Array = PackedVector3Array()
var _tails: PackedVector3Array = PackedVector3Array()
var _count_at: int = 0
var _frames: int = 0
var _rows: PackedStringArray = PackedStringArray()


## Takes the wearer's size, the height of the hips, m, and lengths as of
## [method MotionSource.get_limb_lengths].
func _init(p_size: BodySize, p_hip_height: float, p_lengths: PackedFloat32Array) -> void:
	var size: BodySize = p_size.duplicate()
	size.measure(&"hip_height", p_hip_height)
	_joints = size.joints()
	_tails = size.tails()
	for foot: int in Limbs.FEET:
		# The ground is known by the lowest point.
		_tails[foot].y = 0.0
	if p_lengths.size() == Limbs.COUNT:
		_fit_legs(p_hip_height, p_lengths)


## Begins a file. Returns what is wrong, or an empty text.
func open(p_path: String) -> String:
	_frames = 0
	_rows.clear()
	_file = FileAccess.open(p_path, FileAccess.WRITE)
	if _file == null:
		error = "cannot write %s: %s" % [p_path, error_string(FileAccess.get_open_error())]
		return error
	_write("\n".join(BvhWriter.hierarchy(_find_joints(), 5)) + "\nMOTION\nFrames: ")
	_count_at = _file.get_position()
	_write("%08d\nFrame Time: %.10f\n" % [0, 1.0 / MotionTrack.RATE])
	return error


## Adds a frame.
func add(p_pose: PoseSample) -> void:
	if _file == null:
		return
	var row: PackedStringArray = ["%.5f %.5f %.5f" % [p_pose.root.x, p_pose.root.y, p_pose.root.z]]
	for limb: int in Limbs.COUNT:
		var turn: Quaternion = p_pose.orientation(limb).normalized()
		if Limbs.PARENTS[limb] >= 0:
			turn = p_pose.orientation(Limbs.PARENTS[limb]).normalized().inverse() * turn
		var angles: Vector3 = Basis(turn).get_euler(EULER_ORDER_ZXY)
		row.append(
			"%.4f %.4f %.4f" % [rad_to_deg(angles.z), rad_to_deg(angles.x), rad_to_deg(angles.y)]
		)
	_rows.append(" ".join(row))
	_frames += 1
	if _rows.size() >= FLUSH:
		_flush()


## Ends the file. Returns what is wrong, or an empty text.
func close() -> String:
	if _file != null:
		_flush()
		_file.close()
		_file = null
	return error


func _flush() -> void:
	if _rows.is_empty():
		return
	_write("\n".join(_rows) + "\n")
	_rows.clear()
	_file.seek(_count_at)
	_write("%08d" % _frames)
	_file.seek_end()
	_file.flush()


func _write(p_text: String) -> void:
	var is_written: bool = _file.store_string(p_text)
	if error == "" and (not is_written or _file.get_error() != OK):
		error = "cannot write %s: %s" % [_file.get_path(), error_string(_file.get_error())]


## The joints of the file: the limbs in their order, an end site after each that nothing hangs on.
func _find_joints() -> Array[BvhJoint]:
	var joints: Array[BvhJoint] = []
	var numbers: PackedInt32Array = PackedInt32Array()
	for limb: int in Limbs.COUNT:
		var parent: int = Limbs.PARENTS[limb]
		var joint: BvhJoint = BvhJoint.new()
		joint.name = Limbs.BONES[limb]
		joint.channels = _TURNS
		if parent < 0:
			joint.channels = _PLACES + _TURNS
		else:
			joint.parent = numbers[parent]
			joint.offset = _joints[limb] - _joints[parent]
		numbers.append(joints.size())
		joints.append(joint)
		if not Limbs.PARENTS.has(limb):
			var end: BvhJoint = BvhJoint.new()
			end.is_end_site = true
			end.parent = numbers[limb]
			end.offset = _tails[limb] - _joints[limb]
			joints.append(end)
	return joints


## Legs as long as they are: hip joints hang below the hips' middle by what is left.
func _fit_legs(p_hip_height: float, p_lengths: PackedFloat32Array) -> void:
	for thigh: int in [Limbs.LEFT_UPPER_LEG, Limbs.RIGHT_UPPER_LEG]:
		var lengths: Array[float] = [p_lengths[thigh], p_lengths[thigh + 1]]
		if lengths.min() <= 0.1 or lengths.max() > 0.8:
			continue
		var foot: Vector3 = _tails[thigh + 2] - _joints[thigh + 2]
		var ankle: float = _joints[thigh + 2].y
		_joints[thigh].y = minf(ankle + lengths[0] + lengths[1], p_hip_height)
		_joints[thigh + 1].y = _joints[thigh].y - lengths[0]
		_joints[thigh + 2].y = _joints[thigh + 1].y - lengths[1]
		_tails[thigh] = _joints[thigh + 1]
		_tails[thigh + 1] = _joints[thigh + 2]
		_tails[thigh + 2] = _joints[thigh + 2] + foot

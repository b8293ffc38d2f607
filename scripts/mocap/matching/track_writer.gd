class_name TrackWriter
extends RefCounted
## Writes a [MotionTrack] as BVH while it is recorded, in metres: a person of the wearer's size in
## the reset pose. After each half second the file is whole: what was written survives a kill.

## Frames between two moments at which the file is whole.
const FLUSH: int = 30

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
	_write("HIERARCHY\n" + _joint_text(Limbs.ROOT, 0) + "MOTION\nFrames: ")
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


## The order of limbs in the file is theirs in [Limbs]: each one's children follow it.
func _joint_text(p_limb: int, p_depth: int) -> String:
	var indent: String = "\t".repeat(p_depth)
	var parent: int = Limbs.PARENTS[p_limb]
	var offset: Vector3 = Vector3.ZERO if parent < 0 else _joints[p_limb] - _joints[parent]
	var text: String = (
		"%s%s %s\n" % [indent, "ROOT" if parent < 0 else "JOINT", Limbs.BONES[p_limb]]
	)
	text += "%s{\n%s\tOFFSET %s\n" % [indent, indent, _numbers(offset)]
	var places: String = "6 Xposition Yposition Zposition " if parent < 0 else "3 "
	text += "%s\tCHANNELS %sZrotation Xrotation Yrotation\n" % [indent, places]
	var has_child: bool = false
	for limb: int in Limbs.COUNT:
		if Limbs.PARENTS[limb] == p_limb:
			text += _joint_text(limb, p_depth + 1)
			has_child = true
	if not has_child:
		text += "%s\tEnd Site\n%s\t{\n%s\t\tOFFSET " % [indent, indent, indent]
		text += "%s\n%s\t}\n" % [_numbers(_tails[p_limb] - _joints[p_limb]), indent]
	return text + indent + "}\n"


static func _numbers(p_vector: Vector3) -> String:
	return "%.5f %.5f %.5f" % [p_vector.x, p_vector.y, p_vector.z]


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

class_name MotionSetBuilder
extends RefCounted
## Makes a [MotionSet] out of motion files, by a table.

## Frames a second of a set.
const RATE: float = 60.0

## What is wrong, or an empty text.
var error: String = ""
## The set so far.
var motion_set: MotionSet = MotionSet.new()

var _motions: Dictionary[String, Motion] = {}
var _sets: Dictionary[String, MotionSet] = {}


## The whole motion of a file.
class Motion:
	extends RefCounted

	var rig: BvhRig = null
	var hips: PackedVector3Array = PackedVector3Array()
	var orientations: PackedFloat32Array = PackedFloat32Array()

	func _init(p_source: BvhSource) -> void:
		rig = p_source.rig
		for frame: int in floori(p_source.get_length() * RATE) + 1:
			var pose: PoseSample = p_source.pose_once(frame / RATE)
			hips.append(pose.root)
			orientations.append_array(pose.orientations)


## Adds all clips of a table, whose files lie in a folder; [param p_unit] is one of
## [constant BvhOptions.UNITS], empty: guessed.
func add_table(p_table: MotionSetTable, p_folder: String, p_unit: String = "") -> void:
	for row: MotionSetTable.Row in p_table.rows:
		if error == "" and row.file.get_extension() == MotionSetTable.SET_EXTENSION:
			_take_from_set(row, _find(row.file, p_folder))
		elif error == "":
			var motion: Motion = _open(_find(row.file, p_folder), p_unit)
			if motion != null:
				_add(motion, row)


## Adds a clip of a source that plays a file: its whole motion is looked at, from [param p_from_s]
## up to [param p_to_s] (0: its end) is kept.
func add_source(
	p_source: BvhSource, p_name: String, p_stance: int, p_from_s: float, p_to_s: float
) -> void:
	var row: MotionSetTable.Row = MotionSetTable.Row.new()
	row.name = p_name
	row.stance = p_stance as MotionMatcher.Stance
	row.from_s = p_from_s
	row.to_s = p_to_s
	_add(Motion.new(p_source), row)


## Writes the set to a file. Returns why it is none or cannot be written, or an empty text.
func save(p_path: String) -> String:
	var bytes: PackedByteArray = motion_set.to_bytes()
	var fault: String = MotionSet.new().load_bytes(bytes)
	if fault != "":
		return fault
	var file: FileAccess = FileAccess.open(p_path, FileAccess.WRITE)
	if file == null or not file.store_buffer(bytes):
		return "cannot write %s: %s" % [p_path, error_string(FileAccess.get_open_error())]
	return ""


func _add(p_motion: Motion, p_row: MotionSetTable.Row) -> void:
	_take_body(p_motion.rig)
	var frames: int = p_motion.hips.size()
	var end: int = frames if p_row.to_s <= 0.0 else mini(roundi(p_row.to_s * RATE), frames)
	var first: int = mini(roundi(p_row.from_s * RATE), frames)
	_refuse(
		p_row.name,
		motion_set.add_clip(
			p_row.name, p_row.stance, p_motion.hips, p_motion.orientations, first, end
		)
	)


func _take_from_set(p_row: MotionSetTable.Row, p_path: String) -> void:
	if not _sets.has(p_path):
		var other: MotionSet = MotionSet.new()
		error = other.load_file(p_path)
		if error != "":
			return
		_sets[p_path] = other
	for clip: int in _sets[p_path].get_clip_count():
		var is_it: bool = _sets[p_path].get_clip_name(clip) == p_row.name
		if is_it and _sets[p_path].get_clip_stance(clip) == p_row.stance:
			_refuse(p_row.name, motion_set.add_clip_of(_sets[p_path], clip))
			return
	error = "%s has no clip '%s' of that stance" % [p_path, p_row.name]


func _refuse(p_name: String, p_fault: String) -> void:
	error = "" if p_fault == "" else "%s: %s" % [p_name, p_fault]


## The path of a file that a table names.
static func _find(p_file: String, p_folder: String) -> String:
	var is_whole: bool = p_file.is_absolute_path() or p_file.contains("://")
	return p_file if is_whole else p_folder.path_join(p_file)


func _open(p_path: String, p_unit: String) -> Motion:
	if not _motions.has(p_path):
		var source: BvhSource = BvhSource.new()
		source.open(p_path, p_unit)
		if source.error != "":
			error = source.error
			return null
		_motions[p_path] = Motion.new(source)
	return _motions[p_path]


## The body of a file, as its rest pose has it with legs that hang.
func _take_body(p_rig: BvhRig) -> void:
	var joints: PackedVector3Array = PackedVector3Array()
	for thigh: int in [Limbs.LEFT_UPPER_LEG, Limbs.RIGHT_UPPER_LEG]:
		joints.append(p_rig.rest_base(thigh) - p_rig.rest_base(Limbs.HIPS))
	var leg: PackedFloat32Array = PackedFloat32Array()
	for limb: int in [Limbs.LEFT_UPPER_LEG, Limbs.LEFT_LOWER_LEG]:
		leg.append(p_rig.rest_base(limb).distance_to(p_rig.rest_base(limb + 1)))
	var foot: Vector3 = p_rig.rest_tail(Limbs.LEFT_FOOT) - p_rig.rest_base(Limbs.LEFT_FOOT)
	var ankle: float = p_rig.rest_base(Limbs.LEFT_FOOT).y - p_rig.rest_floor()
	var ball: float = maxf(Vector2(foot.x, foot.z).length(), 0.05)
	motion_set.begin_body(joints, leg[0], leg[1], maxf(ankle, 0.02), ball)

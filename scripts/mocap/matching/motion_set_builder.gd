class_name MotionSetBuilder
extends RefCounted
## Makes a [MotionSet] out of motion files, by a table.

## Frames a second of a set.
const RATE: float = 60.0

## What is wrong, or an empty text.
var error: String = ""
## The set so far.
var motion_set: MotionSet = MotionSet.new()

var _sources: Dictionary[String, BvhSource] = {}


## Adds all clips of a table, whose files lie in a folder; [param p_unit] is one of
## [constant BvhOptions.UNITS], empty: guessed.
func add_table(p_table: MotionSetTable, p_folder: String, p_unit: String = "") -> void:
	for row: MotionSetTable.Row in p_table.rows:
		if error != "":
			return
		var source: BvhSource = _open(p_folder.path_join(row.file), p_unit)
		if source == null:
			return
		_add(row, source)


## Adds a clip of a source that plays a file: its whole motion is looked at, from [param p_from_s]
## up to [param p_to_s] (0: its end) is kept.
func add_source(
	p_source: BvhSource, p_name: String, p_stance: int, p_from_s: float, p_to_s: float
) -> void:
	_take_body(p_source.rig)
	var length: float = p_source.get_length()
	var frames: int = floori(length * RATE) + 1
	var hips: PackedVector3Array = PackedVector3Array()
	var orientations: PackedFloat32Array = PackedFloat32Array()
	for frame: int in frames:
		var pose: PoseSample = p_source.pose_once(frame / RATE)
		hips.append(pose.root)
		orientations.append_array(pose.orientations)
	var end: int = frames if p_to_s <= 0.0 else mini(roundi(p_to_s * RATE), frames)
	error = motion_set.add_clip(
		p_name, p_stance, hips, orientations, mini(roundi(p_from_s * RATE), frames), end
	)
	if error != "":
		error = "%s: %s" % [p_name, error]


func _open(p_path: String, p_unit: String) -> BvhSource:
	if not _sources.has(p_path):
		var source: BvhSource = BvhSource.new()
		source.open(p_path, p_unit)
		if source.error != "":
			error = source.error
			return null
		_sources[p_path] = source
	return _sources[p_path]


func _add(p_row: MotionSetTable.Row, p_source: BvhSource) -> void:
	add_source(p_source, p_row.name, p_row.stance, p_row.from_s, p_row.to_s)


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

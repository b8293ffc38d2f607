class_name BvhSource
extends MotionSource
## Plays a BVH file in a loop, as if somebody in a suit made the motion now.

## Seconds over which the end of the clip is blended into its beginning.
const BLEND_S: float = 0.5

## The clip that is played.
var rig: BvhRig = null
## What was guessed with doubt, mended or left out, one sentence each: those of the clip, and those
## of how it is played.
var notes: PackedStringArray = PackedStringArray()
## Where in the loop playing begins, s.
var start_s: float = 0.0

var _begin_usec: int = -1
var _floor: float = 0.0
## Seconds of the clip that are left out at its beginning and at its end.
var _skipped: float = 0.0
var _unplayed: float = 0.0
## For each limb 1 or -1: which of the end's two quaternions is the nearer one to the beginning's.
var _seam_signs: PackedFloat32Array = PackedFloat32Array()


## Opens a file. The unit is one of [constant BvhOptions.UNITS] or metres per unit, the axis one of
## [constant BvhOptions.AXES]; empty texts leave both to be guessed. [member error] says what is
## wrong.
func open(p_path: String, p_unit: String = "", p_up: String = "") -> void:
	var options: BvhOptions = BvhOptions.new()
	if p_unit != "":
		options.unit_metres = BvhOptions.parse_unit(p_unit)
		if options.unit_metres <= 0.0:
			var units: String = ", ".join(BvhOptions.UNITS.keys())
			error = "a unit is %s or metres, found '%s'" % [units, p_unit]
			return
	if p_up != "":
		options.up_axis = BvhOptions.parse_axis(p_up)
		if options.up_axis == BvhOptions.UpAxis.GUESS:
			error = "an up axis is %s, found '%s'" % [", ".join(BvhOptions.AXES.keys()), p_up]
			return
	var result: BvhParser.Result = BvhParser.parse_file(p_path, options)
	error = result.error
	if error == "":
		use(result.clip)


## Plays a clip that is already there.
func use(p_clip: BvhClip) -> void:
	rig = BvhRig.from_clip(p_clip)
	notes = p_clip.notes.duplicate()
	error = rig.error
	if error == "":
		p_clip.prepare()
		_trim()
		var first: int = roundi(_skipped / p_clip.frame_time)
		_floor = BvhFloor.find(
			rig, first, p_clip.frame_count - roundi(_unplayed / p_clip.frame_time)
		)
		_find_seam()


func get_hip_height() -> float:
	return rig.hip_height


func describe() -> String:
	var parts: Array = [rig.clip.source_name, rig.clip.duration(), 1.0 / rig.clip.frame_time]
	return "%s, %.1f s at %.0f Hz" % parts


## How long a round takes, s.
func get_period() -> float:
	return maxf(get_length() - BLEND_S, get_length() * 0.5)


## How long the motion is that is played, s.
func get_length() -> float:
	return maxf(rig.clip.duration() - _skipped - _unplayed, 0.001)


## The pose so many seconds after the beginning of the motion, played once.
func pose_once(p_time_s: float) -> PoseSample:
	var pose: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		pose.set_orientation(limb, _limb_rotation(limb, p_time_s))
	pose.root = rig.hips_position(p_time_s + _skipped)
	pose.root.y -= _floor
	return pose


## The pose after so many seconds of playing.
func pose_at(p_time_s: float) -> PoseSample:
	var length: float = get_length()
	var period: float = get_period()
	var time: float = fposmod(p_time_s, period)
	# The last moments of a round are blended into the first ones of the next.
	var late: float = time + period
	var blend: float = 0.0
	if p_time_s >= period and late < length:
		blend = 1.0 - time / (length - period)
	var pose: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		var rotation: Quaternion = _limb_rotation(limb, time)
		if blend > 0.0:
			var ending: Quaternion = _limb_rotation(limb, late) * _seam_signs[limb]
			rotation = rotation.slerpni(ending, blend)
		pose.set_orientation(limb, rotation)
	pose.root = rig.hips_position(time + _skipped)
	if blend > 0.0:
		pose.root = pose.root.lerp(rig.hips_position(late + _skipped), blend)
	pose.root.y -= _floor
	return pose


## Whether what is played at a moment (Unix time, µs) is nobody's motion: the end of the clip goes
## over into its beginning.
func is_at_seam(p_time_usec: int) -> bool:
	var time: float = start_s + (p_time_usec - _begin_usec) / 1e6
	var period: float = get_period()
	return time >= period and fposmod(time, period) < get_length() - period


func _read(p_time_usec: int) -> PoseSample:
	if _begin_usec < 0:
		_begin_usec = p_time_usec
	return pose_at(start_s + (p_time_usec - _begin_usec) / 1e6)


func _limb_rotation(p_limb: int, p_time_s: float) -> Quaternion:
	return rig.limb_rotation(p_limb, p_time_s + _skipped)


## Leaves out what is no motion, and says so.
func _trim() -> void:
	var clip: BvhClip = rig.clip
	var first: int = BvhTrim.leading(rig)
	var last: int = BvhTrim.trailing(rig)
	if first + last > clip.frame_count - 2:
		last = 0
	_skipped = first * clip.frame_time
	_unplayed = last * clip.frame_time
	for part: Array in [["begins", first], ["ends", last]]:
		if part[1] > 0:
			var parts: Array = [clip.source_name] + part
			notes.append("%s: %s with another pose or place, not played: frames: %d" % parts)


## Decides once which way each limb turns while the end is blended into the beginning. If it were
## decided for each sample, a limb that has to turn by about half a circle would flip to the other
## way.
func _find_seam() -> void:
	_seam_signs.resize(Limbs.COUNT)
	var middle: float = (get_length() - get_period()) / 2.0
	for limb: int in Limbs.COUNT:
		var beginning: Quaternion = _limb_rotation(limb, middle)
		var same: float = beginning.dot(_limb_rotation(limb, get_period() + middle))
		_seam_signs[limb] = -1.0 if same < 0.0 else 1.0

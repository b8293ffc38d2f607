class_name MvnSource
extends MotionSource
## One person of MVN's stream. MVN has calibrated its wearers itself.
##
## Any thread may sample it while another shows it.

## The character's number in the stream.
var character: int = 0
## The wearer's name, or an empty text.
var name: String = ""

var _receiver: MvnReceiver = null
# Shared between threads and guarded.
var _mutex: Mutex = Mutex.new()
var _pose: MvnPose = MvnPose.new()
var _body: MvnBody = MvnBody.new()
var _newest: PoseSample = null
var _poses: LivePoses = LivePoses.new()
var _stats: Dictionary = {}


func _init(p_receiver: MvnReceiver = null, p_character: int = 0, p_unit_m: float = 0.0) -> void:
	_receiver = p_receiver
	character = p_character
	_pose.unit_m = p_unit_m


func get_hip_height() -> float:
	_mutex.lock()
	var height: float = _body.hip_height
	_mutex.unlock()
	return height


func get_limb_lengths() -> PackedFloat32Array:
	_mutex.lock()
	var lengths: PackedFloat32Array = _body.lengths.duplicate()
	_mutex.unlock()
	return lengths


func get_body() -> BodySize:
	var size: BodySize = BodySize.of_hip_height(get_hip_height())
	var lengths: PackedFloat32Array = get_limb_lengths()
	var parts: Dictionary[StringName, int] = {
		&"upper_arm": 4, &"forearm": 5, &"thigh": 10, &"shank": 11
	}
	size.measure(&"hip_height", get_hip_height())
	for part: StringName in parts:
		if lengths[parts[part]] > 0.0:
			size.measure(part, lengths[parts[part]])
	return size


## The newest pose, or null; use it to show the pose, and [method sample] to send it.
func get_newest() -> PoseSample:
	_mutex.lock()
	_pump()
	var pose: PoseSample = _newest
	_mutex.unlock()
	return pose


## Takes the stats of this person's stream, see [method MvnReceiver.get_characters]; the main thread
## calls it.
func note(p_stats: Dictionary) -> void:
	var scale: Dictionary = _receiver.get_newest(character, 13)
	_mutex.lock()
	_stats = p_stats
	if p_stats["name"] != "":
		name = p_stats["name"]
	if not scale.is_empty():
		_body.take_scale(scale)
	_mutex.unlock()


## What is wrong with the stream of this person, or an empty text.
func trouble() -> String:
	return _stats.get("trouble", "")


func describe() -> String:
	var who: String = name if name != "" else "character %d" % character
	var rate: float = _stats.get("rate_hz", 0.0)
	return "%s of MVN at %s, %.0f Hz" % [who, _stats.get("sender", "nobody yet"), rate]


func _read(p_time_usec: int) -> PoseSample:
	_mutex.lock()
	_pump()
	var pose: PoseSample = _poses.at(p_time_usec)
	_mutex.unlock()
	return pose


func _pump() -> void:
	var raw: Array[Dictionary] = _receiver.take_poses(character)
	if raw.is_empty():
		return
	for sample: Dictionary in raw:
		var pose: PoseSample = _pose.read(sample)
		if pose != null and pose.find_fault() == "":
			_newest = pose
			_poses.push(pose)
	if not _body.is_measured and _newest != null:
		_body.take_pose(_newest.details.positions)

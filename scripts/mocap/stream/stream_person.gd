class_name StreamPerson
extends MotionSource
## One person of a motion stream, calibrated by the sender: [StreamReader]s make the poses.
##
## Any thread may sample it while another gives it samples and a third one shows it.

## Silence after which a sender may count anew, µs.
const RESTART_USEC: int = 500000
## Number of counts behind the newest beyond which a sample is not late: the sender has begun anew.
const RESTART_COUNTS: int = 600
## Time over which the age of poses is observed, and the greatest age that is waited for, µs.
const AGE_SPAN_USEC: int = 3000000
const MAX_AGE_USEC: int = 45000
## Number of samples from which lengths of limbs are taken: tracked positions are never still.
const SIZE_SAMPLES: int = 120
## Height of an ankle above the sole as a share of the leg: hips are higher by that than the leg is
## long.
const HIPS_PER_LEG: float = 1.08
## Plausible lengths of legs, m.
const LEGS_M: Vector2 = Vector2(0.3, 1.6)

## Who sends it: "ADDRESS:PORT".
var sender: String = ""
## What the protocol is called.
var title: String = ""

# Shared between threads and guarded.
var _mutex: Mutex = Mutex.new()
var _time: StreamTime = StreamTime.new()
var _poses: LivePoses = LivePoses.new()
var _name: String = ""
var _newest: PoseSample = null
var _newest_usec: int = 0
var _counter: int = -1
var _source_usec: int = -1
var _samples: int = 0
var _lost: int = 0
var _twice: int = 0
var _faulty: int = 0
var _rate: SampleRate = SampleRate.new()
var _timed_usec: int = 0
var _age_usec: int = 0
var _age_before_usec: int = 0
var _aged_usec: int = 0
var _hips_m: float = 0.0
var _has_hip_height: bool = false
var _lengths: PackedFloat32Array = PackedFloat32Array()
var _measured: int = 0


func _init(p_title: String = "", p_sender: String = "", p_name: String = "") -> void:
	title = p_title
	sender = p_sender
	_name = p_name


## The person's name in the stream, or an empty text.
func get_name() -> String:
	_mutex.lock()
	var found: String = _name
	_mutex.unlock()
	return found


## Takes a sample that arrived at a time, µs of Unix time. Returns why its pose is none, or an empty
## text: one that comes twice or too late is counted, and no fault.
func take(p_sample: StreamSample, p_arrival_usec: int) -> String:
	var fault: String = p_sample.pose.find_fault()
	_mutex.lock()
	if fault != "":
		_faulty += 1
	elif _is_fresh(p_sample, p_arrival_usec):
		_keep(p_sample, p_arrival_usec)
	_mutex.unlock()
	return fault


func get_hip_height() -> float:
	_mutex.lock()
	var height: float = _hips_m if _hips_m > 0.0 else 0.95
	_mutex.unlock()
	return height


func get_limb_lengths() -> PackedFloat32Array:
	_mutex.lock()
	var lengths: PackedFloat32Array = _lengths.duplicate()
	_mutex.unlock()
	return lengths


func get_body() -> BodySize:
	var size: BodySize = BodySize.of_hip_height(get_hip_height())
	var lengths: PackedFloat32Array = get_limb_lengths()
	size.measure(&"hip_height", get_hip_height())
	if lengths.size() == Limbs.COUNT:
		size.measure(&"upper_arm", lengths[Limbs.LEFT_UPPER_ARM])
		size.measure(&"forearm", lengths[Limbs.LEFT_LOWER_ARM])
		size.measure(&"thigh", lengths[Limbs.LEFT_UPPER_LEG])
		size.measure(&"shank", lengths[Limbs.LEFT_LOWER_LEG])
	return size


## The newest pose, or null; use it to show the pose, and [method sample] to send it.
func get_newest() -> PoseSample:
	_mutex.lock()
	var pose: PoseSample = _newest
	_mutex.unlock()
	return pose


## How the samples come: "samples", "lost", "twice" (or too late), "faulty", "rate_hz", and "usec",
## when the newest came (Unix time).
func stats() -> Dictionary:
	_mutex.lock()
	var result: Dictionary = {
		"samples": _samples,
		"lost": _lost,
		"twice": _twice,
		"faulty": _faulty,
		"rate_hz": _rate.hz,
		"usec": _newest_usec,
	}
	_mutex.unlock()
	return result


func describe() -> String:
	var who: String = get_name()
	if who == "":
		who = "somebody"
	return "%s of %s at %s, %.0f Hz" % [who, title, sender, stats()["rate_hz"]]


func _read(p_time_usec: int) -> PoseSample:
	_mutex.lock()
	var pose: PoseSample = _poses.at(p_time_usec)
	_mutex.unlock()
	return pose


## Whether a sample is newer than the last one, by the sender's count or its time. The mutex is
## held.
func _is_fresh(p_sample: StreamSample, p_arrival_usec: int) -> bool:
	var is_anew: bool = p_arrival_usec - _newest_usec > RESTART_USEC
	if p_sample.counter >= 0:
		var steps: int = p_sample.counter - _counter
		if _counter >= 0 and steps <= 0 and steps > -RESTART_COUNTS and not is_anew:
			_twice += 1
			return false
		if _counter >= 0 and steps > 1 and steps < RESTART_COUNTS:
			_lost += steps - 1
		_counter = p_sample.counter
	elif p_sample.source_usec >= 0:
		var ahead: int = p_sample.source_usec - _source_usec
		if _source_usec >= 0 and ahead <= 0 and ahead > -RESTART_USEC and not is_anew:
			_twice += 1
			return false
	_source_usec = p_sample.source_usec
	return true


func _keep(p_sample: StreamSample, p_arrival_usec: int) -> void:
	var pose: PoseSample = p_sample.pose
	pose.time_usec = _time.at(p_sample.source_usec, p_sample.counter, p_arrival_usec)
	if pose.details != null:
		pose.details.counter = p_sample.counter
	if p_sample.name != "":
		_name = p_sample.name
	_samples += 1
	_newest_usec = p_arrival_usec
	_newest = pose
	_measure(pose, p_sample.hip_height)
	_note_age(p_arrival_usec)
	_timed_usec = pose.time_usec
	_poses.push(pose)
	_rate.add(p_arrival_usec)


## Notes how old the newest pose had become when this one came: poses are asked for so far back that
## there is one on either side, whatever the network delays and loses.
func _note_age(p_arrival_usec: int) -> void:
	if _timed_usec > 0:
		_age_usec = maxi(_age_usec, mini(p_arrival_usec - _timed_usec, MAX_AGE_USEC))
	if p_arrival_usec - _aged_usec > AGE_SPAN_USEC:
		_age_before_usec = _age_usec
		_age_usec = 0
		_aged_usec = p_arrival_usec
	var age_s: float = maxi(_age_usec, _age_before_usec) / 1e6
	_poses.margin_s = maxf(age_s - _poses.period_s(), LivePoses.MARGIN_S)


## Takes the lengths of the limbs from where they are.
func _measure(p_pose: PoseSample, p_hips_m: float) -> void:
	if p_hips_m > 0.2 and p_hips_m < 2.0:
		_has_hip_height = true
		_hips_m = p_hips_m
	if p_pose.details == null or p_pose.details.positions.size() != Limbs.COUNT:
		return
	if _measured >= SIZE_SAMPLES:
		return
	var positions: PackedVector3Array = p_pose.details.positions
	if _lengths.is_empty():
		_lengths.resize(Limbs.COUNT)
	for limb: int in Limbs.ARMS + Limbs.LEGS:
		var length: float = positions[limb].distance_to(positions[limb + 1])
		if length > PersonCard.MIN_LENGTH_M and length < PersonCard.MAX_LENGTH_M:
			_lengths[limb] += (length - _lengths[limb]) / (_measured + 1.0)
	_measured += 1
	var leg: float = 0.0
	for limb: int in Limbs.LEGS:
		leg += _lengths[limb] / 2.0
	if not _has_hip_height and leg > LEGS_M.x and leg < LEGS_M.y:
		_hips_m = leg * HIPS_PER_LEG

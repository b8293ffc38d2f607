class_name LimbFusion
extends MotionSource
## One body of several sources: the first gives it, others complete it limb by limb, such as the
## feet of one tracker and the head of another on a suit.
##
## Sources are aligned in time (the body is that of the newest moment which all of them know) and in
## heading ([HeadingCorrection], by the trunk and head that both have measured). A source that is
## silent is left out until it comes again; its limbs are the first one's meanwhile. Choices may be
## made at any time, in any thread.

## What can be chosen.
enum Group {
	## Where the body is.
	ROOT,
	## Pelvis, waist and chest.
	TRUNK,
	## Head and neck.
	HEAD,
	## Arms without hands.
	ARMS,
	## Hands.
	HANDS,
	## Fingers.
	FINGERS,
	## Legs without feet.
	LEGS,
	## Feet and toes.
	FEET,
}

## Names of the groups, for options and people.
const NAMES: PackedStringArray = [
	"root", "trunk", "head", "arms", "hands", "fingers", "legs", "feet"
]
## The limbs of each group.
const LIMBS: Dictionary[Group, Array] = {
	Group.ROOT: [],
	Group.TRUNK: [Limbs.HIPS, Limbs.SPINE, Limbs.CHEST],
	Group.HEAD: [Limbs.HEAD],
	Group.ARMS: Limbs.ARMS,
	Group.HANDS: [Limbs.LEFT_HAND, Limbs.RIGHT_HAND],
	Group.FINGERS: [],
	Group.LEGS: Limbs.LEGS,
	Group.FEET: Limbs.FEET,
}
## Joints that go with each group.
const JOINTS: Dictionary[Group, Array] = {
	Group.ROOT: [],
	Group.TRUNK: [XRBodyTracker.JOINT_UPPER_CHEST],
	Group.HEAD: [XRBodyTracker.JOINT_NECK],
	Group.ARMS: [XRBodyTracker.JOINT_LEFT_SHOULDER, XRBodyTracker.JOINT_RIGHT_SHOULDER],
	Group.HANDS: [],
	Group.FINGERS: [],
	Group.LEGS: [],
	Group.FEET: [XRBodyTracker.JOINT_LEFT_TOES, XRBodyTracker.JOINT_RIGHT_TOES],
}
## Limbs by which two sources' headings are compared, where both have measured them.
const COMPARED: PackedInt32Array = [Limbs.HIPS, Limbs.CHEST, Limbs.HEAD]
## Greatest distance of poses that count as of one moment, µs.
const SAME_USEC: int = 2000
## Age relative to the first source from which on a source counts as silent, µs.
const SILENT_USEC: int = 250000

var _first: Lane = null
# Shared between threads and guarded.
var _mutex: Mutex = Mutex.new()
var _others: Dictionary[int, Lane] = {}
var _choices: Dictionary[Group, int] = {}
var _last_usec: int = 0


## One source and its last poses.
class Lane:
	var source: MotionSource = null
	var poses: LivePoses = LivePoses.new()
	var newest_usec: int = 0
	var heading: HeadingCorrection = HeadingCorrection.new()

	func _init(p_source: MotionSource) -> void:
		source = p_source

	## Takes what the source has now.
	func pump(p_time_usec: int) -> void:
		var pose: PoseSample = source.sample(p_time_usec)
		if pose != null:
			poses.push(pose)
			newest_usec = pose.time_usec

	## The pose of a moment, or null where it has been asked for.
	func at(p_usec: int) -> PoseSample:
		# Poses are asked for with the delay that is taken off again.
		return poses.at(p_usec + roundi((poses.period_s() + poses.margin_s) * 1e6))


## The first source gives all that is not chosen otherwise.
func _init(p_first: MotionSource) -> void:
	_first = Lane.new(p_first)
	error = p_first.error


## Reads choices such as "feet:2,head:3": numbers of sources, of which 1 is the first. Returns
## [param r_choices]' fault, or an empty text.
static func parse(p_text: String, r_choices: Dictionary[Group, int]) -> String:
	for part: String in p_text.split(",", false):
		var group: int = NAMES.find(part.get_slice(":", 0))
		var number: String = part.get_slice(":", 1) if part.count(":") == 1 else ""
		if group < 0 or not number.is_valid_int() or number.length() > 2 or number.to_int() < 1:
			var parts: Array = [", ".join(NAMES), part.left(40)]
			return "GROUP:NUMBER,... with groups %s and the number of a source, found '%s'" % parts
		r_choices[group as Group] = number.to_int()
	return ""


## The source that gives the body.
func first() -> MotionSource:
	return _first.source


## Sets the source of a number from 2 on; null takes it away.
func set_source(p_number: int, p_source: MotionSource) -> void:
	_mutex.lock()
	if p_source == null:
		_others.erase(p_number)
	else:
		_others[p_number] = Lane.new(p_source)
	_mutex.unlock()


## Numbers of the sources that there are besides the first.
func list_sources() -> PackedInt32Array:
	_mutex.lock()
	var numbers: PackedInt32Array = PackedInt32Array(_others.keys())
	_mutex.unlock()
	return numbers


## Chooses which source gives a group: 1 is the first.
func choose(p_group: Group, p_number: int) -> void:
	_mutex.lock()
	_choices[p_group] = p_number
	_mutex.unlock()


## Which source gives a group.
func choice(p_group: Group) -> int:
	_mutex.lock()
	var number: int = _choices.get(p_group, 1)
	_mutex.unlock()
	return number


## By how much a source is turned to agree with the first, rad about +Y.
func heading_of(p_number: int) -> float:
	_mutex.lock()
	var angle: float = _others[p_number].heading.angle if _others.has(p_number) else 0.0
	_mutex.unlock()
	return angle


func get_hip_height() -> float:
	return _first.source.get_hip_height()


func get_limb_lengths() -> PackedFloat32Array:
	return _first.source.get_limb_lengths()


func get_body() -> BodySize:
	return _first.source.get_body()


func describe() -> String:
	var texts: PackedStringArray = [_first.source.describe()]
	_mutex.lock()
	for group: Group in _choices:
		if _others.has(_choices[group]):
			texts.append("%s of %s" % [NAMES[group], _others[_choices[group]].source.describe()])
	_mutex.unlock()
	return ", ".join(texts)


func _read(p_time_usec: int) -> PoseSample:
	_mutex.lock()
	_first.pump(p_time_usec)
	error = _first.source.error
	var moment: int = _first.newest_usec
	var active: Dictionary[int, Lane] = {}
	for number: int in _others:
		var other: Lane = _others[number]
		other.pump(p_time_usec)
		if _choices.values().has(number) and _first.newest_usec - other.newest_usec < SILENT_USEC:
			active[number] = other
			moment = mini(moment, other.newest_usec)
	var pose: PoseSample = null
	if moment > _last_usec or _last_usec - moment > 2 * SILENT_USEC:
		pose = _first.at(moment)
	if pose != null:
		var step_s: float = clampf((moment - _last_usec) / 1e6, 0.0, 0.1)
		_last_usec = moment
		pose = _copy(pose)
		_complete(pose, active, moment, step_s)
	_mutex.unlock()
	return pose


## Puts the chosen limbs of other sources into a pose.
func _complete(
	r_pose: PoseSample, p_active: Dictionary[int, Lane], p_moment: int, p_step_s: float
) -> void:
	var is_mixed: bool = false
	for number: int in p_active:
		var other: Lane = p_active[number]
		var pose: PoseSample = other.at(p_moment)
		if pose == null or absi(pose.time_usec - r_pose.time_usec) > SAME_USEC:
			# It has just come, and knows nothing of this moment.
			continue
		other.heading.advance(_angle_between(pose, r_pose, _taken_from(number)), p_step_s)
		var turn: Quaternion = Rotations.yaw(other.heading.angle)
		for group: Group in _choices:
			if _choices[group] == number:
				_take_group(r_pose, pose, group, turn)
				is_mixed = true
	if is_mixed:
		r_pose.details.positions = PackedVector3Array()


static func _take_group(
	r_pose: PoseSample, p_other: PoseSample, p_group: Group, p_turn: Quaternion
) -> void:
	if p_group == Group.ROOT:
		r_pose.root = p_turn * p_other.root
	for limb: int in LIMBS[p_group]:
		r_pose.set_orientation(limb, (p_turn * p_other.orientation(limb)).normalized())
		r_pose.details.measured[limb] = 1 if _is_measured(p_other, limb) else 0
	if p_other.details == null:
		return
	for joint: int in p_other.details.joints:
		var is_finger: bool = p_group == Group.FINGERS and FingerJoints.hand_of(joint) >= 0
		if is_finger or JOINTS[p_group].has(joint):
			r_pose.details.joints[joint] = (p_turn * p_other.details.joints[joint]).normalized()


## Limbs that are taken from a source: what the first says of them is not trusted.
func _taken_from(p_number: int) -> PackedInt32Array:
	var limbs: PackedInt32Array = []
	for group: Group in _choices:
		if _choices[group] == p_number:
			limbs.append_array(PackedInt32Array(LIMBS[group]))
	return limbs


## The angle about the vertical from one pose to another, rad, by what both have measured and nobody
## replaces; NAN where that is nothing.
static func _angle_between(
	p_from: PoseSample, p_to: PoseSample, p_replaced: PackedInt32Array
) -> float:
	var turns: Array[Quaternion] = []
	for limb: int in COMPARED:
		if p_replaced.has(limb):
			continue
		if _is_measured(p_from, limb) and _is_measured(p_to, limb):
			turns.append(p_to.orientation(limb) * p_from.orientation(limb).inverse())
	return Rotations.yaw_of(Rotations.mean(turns, 0.2)) if not turns.is_empty() else NAN


static func _is_measured(p_pose: PoseSample, p_limb: int) -> bool:
	if p_pose.details == null or p_pose.details.measured.is_empty():
		return true
	return p_pose.details.measured[p_limb] != 0


## A copy that can be changed: a source may go on with its own.
static func _copy(p_pose: PoseSample) -> PoseSample:
	var pose: PoseSample = PoseSample.new()
	pose.time_usec = p_pose.time_usec
	pose.orientations = p_pose.orientations.duplicate()
	pose.root = p_pose.root
	pose.details = MotionDetails.new()
	pose.details.measured.resize(Limbs.COUNT)
	pose.details.measured.fill(1)
	if p_pose.details != null:
		pose.details.counter = p_pose.details.counter
		pose.details.positions = p_pose.details.positions
		pose.details.contacts = p_pose.details.contacts
		pose.details.joints = p_pose.details.joints.duplicate()
		if not p_pose.details.measured.is_empty():
			pose.details.measured = p_pose.details.measured.duplicate()
	return pose

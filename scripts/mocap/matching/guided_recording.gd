class_name GuidedRecording
extends RefCounted
## Leads a wearer through the motions that a motion set is made of: says what to do, sees by the
## motion whether it was done, asks for it again where it was not, and keeps what was recorded.
##
## It is given a pose at each 60th of a second, or null where the source has none, and knows no
## clock. What is lost for longer than [constant BRIDGED] frames ends a [MotionTrack]: the next one
## begins when the source is there again, and a jump does the same. While there is no motion the
## phase waits.

## Something that the wearer is to read: what to do, what was missing, what is lost.
signal said(text: String)
## A stretch of motion begins; a frame was added to the newest one; it has ended.
signal track_begun(track: MotionTrack)
signal frame_added(pose: PoseSample)
signal track_ended

## Where it is.
enum State {
	## Nobody's motion has come yet.
	WAITING,
	## The next phase is announced.
	READY,
	## A phase is recorded.
	RUNNING,
	## All phases are over.
	DONE,
}

## Maximum of missing frames in a row that are filled, by what lies between their neighbours.
const BRIDGED: int = 6
## A step of the hips, m, and a turn of a limb, rad, in a frame that are a jump where the step
## before was not a third of it.
const JUMP_M: float = 0.08
const JUMP_RAD: float = 0.43
## Frames between two looks at how much of a phase there is.
const _LOOK: int = 6


## What was recorded of a phase.
class Take:
	extends RefCounted

	var phase: GuidedPhase = null
	var tracks: Array[MotionTrack] = []
	## Whether it is used: there was enough of it, or all ended in the midst of it.
	var is_had: bool = false


## Where it is.
var state: State = State.WAITING
## The phases, in their order.
var phases: Array[GuidedPhase] = []
## What was recorded, phase by phase.
var takes: Array[Take] = []
## Number of the present phase.
var index: int = 0
## How much of the present phase there is, 0 to 1.
var progress: float = 0.0
## Time in which there was no motion after it had begun, s.
var lost_s: float = 0.0

var _hip_height: float = 0.95
var _attempt: int = 0
# Frames of the present state in which there was motion, and missing ones.
var _frames: int = 0
var _missing: int = 0
var _track: MotionTrack = null
var _before: PoseSample = null
var _step: float = 0.0
var _turns: PackedFloat32Array = PackedFloat32Array()


## Leads through these phases.
func _init(p_phases: Array[GuidedPhase]) -> void:
	phases = p_phases
	_turns.resize(Limbs.COUNT)


## Says whose motion comes: the height of the hips when standing, m.
func begin(p_hip_height: float) -> void:
	_hip_height = p_hip_height
	if state == State.WAITING:
		_announce()


## The phase that is announced or recorded, or null.
func phase() -> GuidedPhase:
	return phases[index] if state != State.DONE and index < phases.size() else null


## The phase after it, or null.
func next_phase() -> GuidedPhase:
	return phases[index + 1] if index + 1 < phases.size() else null


## Seconds until the announced phase counts.
func countdown_s() -> float:
	return GuidedPhase.READY_S - _frames / MotionTrack.RATE if state == State.READY else 0.0


## Whether the source gives no motion at the moment.
func is_lost() -> bool:
	return _missing > BRIDGED


## The pose of the next 60th of a second, or null.
func take(p_pose: PoseSample) -> void:
	if state == State.WAITING or state == State.DONE:
		return
	if p_pose == null or p_pose.find_fault() != "":
		_miss()
		return
	if is_lost():
		said.emit("The motion is back")
	_frames += 1
	if state == State.READY:
		_missing = 0
		if _frames >= GuidedPhase.READY_S * MotionTrack.RATE:
			_run()
		return
	_record(p_pose)
	_missing = 0
	if _frames % _LOOK == 0:
		_look()


## Leaves the present phase out.
func skip() -> void:
	if phase() != null:
		_conclude(false, "left out: " + phase().name)


## Ends it; what there is so far is kept, that of an unfinished phase too.
func finish() -> void:
	_end_track()
	if phase() != null and not takes.is_empty() and takes[-1].phase == phase():
		takes[-1].is_had = true
	state = State.DONE


## The phases that there was enough of.
func had() -> Array[Take]:
	return takes.filter(func(one: Take) -> bool: return one.is_had)


func _announce() -> void:
	if index >= phases.size():
		finish()
		return
	state = State.READY
	_frames = 0
	progress = 0.0
	var after: String = "" if next_phase() == null else "   (then: %s)" % next_phase().words
	said.emit("%d/%d  %s%s" % [index + 1, phases.size(), phase().words, after])


func _run() -> void:
	state = State.RUNNING
	_frames = 0
	if takes.is_empty() or takes[-1].phase != phase():
		var fresh: Take = Take.new()
		fresh.phase = phase()
		takes.append(fresh)
	said.emit("Now!")


func _miss() -> void:
	_missing += 1
	if _missing <= BRIDGED:
		return
	lost_s += 1.0 / MotionTrack.RATE
	if _missing == BRIDGED + 1:
		lost_s += BRIDGED / MotionTrack.RATE
		_end_track()
		said.emit("There is no motion: the source is lost, and it waits for it")


func _record(p_pose: PoseSample) -> void:
	if _track != null and _jumps(p_pose):
		_end_track()
	if _track == null:
		_begin_track()
	elif _missing > 0:
		for number: int in _missing:
			_add(_between(_before, p_pose, (number + 1.0) / (_missing + 1.0)))
	_add(p_pose)
	_before = p_pose


func _begin_track() -> void:
	_track = MotionTrack.new()
	_track.phase = phase()
	_track.hip_height = _hip_height
	var letter: int = takes[-1].tracks.size()
	_track.name = "%02d_%s_%d" % [index + 1, phase().name, letter + 1]
	takes[-1].tracks.append(_track)
	_before = null
	_step = INF
	_turns.fill(INF)
	track_begun.emit(_track)


func _end_track() -> void:
	if _track != null:
		_track = null
		track_ended.emit()


func _add(p_pose: PoseSample) -> void:
	_track.add(p_pose)
	frame_added.emit(p_pose)


## Whether nobody can have come from the pose before to this one.
func _jumps(p_pose: PoseSample) -> bool:
	var frames: float = _missing + 1.0
	var step: float = _before.root.distance_to(p_pose.root) / frames
	var jumps: bool = step > JUMP_M and step > 3.0 * _step
	_step = step
	for limb: int in Limbs.COUNT:
		var turn: float = _before.orientation(limb).angle_to(p_pose.orientation(limb)) / frames
		jumps = jumps or (turn > JUMP_RAD and turn > 3.0 * _turns[limb])
		_turns[limb] = turn
	return jumps


func _look() -> void:
	var amount: float = 0.0
	for track: MotionTrack in takes[-1].tracks:
		amount += track.amount(phase())
	progress = clampf(amount / phase().need, 0.0, 1.0)
	if amount >= phase().need:
		_conclude(true, "Good")
	elif _frames >= phase().limit_s * MotionTrack.RATE:
		_fall_short(amount)


func _fall_short(p_amount: float) -> void:
	var any: float = 0.0
	for track: MotionTrack in takes[-1].tracks:
		any += track.amount(phase(), true)
	var what: String = phase().describe(p_amount, any)
	if _attempt >= GuidedPhase.REPEATS:
		_conclude(false, "%s: %s is left out" % [what, phase().name])
		return
	_attempt += 1
	_end_track()
	said.emit("Not enough yet: %s. Once more" % what)
	_announce()


func _conclude(p_is_had: bool, p_text: String) -> void:
	_end_track()
	if not takes.is_empty() and takes[-1].phase == phase():
		takes[-1].is_had = p_is_had
	said.emit(p_text)
	_attempt = 0
	index += 1
	_announce()


static func _between(p_from: PoseSample, p_to: PoseSample, p_share: float) -> PoseSample:
	var pose: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		var turn: Quaternion = p_from.orientation(limb).slerp(p_to.orientation(limb), p_share)
		pose.set_orientation(limb, turn)
	pose.root = p_from.root.lerp(p_to.root, p_share)
	return pose

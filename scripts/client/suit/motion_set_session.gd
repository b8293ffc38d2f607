class_name MotionSetSession
extends RefCounted
## Records a motion set from a wearer: takes the motion of the first person of the sources that the
## options name, 60 times a second, and leads that one through a [GuidedRecording].
##
## Call [method advance] with the time, as often as possible; it has no clock of its own.

## Something that the wearer is to read.
signal said(text: String)

## For how long nobody's motion is waited for, s: before the first, and once it was there.
const BEGINS_S: float = 600.0
const RETURNS_S: float = 60.0
## What comes later than this is lost, s: a program that was held up has not seen it.
const LATE_S: float = 0.25
const _PERIOD_USEC: float = 1e6 / MotionTrack.RATE

## Who leads.
var guide: GuidedRecording = null
## Where motion comes from.
var inputs: MotionInputs = MotionInputs.new()
## The files.
var recording: MotionSetRecording = MotionSetRecording.new()
## Whose motion is recorded, or null.
var source: MotionSource = null
## The newest pose, or null.
var newest: PoseSample = null
## Whether all is over, and the set is to be made: [method finish].
var is_over: bool = false

var _due_usec: float = -1.0
var _last_usec: float = 0.0
var _travel: FootTravel = null
var _told: String = ""


## Leads through all phases but those that are left out by name.
func _init(p_skipped: PackedStringArray = []) -> void:
	guide = GuidedRecording.new(GuidedPhase.all(p_skipped))
	guide.said.connect(said.emit)
	inputs.appeared.connect(_on_appeared)
	inputs.vanished.connect(_on_vanished)


## Opens the sources and the files for a set's name. Returns what is wrong, or an empty text.
func open(p_options: Options, p_out: String) -> String:
	var addresses: Array[SourceAddress] = SourceAddress.of_options(p_options)
	if addresses.is_empty() and p_options.text("suit-play") == "":
		return "whose motion? Name a source, such as --source=xbus, --source=webcam or --bvh=FILE"
	for address: SourceAddress in addresses:
		if address.kind == "walker":
			return "a walker's motion is made by a set: name a suit, a webcam or a file"
	var fault: String = recording.open(p_out)
	return fault if fault != "" else inputs.open(p_options)


## Goes on until a time, µs of Unix time.
func advance(p_now_usec: float) -> void:
	if is_over:
		return
	inputs.advance(p_now_usec / 1e6)
	if _due_usec < 0.0:
		_due_usec = p_now_usec
		_last_usec = p_now_usec
	_skip_what_is_late(p_now_usec)
	while _due_usec <= p_now_usec and not is_over:
		_take(_sample(roundi(_due_usec)))
		_due_usec += _PERIOD_USEC
		is_over = guide.state == GuidedRecording.State.DONE
	recording.advance()
	_tell(inputs.guide(p_now_usec / 1e6))
	_look_whether_it_ends(p_now_usec)


## Ends it: what there is so far is kept.
func stop() -> void:
	is_over = true


## Makes the set and closes all. Returns what is wrong, or an empty text.
func finish() -> String:
	is_over = true
	guide.finish()
	inputs.close()
	var fault: String = recording.error
	if fault == "":
		fault = recording.build()
	for note: String in recording.notes:
		said.emit(note)
	said.emit("What was recorded is in %s" % recording.folder())
	return fault


func _sample(p_time_usec: int) -> PoseSample:
	var pose: PoseSample = source.sample(p_time_usec) if source != null else null
	var file: BvhSource = source as BvhSource
	return null if file != null and file.is_at_seam(p_time_usec) else pose


func _take(p_pose: PoseSample) -> void:
	if p_pose == null or p_pose.find_fault() != "":
		guide.take(null)
		if _travel != null and guide.is_lost():
			_travel.restart()
		return
	if guide.state == GuidedRecording.State.WAITING:
		_begin()
	# The source may keep what it gave.
	var pose: PoseSample = PoseSample.new()
	pose.orientations = p_pose.orientations
	pose.root = p_pose.root
	pose.details = p_pose.details
	var frames: float = maxf(1.0, roundf((_due_usec - _last_usec) / _PERIOD_USEC))
	if pose.root.x == 0.0 and pose.root.z == 0.0:
		_travel.move(pose, frames / MotionTrack.RATE)
	_last_usec = _due_usec
	newest = pose
	guide.take(pose)


func _begin() -> void:
	var height: float = source.get_hip_height()
	said.emit("%s: hips at %.2f m" % [source.describe(), height])
	_travel = FootTravel.new(source.get_body())
	recording.begin(guide, source)
	guide.begin(height)


func _skip_what_is_late(p_now_usec: float) -> void:
	var late: int = floori((p_now_usec - _due_usec - LATE_S * 1e6) / _PERIOD_USEC)
	if late <= 0:
		return
	for _frame: int in mini(late, 2 * GuidedRecording.BRIDGED):
		guide.take(null)
	if _travel != null:
		_travel.restart()
	_due_usec += late * _PERIOD_USEC


func _look_whether_it_ends(p_now_usec: float) -> void:
	var limit: float = RETURNS_S
	if guide.state == GuidedRecording.State.WAITING:
		limit = BEGINS_S
	if recording.error != "":
		said.emit(recording.error)
		stop()
	elif not is_over and p_now_usec - _last_usec > limit * 1e6:
		said.emit("No motion has come for %.0f s: it ends" % limit)
		stop()


## Says what a suit or a calibration wants of the wearer, once.
func _tell(p_text: String) -> void:
	if p_text != _told and p_text != "":
		said.emit(p_text)
	_told = p_text


func _on_appeared(p_source: MotionSource, _name: String) -> void:
	if source == null:
		source = p_source
	else:
		said.emit("%s is there too, and not recorded" % p_source.describe())


func _on_vanished(p_source: MotionSource) -> void:
	if p_source == source:
		source = null

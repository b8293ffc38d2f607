extends Node3D
## A character that wears a suit: the trackers on USB, calibrated in a T-pose, as an [XRBodyTracker]
## that an [XRBodyModifier3D] puts on a skeleton.

## The wearer has been calibrated: from now on the tracker moves.
signal calibrated

## Nobody else has been plugged in for so long: all trackers are there, s.
const _SETTLE_S: float = 1.0
## How long a calibration that failed is shown before the next, s.
const _AGAIN_S: float = 3.0

## Samples a second that the suit is asked for.
@export_range(10.0, 512.0, 1.0, "suffix:Hz") var rate_hz: float = 100.0
## How the wearer is calibrated.
@export var kind: CalibrationGuide.Kind = CalibrationGuide.Kind.T_POSE

## What the tracker is called at the [XRServer].
var tracker_name: StringName = TrackerPublisher.NAME

var _feed: UsbSuitFeed = UsbSuitFeed.new()
var _source: SuitSource = null
var _publisher: TrackerPublisher = null
var _revision: int = -1
var _waits_until_s: float = 0.0

@onready var _text: Label = $Text
@onready var _avatar: Node3D = $Avatar


func _ready() -> void:
	_feed.open(rate_hz)
	_source = SuitSource.new(_feed)
	_source.calibrated.connect(_on_calibrated)
	if _feed.error != "":
		push_error(_feed.error)
	_publisher = TrackerPublisher.new(_source.get_body(), tracker_name)
	var modifier: XRBodyModifier3D = XRBodyModifier3D.new()
	modifier.body_tracker = tracker_name
	var skeletons: Array[Node] = _avatar.find_children("*", "Skeleton3D", true, false)
	skeletons[0].add_child(modifier)


func _exit_tree() -> void:
	_publisher.retire()
	_feed.close()


func _process(_p_delta: float) -> void:
	var now_s: float = Time.get_ticks_usec() / 1e6
	_feed.advance()
	_source.advance(now_s)
	_calibrate(now_s)
	var pose: PoseSample = _source.sample(roundi(Time.get_unix_time_from_system() * 1e6))
	if pose != null:
		_publisher.publish(pose)


## Begins as soon as all trackers measure, and tells the wearer what to do.
func _calibrate(p_now_s: float) -> void:
	if _source.process.is_running():
		_text.text = (
			"%s\n%d" % [_source.process.instruction(), ceili(_source.process.seconds_left)]
		)
		return
	if _source.is_calibrated():
		_text.text = ""
		return
	if _feed.revision != _revision or _source.newest_frame == null or not _feed.is_settled():
		_revision = _feed.revision
		_waits_until_s = p_now_s + _SETTLE_S
		_text.text = _feed.trouble() if _feed.trouble() != "" else _feed.describe()
		return
	if p_now_s > _waits_until_s:
		var fault: String = _source.start_calibration(kind, p_now_s)
		if fault != "":
			_text.text = fault
			_waits_until_s = p_now_s + _AGAIN_S


func _on_calibrated(p_result: CalibrationResult) -> void:
	if p_result.error != "":
		_source.refuse_calibration()
		_text.text = p_result.error
		_waits_until_s = Time.get_ticks_usec() / 1e6 + _AGAIN_S
		return
	_source.accept_calibration()
	calibrated.emit()

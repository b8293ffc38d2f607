class_name FusedSource
extends MotionSource
## Another source's motion, fitted to the headset and the controllers of its wearer.
##
## The main thread hands over an [XrFrame] in every frame; any one thread samples.

# The wearer's size is looked at once in so many samples; joints that differ by less are the same,
# m.
const _SIZE_SAMPLES: int = 60
const _SAME_M: float = 0.003

## How the body is fitted. Settings may be changed at any time, [member HeadFusion.mount] only
## while nobody samples.
var fusion: HeadFusion = null
## The source that is fitted.
var source: MotionSource = null

var _frames: XrFrames = XrFrames.new()
var _frame: XrFrame = XrFrame.new()
var _recentred: int = 0
var _own: ShownFigure = null
var _size_in: int = 0
# Shared between threads and guarded.
var _mutex: Mutex = Mutex.new()
var _correction: float = 0.0
var _shown: ShownFigure = null
var _turned: float = 0.0
var _is_reset: bool = false


func _init(p_source: MotionSource) -> void:
	source = p_source
	error = p_source.error
	_own = ShownFigure.of_size(p_source.get_body())
	fusion = HeadFusion.new(p_source.get_body())


## Takes what the devices say now, in the main thread.
func push(p_frame: XrFrame) -> void:
	_frames.push(p_frame)


## The tracking space was moved (the runtime recentred): the body goes along at once.
func recentre() -> void:
	_mutex.lock()
	_is_reset = true
	_mutex.unlock()
	_frames.recentre()


## The tracking space was turned by an angle about +Y, rad, as by a step of a thumbstick: the body
## goes along, and what was learnt of the suit stays.
func turn(p_angle: float) -> void:
	_mutex.lock()
	_turned += p_angle
	_mutex.unlock()
	_frames.recentre()


## Takes the body that the wearer is shown as, and the height of its hips, m. Returns why not, or an
## empty text.
func show_on(p_skeleton: PersonSkeleton, p_hips: float) -> String:
	var figure: ShownFigure = ShownFigure.of_skeleton(p_skeleton, p_hips, get_hip_height())
	if figure == null:
		return "the body that is shown has no joints of a person"
	_mutex.lock()
	_shown = figure
	_mutex.unlock()
	return ""


## How far the body is turned against the suit, rad.
func correction() -> float:
	_mutex.lock()
	var angle: float = _correction
	_mutex.unlock()
	return angle


func get_hip_height() -> float:
	return source.get_hip_height()


func get_limb_lengths() -> PackedFloat32Array:
	return source.get_limb_lengths()


func get_body() -> BodySize:
	return source.get_body()


func describe() -> String:
	return source.describe() + ", with a headset"


func _read(p_time_usec: int) -> PoseSample:
	var raw: PoseSample = source.sample(p_time_usec)
	error = source.error
	if raw == null:
		return null
	# A source may go on with its own pose.
	var pose: PoseSample = PoseSample.new()
	pose.time_usec = raw.time_usec
	pose.orientations = raw.orientations.duplicate()
	pose.root = raw.root
	pose.details = raw.details
	var times: int = _frames.recentred()
	if times != _recentred:
		_recentred = times
		_follow_space()
	_note_size()
	_frames.read(pose.time_usec, _frame)
	fusion.apply(pose, _frame)
	_mutex.lock()
	_correction = fusion.correction()
	_mutex.unlock()
	return pose


func _follow_space() -> void:
	_mutex.lock()
	var is_reset: bool = _is_reset
	var turned: float = _turned
	_is_reset = false
	_turned = 0.0
	_mutex.unlock()
	if is_reset:
		fusion.recentre()
	else:
		fusion.turn(turned)


## Uses the body that is shown, if one was said, else the wearer's own size: a suit may be measured
## meanwhile.
func _note_size() -> void:
	_mutex.lock()
	var shown: ShownFigure = _shown
	_shown = null
	_mutex.unlock()
	_size_in -= 1
	if shown != null:
		fusion.set_figure(shown)
	elif _size_in <= 0:
		_size_in = _SIZE_SAMPLES
		var own: ShownFigure = ShownFigure.of_size(source.get_body())
		if not own.is_like(_own, _SAME_M):
			_own = own
			fusion.set_figure(own)

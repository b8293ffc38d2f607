class_name FusedSource
extends XrSource
## Another source's motion, fitted to the headset and the controllers of its wearer.

# The wearer's size is looked at once in so many samples; joints that differ by less are the same,
# m.
const _SIZE_SAMPLES: int = 60
const _SAME_M: float = 0.003

## How the body is fitted. Settings may be changed at any time, [member HeadFusion.mount] only
## while nobody samples.
var fusion: HeadFusion = null
## The source that is fitted.
var source: MotionSource = null

var _own: ShownFigure = null
var _size_in: int = 0
# Shared between threads and guarded.
var _correction: float = 0.0
var _turned: float = 0.0
var _is_reset: bool = false


func _init(p_source: MotionSource) -> void:
	source = p_source
	error = p_source.error
	_own = ShownFigure.of_size(p_source.get_body())
	fusion = HeadFusion.new(p_source.get_body())


## The tracking space was moved (the runtime recentred): the body goes along at once.
func recentre() -> void:
	_mutex.lock()
	_is_reset = true
	_mutex.unlock()
	super()


## The tracking space was turned by an angle about +Y, rad, as by a step of a thumbstick: the body
## goes along, and what was learnt of the suit stays.
func turn(p_angle: float) -> void:
	_mutex.lock()
	_turned += p_angle
	_mutex.unlock()
	super.recentre()


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
	if _was_moved():
		_follow_space()
	_note_size()
	fusion.apply(pose, _read_frame(pose.time_usec))
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
	var shown: ShownFigure = _take_shown()
	_size_in -= 1
	if shown != null:
		fusion.set_figure(shown)
	elif _size_in <= 0:
		_size_in = _SIZE_SAMPLES
		var own: ShownFigure = ShownFigure.of_size(source.get_body())
		if not own.is_like(_own, _SAME_M):
			_own = own
			fusion.set_figure(own)

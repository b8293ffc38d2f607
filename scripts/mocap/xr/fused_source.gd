class_name FusedSource
extends MotionSource
## Another source's motion, fitted to the headset and the controllers of its wearer.
##
## The main thread hands over an [XrFrame] in every frame; any one thread samples.

## How the body is fitted. Settings may be changed at any time, [member HeadFusion.mount] only
## while nobody samples.
var fusion: HeadFusion = null
## The source that is fitted.
var source: MotionSource = null

var _frames: XrFrames = XrFrames.new()
var _frame: XrFrame = XrFrame.new()
var _recentred: int = 0
var _mutex: Mutex = Mutex.new()
var _correction: float = 0.0


func _init(p_source: MotionSource) -> void:
	source = p_source
	error = p_source.error
	fusion = HeadFusion.new(p_source.get_body())


## Takes what the devices say now, in the main thread.
func push(p_frame: XrFrame) -> void:
	_frames.push(p_frame)


## The tracking space was moved (the runtime recentred): the body goes along at once.
func recentre() -> void:
	_frames.recentre()


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
	var pose: PoseSample = source.sample(p_time_usec)
	error = source.error
	if pose == null:
		return null
	var times: int = _frames.recentred()
	if times != _recentred:
		_recentred = times
		fusion.recentre()
	_frames.read(pose.time_usec, _frame)
	fusion.apply(pose, _frame)
	_mutex.lock()
	_correction = fusion.correction()
	_mutex.unlock()
	return pose

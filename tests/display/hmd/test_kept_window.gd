extends TestCase
## What the window has beside a headset, and after it.

var _kept: KeptWindow = KeptWindow.new()
var _window: Window = null
var _rate: int = 0


func before_each() -> void:
	_rate = Engine.max_fps
	_kept = KeptWindow.new()
	_window = get_tree().root


func after_each() -> void:
	_kept.give_back()
	_window.scaling_3d_scale = 1.0
	Engine.max_fps = _rate


func test_the_window_gets_back_what_it_had() -> void:
	Engine.max_fps = 72
	_window.scaling_3d_scale = 0.8
	_kept.take(_window)
	equal(Engine.max_fps, 0, "the headset is the pace")
	_kept.share = 0.5
	_kept.hold()
	almost_equal(_window.scaling_3d_scale, 0.4, 1e-5)
	_window.disable_3d = true
	_kept.give_back()
	equal(Engine.max_fps, 72)
	almost_equal(_window.scaling_3d_scale, 0.8, 1e-5)
	is_false(_window.disable_3d)


func test_a_step_of_quality_leaves_the_share() -> void:
	_kept.take(_window)
	_kept.share = 0.5
	_kept.hold()
	# Somebody chooses a lower resolution.
	_window.scaling_3d_scale = 0.7
	for i: int in 3:
		_kept.hold()
	almost_equal(_window.scaling_3d_scale, 0.35, 1e-5)
	_kept.give_back()
	almost_equal(_window.scaling_3d_scale, 0.7, 1e-5)
	_window.scaling_3d_scale = 0.9
	_kept.hold()
	almost_equal(_window.scaling_3d_scale, 0.9, 1e-5, "given back, it is nobody's")

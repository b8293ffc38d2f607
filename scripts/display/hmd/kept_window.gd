class_name KeptWindow
extends RefCounted
## What a window had before a headset took its pace, and how much of it is drawn meanwhile.
##
## Others go on to choose the window's resolution, such as with the quality: the headset's share is
## put on top of what they choose, and what they have chosen comes back afterwards.

## Share of the window's own resolution that is drawn, in each direction.
var share: float = 1.0

var _window: Window = null
var _vsync: DisplayServer.VSyncMode = DisplayServer.VSYNC_ENABLED
var _rate: int = 0
var _has_no_world: bool = false
var _own_scale: float = 1.0
var _set_scale: float = 1.0


## The headset's rate is the pace from now on: waiting for the screen as well would halve it.
func take(p_window: Window) -> void:
	_window = p_window
	_has_no_world = p_window.disable_3d
	_own_scale = p_window.scaling_3d_scale
	_set_scale = _own_scale
	_rate = Engine.max_fps
	_vsync = DisplayServer.window_get_vsync_mode(p_window.get_window_id())
	DisplayServer.window_set_vsync_mode(DisplayServer.VSYNC_DISABLED, p_window.get_window_id())
	Engine.max_fps = 0


## A frame: draws the share of what the window has, whoever has changed that.
func hold() -> void:
	if _window == null:
		return
	if not is_equal_approx(_window.scaling_3d_scale, _set_scale):
		_own_scale = _window.scaling_3d_scale
	_window.scaling_3d_scale = _own_scale * share
	_set_scale = _window.scaling_3d_scale


## The window is as it was, but for what others have chosen since.
func give_back() -> void:
	if _window == null:
		return
	share = 1.0
	hold()
	_window.disable_3d = _has_no_world
	Engine.max_fps = _rate
	DisplayServer.window_set_vsync_mode(_vsync, _window.get_window_id())
	_window = null

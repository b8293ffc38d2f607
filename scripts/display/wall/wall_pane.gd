class_name WallPane
extends Node
## Shows what is behind one screen of a station, in a window: off-axis, for one eye or both, warped
## and blended for its projector.

## Below everything that lies over the world.
const _LAYER: int = -128
## Least distance of an eye from its screen, m.
const _NEAREST_M: float = 0.01

## The screen that it shows; null before [method open].
var screen: WallScreen = null
## The window in which it shows the screen.
var window: Window = null
## Whether each eye gets the other one's picture than the layout says.
var swap_eyes: bool = false:
	set(p_value):
		swap_eyes = p_value
		if not _views.is_empty():
			_connect_pictures()

var _views: Array[EyeView] = []
var _pictures: Array[EyePicture] = []
var _canvas: Node2D = Node2D.new()
var _layer: CanvasLayer = CanvasLayer.new()
var _test: TestPicture = null
var _drawn_size: Vector2i = Vector2i.ZERO


## Shows a screen in a window.
func open(p_screen: WallScreen, p_window: Window) -> void:
	screen = p_screen
	window = p_window
	_layer.layer = _LAYER
	_layer.add_child(_canvas)
	# It goes with the window, or with the pane where the window stays.
	if window == get_window():
		add_child(_layer)
	else:
		window.add_child(_layer)
	for _eye: int in StereoMode.eyes(screen.mode):
		var view: EyeView = EyeView.new()
		_views.append(view)
		add_child(view)
	for _part: int in StereoMode.frames(screen.mode, Vector2i.ONE * 2).size():
		var picture: EyePicture = EyePicture.new()
		picture.fade_edges(screen.blend, screen.gamma, screen.black_lift())
		if not screen.warp.is_empty():
			picture.warp_by(Homography.to_corners(screen.warp).inverse())
		_pictures.append(picture)
		_canvas.add_child(picture)
	_fit()
	_connect_pictures()


## Shows the world of a camera from an eye of the station, which has a transform in the world. The
## eyes are a distance apart, m, along an axis of the station.
func follow(
	p_viewer: Camera3D, p_station: Transform3D, p_eye: Vector3, p_right: Vector3, p_apart_m: float
) -> void:
	_fit()
	var eyes: PackedInt32Array = StereoMode.eyes(screen.mode)
	for at: int in eyes.size():
		var side: float = 0.0 if eyes[at] < 0 else eyes[at] - 0.5
		# A screen of one eye is swapped by being the other one's.
		if eyes.size() == 1 and _is_swapped():
			side = -side
		var eye: Vector3 = p_eye + p_right * side * p_apart_m
		var frustum: OffAxisFrustum = screen.seen_from(eye)
		frustum.distance = maxf(frustum.distance, _NEAREST_M)
		_views[at].follow(p_viewer)
		var camera: Camera3D = _views[at].camera
		camera.global_transform = p_station * Transform3D(frustum.basis, eye)
		frustum.aim(camera, p_viewer.near, p_viewer.far)


## Shows a test picture, or the world again.
func show_test(p_kind: TestPicture.Kind) -> void:
	if p_kind == TestPicture.Kind.NONE:
		if _test != null:
			_test.queue_free()
		_test = null
	else:
		if _test == null:
			_test = TestPicture.new()
			add_child(_test)
		_test.draw_for(screen, p_kind, StereoMode.frames(screen.mode, window.size)[0].size)
	for view: EyeView in _views:
		# What is not seen is not drawn.
		view.render_target_update_mode = (
			SubViewport.UPDATE_ALWAYS if _test == null else SubViewport.UPDATE_DISABLED
		)
	_connect_pictures()


func _is_swapped() -> bool:
	return screen.swap_eyes != swap_eyes


func _connect_pictures() -> void:
	var left: Texture2D = _views[0].get_texture()
	var right: Texture2D = _views[-1].get_texture()
	if _is_swapped():
		var other: Texture2D = left
		left = right
		right = other
	if _test != null:
		left = _test.get_texture()
		right = left
	var crop: Rect2 = WallScreen.crop_of(screen.shape(), _views[0].size)
	for part: int in _pictures.size():
		_pictures[part].crop_to(crop if _test == null else Rect2(0.0, 0.0, 1.0, 1.0))
		var only: Texture2D = left if part == 0 else right
		_pictures[part].show_eyes(only, right, StereoMode.mix(screen.mode))


## Follows the window's size and its position on the panel.
func _fit() -> void:
	var size: Vector2i = window.size
	_canvas.scale = window.get_visible_rect().size / Vector2(size)
	for picture: EyePicture in _pictures:
		picture.follow_panel(window)
	if size == _drawn_size:
		return
	_drawn_size = size
	var frames: Array[Rect2i] = StereoMode.frames(screen.mode, size)
	for part: int in frames.size():
		if screen.mesh == null:
			_pictures[part].fill(frames[part])
		else:
			screen.mesh.draw_on(_pictures[part], frames[part])
	for view: EyeView in _views:
		view.resize(WallScreen.picture_for(screen.shape(), frames[0].size))
	_connect_pictures()

class_name StereoDisplay
extends DisplayMode
## Shows the world to both eyes without a headset: side by side, one above the other, for coloured
## or polarised glasses, or one eye alone of two screens that share their corners.
##
## Both eyes look ahead side by side with off-axis frusta, so that what is at [member convergence]
## is in the plane of the screen. Their two pictures are drawn as the window draws, composed in one
## canvas pass below everything else. Texts and menus are in the plane of the screen. Cost: two
## views; squeezed pictures are drawn whole, because the engine has no oblong pixels.

## Widest and nearest that make sense, m: beyond the one eyes hurt, nearer than the other all is
## behind the screen.
const _MAX_EYES_M: float = 1.0
const _MIN_CONVERGENCE_M: float = 0.1
## Below everything that lies over the world.
const _LAYER: int = -128

## Distance between the eyes, m.
var eye_distance: float = 0.065
## Distance of the plane of the screen, m: what is there is at the same position for both eyes.
var convergence: float = 3.0
## Whether the left eye's picture is where the right one's should be: for displays and glasses that
## are the other way round.
var swap_eyes: bool = false:
	set(p_value):
		swap_eyes = p_value
		_connect_pictures()

var _kind: StereoMode.Kind = StereoMode.Kind.SIDE_BY_SIDE
var _window: Window = null
var _views: Array[EyeView] = []
var _pictures: Array[EyePicture] = []
var _hud: HudPicture = null
var _hud_places: Array[TextureRect] = []
var _canvas: Node2D = null
var _is_passing_on: bool = false
var _kept: Dictionary[StringName, Variant] = {}


## Takes a mode of [constant StereoMode.NAMES]. Returns what is wrong, or an empty text.
func set_up(p_mode: String, p_eye_distance_m: float, p_convergence_m: float) -> String:
	var kind: int = StereoMode.find(p_mode)
	if kind <= StereoMode.Kind.MONO:
		var modes: String = ", ".join(StereoMode.NAMES.slice(1))
		return "there is no stereo '%s': it is one of %s" % [ByteReader.clean(p_mode), modes]
	var fault: String = check_eyes(p_eye_distance_m, p_convergence_m)
	if fault != "":
		return fault
	_kind = kind as StereoMode.Kind
	eye_distance = p_eye_distance_m
	convergence = p_convergence_m
	return ""


## What is wrong with a distance between the eyes and one of the screen's plane, m; or nothing.
static func check_eyes(p_eye_distance_m: float, p_convergence_m: float) -> String:
	if not (p_eye_distance_m >= 0.0 and p_eye_distance_m <= _MAX_EYES_M):
		return "the distance between the eyes is 0 to %s m, usually 0.065" % _MAX_EYES_M
	if not (p_convergence_m >= _MIN_CONVERGENCE_M and is_finite(p_convergence_m)):
		var text: String = "the eyes meet at a distance of at least %s m: that of the screen's plane"
		return text % _MIN_CONVERGENCE_M
	return ""


func open() -> String:
	if DisplayServer.get_name() == "headless":
		return "stereo needs a window: start without --headless"
	if camera == null or not camera.is_inside_tree():
		return "stereo needs a camera of the client"
	_window = camera.get_window()
	_keep_window()
	var layer: CanvasLayer = CanvasLayer.new()
	layer.layer = _LAYER
	add_child(layer)
	_canvas = Node2D.new()
	layer.add_child(_canvas)
	for eye: int in StereoMode.eyes(_kind):
		var view: EyeView = EyeView.new()
		view.name = "Eye%d" % eye
		_views.append(view)
		add_child(view)
	for part: int in StereoMode.frames(_kind, Vector2i.ONE * 2).size():
		var picture: EyePicture = EyePicture.new()
		_pictures.append(picture)
		_canvas.add_child(picture)
	if StereoMode.parts(_kind) != Vector2i.ONE:
		_open_hud(layer)
	_connect_pictures()
	_fit()
	return ""


func close() -> void:
	if _window == null:
		return
	if _hud != null:
		_hud.give_back()
	for child: Node in get_children():
		remove_child(child)
		child.queue_free()
	_views.clear()
	_pictures.clear()
	_hud_places.clear()
	_hud = null
	_canvas = null
	for property: StringName in _kept:
		_window.set(property, _kept[property])
	_kept.clear()
	_window = null


## Gives each eye the other one's picture.
func swap() -> void:
	swap_eyes = not swap_eyes
	notified.emit("The eyes are swapped" if swap_eyes else "The eyes are as they were")


func report() -> Dictionary:
	return {
		"display": "stereo",
		"stereo": StereoMode.NAMES[_kind],
		"eye_distance": eye_distance,
		"convergence": convergence,
		"swap_eyes": swap_eyes,
	}


func _exit_tree() -> void:
	close()


func _process(_delta: float) -> void:
	if _window == null or camera == null or not camera.is_inside_tree():
		return
	_fit()
	var eyes: PackedInt32Array = StereoMode.eyes(_kind)
	for at: int in eyes.size():
		_views[at].follow(camera)
		# One eye of a station of two is swapped by being the other one.
		var is_other: bool = swap_eyes and eyes.size() == 1
		var side: float = (eyes[at] - 0.5) * (-1.0 if is_other else 1.0)
		_views[at].look_beside(camera, side * eye_distance, convergence)


## Menus are seen in parts of the window, not where they are laid out: what points at them follows.
func _input(p_event: InputEvent) -> void:
	var mouse: InputEventMouse = p_event as InputEventMouse
	var cut: Vector2 = StereoMode.parts(_kind)
	if mouse == null or _window == null or _is_passing_on or cut == Vector2.ONE:
		return
	# A new one: what is below the pointer was found before anybody was asked.
	var moved: InputEventMouse = mouse.duplicate()
	moved.position = (mouse.position * cut).posmodv(_window.get_visible_rect().size)
	moved.global_position = moved.position
	var motion: InputEventMouseMotion = moved as InputEventMouseMotion
	if motion != null:
		motion.relative *= cut
	_is_passing_on = true
	_window.push_input(moved, true)
	_is_passing_on = false
	_window.set_input_as_handled()


## The window draws no world of its own, and its pixels are not scaled.
func _keep_window() -> void:
	for property: StringName in [
		&"disable_3d",
		&"content_scale_mode",
		&"content_scale_aspect",
		&"content_scale_stretch",
		&"content_scale_size",
	]:
		_kept[property] = _window.get(property)
	_window.disable_3d = true
	_window.content_scale_mode = Window.CONTENT_SCALE_MODE_DISABLED


func _open_hud(p_layer: CanvasLayer) -> void:
	_hud = HudPicture.new()
	add_child(_hud)
	_hud.take_from(_window, p_layer)
	for _part: int in _pictures.size():
		var rect: TextureRect = TextureRect.new()
		rect.texture = _hud.get_texture()
		rect.expand_mode = TextureRect.EXPAND_IGNORE_SIZE
		rect.mouse_filter = Control.MOUSE_FILTER_IGNORE
		rect.material = ShaderMaterial.new()
		(rect.material as ShaderMaterial).shader = preload("res://assets/shaders/eye_hud.gdshader")
		_hud_places.append(rect)
		_canvas.add_child(rect)


func _connect_pictures() -> void:
	if _views.is_empty():
		return
	var left: Texture2D = _views[0].get_texture()
	var right: Texture2D = _views[-1].get_texture()
	if swap_eyes:
		var other: Texture2D = left
		left = right
		right = other
	var mix: EyePicture.Mix = StereoMode.mix(_kind)
	_pictures[0].show_eyes(left, right, mix)
	if _pictures.size() == 2:
		_pictures[1].show_eyes(right, right, mix)


## Follows the window's size and its position on the panel.
func _fit() -> void:
	var size: Vector2i = _window.size
	var frames: Array[Rect2i] = StereoMode.frames(_kind, size)
	if StereoMode.parts(_kind) != Vector2i.ONE and not StereoMode.is_squeezed(_kind):
		_lay_out_for(frames[0].size, size)
	# In pixels of the window, whatever the window scales its texts by.
	_canvas.scale = _window.get_visible_rect().size / Vector2(size)
	for view: EyeView in _views:
		view.resize(StereoMode.eye_size(_kind, size))
	for part: int in _pictures.size():
		_pictures[part].fill(frames[part])
		_pictures[part].follow_panel(_window)
	if _hud != null:
		_hud.fit(frames[0].size, _window.get_visible_rect().size)
		for place: int in _hud_places.size():
			_hud_places[place].position = frames[place].position
			_hud_places[place].size = frames[place].size


## Lets texts and menus be laid out for a part of the window, which shows them as wide as they are.
func _lay_out_for(p_part: Vector2i, p_window: Vector2i) -> void:
	if _window.content_scale_size == p_part or p_window.x < 2 or p_window.y < 2:
		return
	_window.content_scale_mode = Window.CONTENT_SCALE_MODE_CANVAS_ITEMS
	_window.content_scale_aspect = Window.CONTENT_SCALE_ASPECT_IGNORE
	_window.content_scale_stretch = Window.CONTENT_SCALE_STRETCH_FRACTIONAL
	_window.content_scale_size = p_part

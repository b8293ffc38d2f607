class_name EyeWindow
extends Window
## A window that shows one eye's picture beside the client's own, on another screen if there is one.
##
## Keys that are pressed in it are the client's.

## The user has closed it.
signal closed

var _picture: EyePicture = EyePicture.new()
var _hud: TextureRect = TextureRect.new()
var _first: Window = null


func _init() -> void:
	visible = false
	initial_position = Window.WINDOW_INITIAL_POSITION_ABSOLUTE
	disable_3d = true
	force_native = true
	add_child(_picture)
	_hud.expand_mode = TextureRect.EXPAND_IGNORE_SIZE
	_hud.material = ShaderMaterial.new()
	(_hud.material as ShaderMaterial).shader = preload("res://assets/shaders/eye_hud.gdshader")
	add_child(_hud)
	close_requested.connect(closed.emit)
	window_input.connect(_on_input)


## Where a window's upper left pixel is on its panel.
static func panel_origin(p_window: Window) -> Vector2i:
	return p_window.position - DisplayServer.screen_get_position(p_window.current_screen)


## Opens it as large as another window: at the same position on the next screen, or to its right.
func open_beside(p_first: Window) -> void:
	_first = p_first
	title = p_first.title + " - right eye"
	size = p_first.size
	var screens: int = DisplayServer.get_screen_count()
	var here: int = p_first.current_screen
	var there: int = (here + 1) % screens
	if there == here:
		position = p_first.position + Vector2i(p_first.size.x, 0)
	else:
		position = DisplayServer.screen_get_position(there) + panel_origin(p_first)
	show()


## Shows an eye's picture, and what lies over it.
func show_eye(p_eye: Texture2D, p_hud: Texture2D) -> void:
	_picture.show_eyes(p_eye, p_eye, EyePicture.Mix.LEFT)
	_hud.texture = p_hud


func _process(_delta: float) -> void:
	if _first == null:
		return
	var wanted: Window.Mode = Window.MODE_WINDOWED
	if _first.mode >= Window.MODE_FULLSCREEN:
		wanted = Window.MODE_FULLSCREEN
	if mode != wanted and mode != Window.MODE_MINIMIZED:
		mode = wanted
	if wanted == Window.MODE_WINDOWED and size != _first.size:
		size = _first.size
	_picture.fill(Rect2i(Vector2i.ZERO, size))
	_hud.size = size


func _on_input(p_event: InputEvent) -> void:
	if p_event is InputEventKey:
		_first.push_input(p_event)

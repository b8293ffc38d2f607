class_name WindowFrame
extends RefCounted
## The window around what a client shows: its title, its scale, and whether it fills the screen.

## Size of a window whose texts have the size that they were made for, pixels.
const _SIZE: Vector2 = Vector2(1280.0, 720.0)
## Dots per inch of a screen of that kind.
const _DPI: float = 96.0
const _MIN_SCALE: float = 0.75
const _MAX_SCALE: float = 4.0
## A dense screen makes texts larger than the window's size does by no more than this.
const _MAX_DENSITY: float = 1.5


## The title: what the window is, of whom, and where. Empty parts are left out.
static func title(p_role: String, p_name: String, p_where: String) -> String:
	var who: String = p_role if p_name == "" or p_name == p_role else "%s %s" % [p_role, p_name]
	var parts: PackedStringArray = ["Dismount", who]
	if p_where != "":
		parts.append(p_where)
	return " - ".join(parts)


## By how much everything on screen is enlarged in a window of a size, pixels, on a screen of so
## many dots per inch.
static func scale_for(p_size: Vector2, p_dpi: float) -> float:
	var fit: float = minf(p_size.x / _SIZE.x, p_size.y / _SIZE.y)
	var density: float = minf(p_dpi / _DPI, _MAX_DENSITY * fit)
	return clampf(maxf(fit, density), _MIN_SCALE, _MAX_SCALE)


## Lets the texts of a node's window follow the window's size and its screen, while the node is
## there.
static func follow(p_node: Node) -> void:
	var window: Window = p_node.get_window()
	var rescale: Callable = _rescale.bind(window, p_node.get_instance_id())
	if window.size_changed.is_connected(rescale):
		return
	window.size_changed.connect(rescale)
	p_node.tree_exiting.connect(window.size_changed.disconnect.bind(rescale), CONNECT_ONE_SHOT)
	rescale.call()


## Fills the screen, or goes back to a window.
static func toggle_full_screen(p_window: Window) -> void:
	if is_full_screen(p_window):
		p_window.mode = Window.MODE_WINDOWED
	else:
		p_window.mode = Window.MODE_FULLSCREEN


## Whether a window fills the screen.
static func is_full_screen(p_window: Window) -> bool:
	return p_window.mode >= Window.MODE_FULLSCREEN


# The follower makes the callables of several differ.
static func _rescale(p_window: Window, _p_follower: int) -> void:
	var dpi: float = DisplayServer.screen_get_dpi(p_window.current_screen)
	p_window.content_scale_factor = scale_for(p_window.size, dpi)

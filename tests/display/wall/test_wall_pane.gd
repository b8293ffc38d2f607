extends TestCase
## What each eye sees on a screen of a station.

const _TEXT: String = """[screen s]
bottom-left = -1 0 -1
bottom-right = 1 0 -1
top-left = -1 2 -1
size = 64 64
mode = %s
swap-eyes = %s
"""

var _viewer: Camera3D = null
var _window: Window = null
var _pane: WallPane = null


func before_each() -> void:
	_viewer = Camera3D.new()
	add_child(_viewer)
	_window = Window.new()
	_window.visible = false
	_window.size = Vector2i(64, 64)
	add_child(_window)


func after_each() -> void:
	_pane.free()
	_window.free()
	_viewer.free()


func _open(p_mode: String, p_swap: String) -> void:
	if _pane != null:
		_pane.free()
	_pane = WallPane.new()
	add_child(_pane)
	var text: String = _TEXT % [p_mode, p_swap]
	_pane.open(LayoutReader.parse(text.to_utf8_buffer(), "s.cfg").screens[0], _window)


## Where the eyes are that are drawn, m to the right.
func _eyes() -> Array[float]:
	_pane.follow(_viewer, Transform3D.IDENTITY, Vector3.UP, Vector3.RIGHT, 0.06)
	var found: Array[float] = []
	for child: Node in _pane.get_children():
		if child is EyeView:
			found.append(snappedf((child as EyeView).camera.global_position.x, 0.001))
	return found


func test_a_screen_of_one_eye_is_swapped_by_being_the_other_ones() -> void:
	for mode: String in ["left", "right"]:
		var own: float = -0.03 if mode == "left" else 0.03
		_open(mode, "no")
		equal(_eyes(), [own] as Array[float])
		_pane.swap_eyes = true
		equal(_eyes(), [-own] as Array[float])
		_pane.swap_eyes = false
		equal(_eyes(), [own] as Array[float])
		_open(mode, "yes")
		equal(_eyes(), [-own] as Array[float])
		_pane.swap_eyes = true
		equal(_eyes(), [own] as Array[float], "twice the other one")


func test_both_eyes_are_drawn_from_their_places_and_one_picture_from_between() -> void:
	_open("rows", "no")
	equal(_eyes(), [-0.03, 0.03] as Array[float])
	_pane.swap_eyes = true
	equal(_eyes(), [-0.03, 0.03] as Array[float], "their pictures are exchanged instead")
	_open("mono", "yes")
	equal(_eyes(), [0.0] as Array[float])

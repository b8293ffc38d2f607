class_name HeadsetNotice
extends Label3D
## A text below the middle of a wearer's view, for a while: what screens show as news.

## How long a text stays, s.
const STAYS_S: float = 6.0
## Where it is before the eyes, m, and how large its letters are.
const _PLACE: Vector3 = Vector3(0.0, -0.28, -1.2)
const _METRES_A_PIXEL: float = 0.001

var _left_s: float = 0.0


func _init() -> void:
	position = _PLACE
	pixel_size = _METRES_A_PIXEL
	font_size = 40
	outline_size = 14
	width = 900.0
	autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	no_depth_test = true
	render_priority = Material.RENDER_PRIORITY_MAX - 1
	outline_render_priority = Material.RENDER_PRIORITY_MAX - 2
	visible = false


## Shows a text instead of the one before.
func tell(p_text: String) -> void:
	text = p_text
	_left_s = STAYS_S
	visible = p_text != ""


func _process(p_delta: float) -> void:
	_left_s -= p_delta
	visible = visible and _left_s > 0.0

class_name CaptionLines
extends CanvasLayer
## Captions of sounds at the lower edge: what is heard, from where, how far; an arrow turns towards
## it.

## Most lines at once, and how long each stays, s.
const MAX_LINES: int = 4
const STAY_S: float = 3.5
const _LINE: float = 26.0
const _WIDTH: float = 420.0
const _BOTTOM: float = 96.0
## Arrows by eighths of a turn, from ahead to the right.
const _ARROWS: PackedStringArray = ["↑", "↗", "→", "↘", "↓", "↙", "←", "↖"]

var _labels: Array[Label] = []
var _left_s: PackedFloat32Array = []


func _init() -> void:
	layer = 2
	for line: int in MAX_LINES:
		var label: Label = Label.new()
		label.set_anchors_preset(Control.PRESET_CENTER_BOTTOM)
		label.offset_left = -_WIDTH / 2.0
		label.offset_right = _WIDTH / 2.0
		label.offset_top = -_BOTTOM - (line + 1) * _LINE
		label.offset_bottom = -_BOTTOM - line * _LINE
		label.horizontal_alignment = HORIZONTAL_ALIGNMENT_CENTER
		label.add_theme_color_override("font_outline_color", Color.BLACK)
		label.add_theme_constant_override("outline_size", 6)
		label.mouse_filter = Control.MOUSE_FILTER_IGNORE
		label.visible = false
		_labels.append(label)
		_left_s.append(0.0)
		add_child(label)


func _process(p_delta: float) -> void:
	for line: int in MAX_LINES:
		_left_s[line] -= p_delta
		_labels[line].visible = _left_s[line] > 0.0


## Shows a caption for a while; the oldest makes room. [param p_bearing] is 0 ahead, positive to the
## right, rad.
func show_caption(p_text: String, p_bearing: float) -> void:
	for line: int in range(MAX_LINES - 1, 0, -1):
		_labels[line].text = _labels[line - 1].text
		_left_s[line] = _left_s[line - 1]
	_labels[0].text = "%s  %s" % [_ARROWS[posmod(roundi(p_bearing / (PI / 4.0)), 8)], p_text]
	_left_s[0] = STAY_S


## The captions that are displayed, the newest first.
func texts() -> PackedStringArray:
	var shown: PackedStringArray = []
	for line: int in MAX_LINES:
		if _left_s[line] > 0.0:
			shown.append(_labels[line].text)
	return shown

class_name CaptionLines
extends CanvasLayer
## Captions of sounds at the lower edge: what is heard, from where, how far; an arrow turns towards
## it.

## Most lines at once, and how long each stays, s.
const MAX_LINES: int = 4
const STAY_S: float = 3.5
const _WIDTH: float = 420.0
## Above the prompt and the news of [Hud].
const _BOTTOM: float = 190.0
## Arrows by eighths of a turn, from ahead to the right.
const _ARROWS: PackedStringArray = ["↑", "↗", "→", "↘", "↓", "↙", "←", "↖"]

## The lines, the newest below.
var toasts: UiToasts = UiToasts.new()


func _init() -> void:
	layer = 2
	toasts.most = MAX_LINES
	toasts.stay_s = STAY_S
	toasts.alignment_of_lines = HORIZONTAL_ALIGNMENT_CENTER
	toasts.set_anchors_preset(Control.PRESET_CENTER_BOTTOM)
	toasts.grow_vertical = Control.GROW_DIRECTION_BEGIN
	toasts.offset_left = -_WIDTH / 2.0
	toasts.offset_right = _WIDTH / 2.0
	toasts.offset_top = -_BOTTOM
	toasts.offset_bottom = -_BOTTOM
	add_child(toasts)


## Shows a caption for a while; the oldest makes room. [param p_bearing] is 0 ahead, positive to the
## right, rad.
func show_caption(p_text: String, p_bearing: float) -> void:
	toasts.show_note("%s  %s" % [_ARROWS[posmod(roundi(p_bearing / (PI / 4.0)), 8)], p_text])


## The captions that are displayed, the newest first.
func texts() -> PackedStringArray:
	var shown: PackedStringArray = toasts.texts()
	shown.reverse()
	return shown

class_name UiToasts
extends VBoxContainer
## Notes over the world that stay for a while and fade. Nobody has to close them, so nothing that
## the user must know belongs here.

## How long a note fades at the end of its time, s.
const FADE_S: float = 0.4

## Most notes at once: the oldest makes room.
@export var most: int = 4
## How long each stays, s.
@export var stay_s: float = 6.0
## Whether the newest is the lowest.
@export var is_newest_last: bool = true
## Where lines begin.
@export var alignment_of_lines: HorizontalAlignment = HORIZONTAL_ALIGNMENT_LEFT

## Seconds that are left of each note, in the order of the labels.
var _left_s: Dictionary[Label, float] = {}


func _init() -> void:
	mouse_filter = Control.MOUSE_FILTER_IGNORE
	add_theme_constant_override(&"separation", 0)


func _process(p_delta: float) -> void:
	for label: Label in _left_s.keys():
		_left_s[label] -= p_delta
		label.modulate.a = clampf(_left_s[label] / FADE_S, 0.0, 1.0)
		if _left_s[label] <= 0.0:
			_remove(label)


## Shows a note.
func show_note(p_text: String) -> void:
	var label: Label = Label.new()
	label.theme_type_variation = UiStyle.OVERLAY
	label.add_theme_font_size_override(&"font_size", UiStyle.BODY_PX)
	label.text = p_text
	label.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	label.horizontal_alignment = alignment_of_lines
	label.mouse_filter = Control.MOUSE_FILTER_IGNORE
	add_child(label)
	if not is_newest_last:
		move_child(label, 0)
	_left_s[label] = stay_s
	while _left_s.size() > most:
		_remove(_left_s.keys()[0])


## The notes that are shown, from above.
func texts() -> PackedStringArray:
	var shown: PackedStringArray = []
	for label: Label in get_children():
		if _left_s.has(label):
			shown.append(label.text)
	return shown


func _remove(p_label: Label) -> void:
	_left_s.erase(p_label)
	p_label.queue_free()

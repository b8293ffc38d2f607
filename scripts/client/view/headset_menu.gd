class_name HeadsetMenu
extends PanelContainer
## The menu that the wearer of a headset sees at arm's length: few and large entries.

## One of the entries was chosen.
signal chosen(p_entry: Entry)

## What can be chosen.
enum Entry { CONTINUE, RECENTRE, SEATED, VIGNETTE, SNAP_TURN, LEAVE }

const _TEXTS: Dictionary[Entry, String] = {
	Entry.CONTINUE: "Continue",
	Entry.RECENTRE: "Recentre: where you look is ahead",
	Entry.SEATED: "Seated",
	Entry.VIGNETTE: "Darken the edge while you are moved",
	Entry.SNAP_TURN: "Turn by the right thumbstick",
	Entry.LEAVE: "Leave the session",
}
const _FONT_PX: int = 44

var _buttons: Dictionary[Entry, Button] = {}


func _init() -> void:
	var rows: VBoxContainer = VBoxContainer.new()
	add_child(rows)
	for entry: Entry in _TEXTS:
		var button: Button = Button.new()
		button.text = _TEXTS[entry]
		button.add_theme_font_size_override(&"font_size", _FONT_PX)
		button.focus_mode = Control.FOCUS_NONE
		button.size_flags_vertical = Control.SIZE_EXPAND_FILL
		button.pressed.connect(chosen.emit.bind(entry))
		_buttons[entry] = button
		rows.add_child(button)


## Says of the settings what they are.
func describe(p_is_seated: bool, p_has_vignette: bool, p_turns: bool) -> void:
	var states: Dictionary[Entry, bool] = {
		Entry.SEATED: p_is_seated, Entry.VIGNETTE: p_has_vignette, Entry.SNAP_TURN: p_turns
	}
	for entry: Entry in states:
		_buttons[entry].text = "%s: %s" % [_TEXTS[entry], "on" if states[entry] else "off"]


## The text of an entry, as it is shown.
func text_of(p_entry: Entry) -> String:
	return _buttons[p_entry].text

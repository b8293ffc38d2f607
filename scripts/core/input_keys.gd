class_name InputKeys
extends RefCounted
## Names of the keys that the project's input map has for actions.


## A button's text with the key that presses it: "Accept [F9]"; only the text where there is none.
static func label(p_text: String, p_action: StringName) -> String:
	var key: String = name_of(p_action)
	return "%s [%s]" % [p_text, key] if key != "" else p_text


## The first key of an action, for people: "F9", "Esc"; an empty text where it has none.
static func name_of(p_action: StringName) -> String:
	for event: InputEvent in InputMap.action_get_events(p_action):
		var key: InputEventKey = event as InputEventKey
		if key != null:
			var code: Key = key.get_keycode_with_modifiers()
			if key.keycode == KEY_NONE:
				code = key.get_physical_keycode_with_modifiers()
			return "Esc" if code == KEY_ESCAPE else OS.get_keycode_string(code)
	return ""

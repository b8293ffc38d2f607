class_name KeyGuide
extends RefCounted
## The keys that do something in a client of a role, for the line at the bottom and for the list.

## Keys of every client: input action, and what it does.
const _EVERYBODY: Dictionary[StringName, String] = {
	&"next_person": "follow the next person",
	&"toggle_names": "names over people",
	&"toggle_latency": "delays",
	&"toggle_full_screen": "full screen",
	&"swap_eyes": "swap the eyes, in stereo",
	&"test_picture": "test pictures, on walls",
	&"recentre": "recentre the headset",
	&"enter_headset": "back into the headset",
	&"show_keys": "these keys",
	&"ui_cancel": "menu",
}
const _VIEW: StringName = &"change_view"
const _CAMERA: StringName = &"next_camera"
const _TORCH: StringName = &"switch_torch"
const _USE: StringName = &"interact"
# Without a suit.
const _WALK: PackedStringArray = [
	"W, S, A, D\twalk, without a suit; a click lets the mouse turn you, Esc frees it",
	"Shift, Ctrl, X\trun; crouch; lie down and get up",
	"Space\tjump, or climb what is ahead",
]
const _MOUSE: String = "Drag, arrows\tturn the camera\nWheel\tcome nearer: at last to the face"


## The keys of a client that may send motion or not, and may use what is in the level or not: input
## action, and what it does.
static func actions(p_moves: bool, p_uses: bool) -> Dictionary[StringName, String]:
	var found: Dictionary[StringName, String] = {}
	for world: StringName in WorldViews.NAMES:
		found[&"view_" + world] = "%s world" % world
	found[_VIEW] = "camera: around, behind, eyes"
	found[_CAMERA] = "views of the level"
	if p_uses:
		found[_USE] = "use what is looked at"
	if p_moves:
		found[&"toggle_devices"] = "motion capture"
		found[&"toggle_mirror"] = "mirror"
		found[_TORCH] = "torch in the right hand"
	found.merge(_EVERYBODY)
	return found


## The whole list, a line for each.
static func describe(p_moves: bool, p_uses: bool) -> String:
	var lines: PackedStringArray = []
	var found: Dictionary[StringName, String] = actions(p_moves, p_uses)
	for action: StringName in found:
		lines.append("%s\t%s" % [InputKeys.name_of(action), found[action]])
	if p_uses:
		lines.append("W, S, A, D\tdrive, in a vehicle; the bottom of the screen has its keys")
	if p_moves:
		lines.append_array(_WALK)
	lines.append(_MOUSE)
	return "\n".join(lines)


## The line at the bottom, behind the worlds.
static func hint(p_moves: bool) -> String:
	var parts: PackedStringArray = []
	if p_moves:
		parts.append("%s motion capture" % InputKeys.name_of(&"toggle_devices"))
	parts.append("%s next person" % InputKeys.name_of(&"next_person"))
	parts.append("%s keys" % InputKeys.name_of(&"show_keys"))
	parts.append("%s menu" % InputKeys.name_of(&"ui_cancel"))
	return "   ".join(parts)

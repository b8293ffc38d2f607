class_name DeviceList
extends Tree
## The devices that were found, a row each, and what to do about those that do not work.

## What of a device is shown: keys of its dictionary, all of them texts.
const KEYS: PackedStringArray = ["name", "state", "detail"]
const _TITLES: PackedStringArray = ["Device", "State", "Details"]
const _WIDTHS: PackedInt32Array = [256, 90, 200]
const _NONE: String = "No device yet: plug in a suit, or look at Sources."

var _shown: Array[Dictionary] = []
var _is_filled: bool = false


func _init() -> void:
	columns = KEYS.size()
	column_titles_visible = true
	hide_root = true
	select_mode = Tree.SELECT_ROW
	add_theme_constant_override("v_separation", 0)
	add_theme_font_size_override("font_size", 13)
	add_theme_font_size_override("title_button_font_size", 13)
	for column: int in KEYS.size():
		set_column_title(column, _TITLES[column])
		set_column_title_alignment(column, HORIZONTAL_ALIGNMENT_LEFT)
		set_column_custom_minimum_width(column, _WIDTHS[column])
		set_column_expand(column, column == 2)
		set_column_clip_content(column, true)


## Shows devices: dictionaries with [constant KEYS] and perhaps "advice", texts all.
func show_devices(p_devices: Array[Dictionary]) -> void:
	if _is_filled and p_devices == _shown:
		return
	_is_filled = true
	_shown = p_devices.duplicate(true)
	clear()
	var root: TreeItem = create_item()
	if p_devices.is_empty():
		var row: TreeItem = create_item(root)
		row.set_text(2, _NONE)
		row.set_autowrap_mode(2, TextServer.AUTOWRAP_WORD_SMART)
	for device: Dictionary in p_devices:
		var row: TreeItem = create_item(root)
		for column: int in KEYS.size():
			row.set_text(column, str(device.get(KEYS[column], "")))
		var advice: String = str(device.get("advice", ""))
		if advice != "":
			row.set_text(2, advice)
			row.set_custom_color(2, SensorTable.WARN)
		row.set_autowrap_mode(2, TextServer.AUTOWRAP_WORD_SMART)

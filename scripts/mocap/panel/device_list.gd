class_name DeviceList
extends UiList
## The devices that were found, a row each, and what to do about those that do not work.

## What of a device is shown: keys of its dictionary, all of them texts.
const KEYS: PackedStringArray = ["name", "state", "detail"]
## Titles of their columns.
const TITLES: PackedStringArray = ["Device", "State", "Details"]
const _WIDTHS: PackedInt32Array = [256, 90, 200]
const _NONE: String = "No device yet: plug in a suit, or look at Sources."

var _shown: Array[Dictionary] = []
var _is_filled: bool = false


func _init() -> void:
	set_titles(TITLES, _WIDTHS, 2)
	add_theme_constant_override("v_separation", 0)


## Shows devices: dictionaries with [constant KEYS] and perhaps "advice", texts all.
func show_devices(p_devices: Array[Dictionary]) -> void:
	if _is_filled and p_devices == _shown:
		return
	_is_filled = true
	_shown = p_devices.duplicate(true)
	clear_rows()
	if p_devices.is_empty():
		add_row(["", "", _NONE], 2)
	for device: Dictionary in p_devices:
		var texts: PackedStringArray = []
		for key: String in KEYS:
			texts.append(str(device.get(key, "")))
		var advice: String = str(device.get("advice", ""))
		var row: TreeItem = add_row(texts, 2)
		if advice != "":
			row.set_text(2, advice)
			row.set_custom_color(2, UiStyle.WARN)

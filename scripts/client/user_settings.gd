class_name UserSettings
extends RefCounted
## What somebody has chosen on this machine, kept between starts in a file.

## The file.
const PATH: String = "user://settings.cfg"
const _DISPLAY: String = "display"
const _QUALITY: String = "quality"
## The device for which the program has chosen; empty where a person has.
const _CHOSEN_FOR: String = "quality_chosen_for"

var _path: String = PATH
var _file: ConfigFile = ConfigFile.new()


## Reads the file; one that is damaged counts as none.
func _init(p_path: String = PATH) -> void:
	_path = p_path
	if FileAccess.file_exists(_path) and _file.load(_path) != OK:
		Log.warning("client", "%s cannot be read: settings are those of a first start" % _path)
		_file.clear()


## The tier of quality: what was chosen, or what fits a device, which is kept. A choice of the
## program is made anew for another device, that of a person is not.
func quality(p_adapter: String, p_type: RenderingDevice.DeviceType) -> String:
	var kept: String = str(_file.get_value(_DISPLAY, _QUALITY, ""))
	var chosen_for: String = str(_file.get_value(_DISPLAY, _CHOSEN_FOR, ""))
	if Quality.NAMES.has(kept) and (chosen_for == "" or chosen_for == p_adapter):
		return kept
	var fitting: String = Quality.fitting(p_adapter, p_type)
	Log.info("client", "quality '%s' fits %s" % [fitting, p_adapter])
	_keep_quality(fitting, p_adapter)
	return fitting


## Keeps the tier of quality that a person has chosen.
func choose_quality(p_name: String) -> void:
	_keep_quality(p_name, "")


func _keep_quality(p_name: String, p_chosen_for: String) -> void:
	_file.set_value(_DISPLAY, _QUALITY, p_name)
	_file.set_value(_DISPLAY, _CHOSEN_FOR, p_chosen_for)
	var error: Error = _file.save(_path)
	if error != OK:
		Log.warning("client", "%s cannot be written: %s" % [_path, error_string(error)])

class_name UserSettings
extends RefCounted
## The user's choices on this machine, kept between starts in a file.

## The file.
const PATH: String = "user://settings.cfg"
const _SOUND: String = "sound"
## What of sound is on before a user has chosen.
const _SOUND_ON: Dictionary[StringName, bool] = {&"limiter": true}
const _DISPLAY: String = "display"
const _QUALITY: String = "quality"
## The device that the program chose a tier for; empty where a person has chosen.
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


## How loud a bus of [constant SoundBuses.SETTABLE] is, 0 to 1.
func volume(p_bus: StringName) -> float:
	var kept: Variant = _file.get_value(_SOUND, p_bus.to_lower(), 1.0)
	if not (kept is float or kept is int) or not is_finite(kept):
		return 1.0
	return clampf(kept, 0.0, 1.0)


## Keeps how loud a bus is, 0 to 1.
func choose_volume(p_bus: StringName, p_share: float) -> void:
	_file.set_value(_SOUND, p_bus.to_lower(), clampf(p_share, 0.0, 1.0))
	_save()


## Whether one of [constant SoundMenu.SWITCHES] is on.
func is_sound_on(p_name: StringName) -> bool:
	var kept: Variant = _file.get_value(_SOUND, p_name, "")
	return kept if kept is bool else _SOUND_ON.get(p_name, false)


## Keeps whether it is on.
func choose_sound(p_name: StringName, p_is_on: bool) -> void:
	_file.set_value(_SOUND, p_name, p_is_on)
	_save()


func _keep_quality(p_name: String, p_chosen_for: String) -> void:
	_file.set_value(_DISPLAY, _QUALITY, p_name)
	_file.set_value(_DISPLAY, _CHOSEN_FOR, p_chosen_for)
	_save()


func _save() -> void:
	var error: Error = _file.save(_path)
	if error != OK:
		Log.warning("client", "%s cannot be written: %s" % [_path, error_string(error)])

class_name ControlSettings
extends RefCounted
## How the axes of this machine's wheels and pedals were calibrated, kept between starts in a file.

## The file.
const PATH: String = "user://controls.cfg"
const _NAMES: Dictionary[AxisCalibrator.Kind, String] = {
	AxisCalibrator.Kind.STEER: "steer",
	AxisCalibrator.Kind.THROTTLE: "throttle",
	AxisCalibrator.Kind.BRAKE: "brake",
}

var _path: String = PATH
var _file: ConfigFile = ConfigFile.new()
## By device and control.
var _known: Dictionary[String, Dictionary] = {}


## Reads the file. Parts of it that are damaged count as not there, and are named in the log.
func _init(p_path: String = PATH) -> void:
	_path = p_path
	if not FileAccess.file_exists(_path):
		return
	if _file.load(_path) != OK:
		Log.warning("vehicle", "%s cannot be read: wheels must be calibrated anew" % _path)
		_file.clear()
		return
	for device: String in _file.get_sections():
		for control: AxisCalibrator.Kind in _NAMES:
			if not _file.has_section_key(device, _NAMES[control]):
				continue
			var kept: Variant = _file.get_value(device, _NAMES[control])
			var calibration: AxisCalibration = AxisCalibration.from_array(kept)
			if calibration == null:
				var parts: Array = [_path, _NAMES[control], device]
				Log.warning("vehicle", "%s: %s of %s is damaged and left out" % parts)
			else:
				_note(device, control, calibration)


## The calibration of a control of a device, or null.
func find(p_device: String, p_control: AxisCalibrator.Kind) -> AxisCalibration:
	return _known.get(p_device, {}).get(p_control)


## Keeps a calibration. Returns what is wrong with the file, or an empty text.
func keep(
	p_device: String, p_control: AxisCalibrator.Kind, p_calibration: AxisCalibration
) -> String:
	_note(p_device, p_control, p_calibration)
	_file.set_value(p_device, _NAMES[p_control], p_calibration.to_array())
	var error: Error = _file.save(_path)
	return "" if error == OK else "%s cannot be written: %s" % [_path, error_string(error)]


## Forgets what is known of a device.
func forget(p_device: String) -> void:
	_known.erase(p_device)
	if _file.has_section(p_device):
		_file.erase_section(p_device)
		_file.save(_path)


func _note(
	p_device: String, p_control: AxisCalibrator.Kind, p_calibration: AxisCalibration
) -> void:
	if not _known.has(p_device):
		_known[p_device] = {}
	_known[p_device][p_control] = p_calibration

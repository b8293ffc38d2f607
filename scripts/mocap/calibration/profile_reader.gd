class_name ProfileReader
extends RefCounted
## Reads a [PersonProfile] from the text of a file that anybody may have written, and writes it.

## Version of the files.
const VERSION: int = 1
## Maximum of a person's sensors.
const MAX_SENSORS: int = 64

## What is wrong: field and reason; empty if nothing is.
var error: String = ""


## The profile in a text, or null (and a reason in [member error]).
func read(p_text: String) -> PersonProfile:
	error = ""
	var json: JSON = JSON.new()
	if json.parse(p_text) != OK:
		error = "line %d: %s" % [json.get_error_line() + 1, json.get_error_message()]
		return null
	if not json.data is Dictionary:
		error = "it holds no object"
		return null
	var data: Dictionary = json.data
	var version: float = _number(data, "version", "version", 0.0, 1e6)
	if error == "" and int(version) != VERSION:
		error = "version: %d is not known here, only %d" % [int(version), VERSION]
	var profile: PersonProfile = PersonProfile.new()
	if error == "":
		profile.name = _text(data, "name", "name")
	if error == "" and PersonProfile.find_name_fault(profile.name) != "":
		error = "name: " + PersonProfile.find_name_fault(profile.name)
	if error == "":
		_read_size(_object(data, "size", "size"), profile.size)
	if error == "":
		_read_map(_object(data, "sensors", "sensors"), profile.map)
	if error == "" and data.get("calibration") != null:
		profile.calibration = _read_calibration(_object(data, "calibration", "calibration"))
	return profile if error == "" else null


## The text of a profile.
static func write(p_profile: PersonProfile) -> String:
	var data: Dictionary = {
		"version": VERSION,
		"name": p_profile.name,
		"size": p_profile.size.to_dictionary(),
		"sensors": p_profile.map.to_dictionary(),
		"calibration": null,
	}
	if p_profile.calibration != null:
		var sensors: Dictionary = {}
		for id: String in p_profile.calibration.entries:
			var entry: Calibration.Entry = p_profile.calibration.entries[id]
			var turn: Quaternion = entry.mounting
			sensors[id] = {
				# The key in all profiles that exist: the mount's name.
				"place": String(BodyMounts.NAMES[entry.mount]),
				"heading_rad": entry.heading,
				"mounting_xyzw": [turn.x, turn.y, turn.z, turn.w],
			}
			if not is_nan(entry.heading_error):
				sensors[id]["heading_error_rad"] = entry.heading_error
		data["calibration"] = {
			"kind": CalibrationGuide.NAMES[p_profile.calibration.kind],
			"pose": ResetPose.NAMES[p_profile.calibration.pose],
			"made_s": p_profile.calibration.made_s,
			"sensors": sensors,
		}
	return JSON.stringify(data, "\t", false, true) + "\n"


func _read_size(p_data: Dictionary, r_size: BodySize) -> void:
	var height: float = _number(p_data, "height_m", "size.height_m", 0.0, 100.0)
	if error == "" and r_size.set_height(height) != "":
		error = "size.height_m: " + r_size.set_height(height)
	if error != "":
		return
	var lengths: Dictionary = _object(p_data, "measured_m", "size.measured_m")
	for key: Variant in lengths:
		var field: String = "size.measured_m.%s" % _short(key)
		var metres: float = _number(lengths, key, field, 0.0, 100.0)
		var fault: String = r_size.measure(StringName(str(key)), metres) if error == "" else ""
		if fault != "":
			error = "%s: %s" % [field, fault]
		if error != "":
			return


func _read_map(p_data: Dictionary, r_map: SensorMap) -> void:
	if error == "" and p_data.size() > MAX_SENSORS:
		error = "sensors: at most %d, found %d" % [MAX_SENSORS, p_data.size()]
	for id: Variant in p_data:
		if error != "":
			return
		var mount: int = _mount(p_data, id, "sensors.%s" % _short(id))
		if error == "" and r_map.sensor_at(mount) != "":
			error = "sensors.%s: there are two on the %s" % [_short(id), BodyMounts.title(mount)]
		if error == "":
			r_map.assign(str(id), mount)


func _read_calibration(p_data: Dictionary) -> Calibration:
	var found: Calibration = Calibration.new()
	var kind: String = _text(p_data, "kind", "calibration.kind")
	if error == "" and not CalibrationGuide.NAMES.has(kind):
		var known: String = ", ".join(CalibrationGuide.NAMES)
		error = "calibration.kind: one of %s, found '%s'" % [known, kind.left(30)]
	found.kind = maxi(CalibrationGuide.NAMES.find(kind), 0) as CalibrationGuide.Kind
	var pose: String = _text(p_data, "pose", "calibration.pose")
	if error == "" and not ResetPose.NAMES.has(pose):
		error = "calibration.pose: T or N, found '%s'" % pose.left(30)
	found.pose = maxi(ResetPose.NAMES.find(pose), 0) as ResetPose.Kind
	found.made_s = _number(p_data, "made_s", "calibration.made_s", 0.0, 1e11)
	var sensors: Dictionary = _object(p_data, "sensors", "calibration.sensors")
	if error == "" and sensors.size() > MAX_SENSORS:
		error = "calibration.sensors: at most %d, found %d" % [MAX_SENSORS, sensors.size()]
	for id: Variant in sensors:
		var field: String = "calibration.sensors.%s" % _short(id)
		var data: Dictionary = _object(sensors, id, field)
		var entry: Calibration.Entry = Calibration.Entry.new()
		entry.mount = _mount(data, "place", field + ".place")
		entry.heading = _number(data, "heading_rad", field + ".heading_rad", -1e3, 1e3)
		if data.has("heading_error_rad"):
			var name: String = field + ".heading_error_rad"
			entry.heading_error = _number(data, "heading_error_rad", name, 0.0, 10.0)
		entry.mounting = _rotation(data, field + ".mounting_xyzw")
		if error != "":
			return null
		found.entries[str(id)] = entry
	return found if error == "" else null


func _rotation(p_data: Dictionary, p_field: String) -> Quaternion:
	if error != "":
		return Quaternion.IDENTITY
	var list: Variant = p_data.get("mounting_xyzw")
	if not list is Array or (list as Array).size() != 4:
		error = "%s: expected 4 numbers, found %s" % [p_field, _short(list)]
		return Quaternion.IDENTITY
	for part: Variant in list:
		if not part is float:
			error = "%s: expected 4 numbers, found %s" % [p_field, _short(list)]
			return Quaternion.IDENTITY
	var turn: Quaternion = Quaternion(list[0], list[1], list[2], list[3])
	# A comparison that NaN fails, too.
	if not absf(turn.length() - 1.0) < 0.01:
		error = "%s: is no rotation, its norm is %f" % [p_field, turn.length()]
		return Quaternion.IDENTITY
	return turn.normalized()


func _mount(p_data: Dictionary, p_key: Variant, p_field: String) -> int:
	var name: String = _text(p_data, p_key, p_field)
	var mount: int = BodyMounts.find(name)
	if error == "" and mount < 0:
		error = "%s: there is no mount '%s' on the body" % [p_field, name.left(30)]
	return mount


func _object(p_data: Dictionary, p_key: Variant, p_field: String) -> Dictionary:
	var found: Variant = p_data.get(p_key)
	if error == "" and not found is Dictionary:
		error = "%s: expected an object, found %s" % [p_field, _short(found)]
	return found if found is Dictionary else {}


func _text(p_data: Dictionary, p_key: Variant, p_field: String) -> String:
	var found: Variant = p_data.get(p_key)
	if error == "" and not found is String:
		error = "%s: expected a text, found %s" % [p_field, _short(found)]
	return found if found is String else ""


func _number(
	p_data: Dictionary, p_key: Variant, p_field: String, p_least: float, p_most: float
) -> float:
	var found: Variant = p_data.get(p_key)
	if error == "" and not found is float:
		error = "%s: expected a number, found %s" % [p_field, _short(found)]
	var number: float = found if found is float else 0.0
	# A comparison that NaN fails, too.
	if error == "" and not (number >= p_least and number <= p_most):
		error = "%s: expected %s to %s, found %s" % [p_field, p_least, p_most, number]
	return number


static func _short(p_value: Variant) -> String:
	return "nothing" if p_value == null else str(p_value).left(40)

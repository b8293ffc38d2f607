class_name MapDraft
extends RefCounted
## Changes of where sensors are worn that nobody has accepted yet: tried at once, undone one after
## the other, and kept only then.

## How many changes can be undone.
const DEPTH: int = 64

var _suit: SuitSource = null
var _before: Array[SensorMap] = []
# The rest of the wearer's data: with another person or calibration the changes become history.
var _name: String = ""
var _calibration: Calibration = null


## Whose sensors they are. The changes of somebody else, or from before a calibration, are
## forgotten, not undone.
func follow(p_suit: SuitSource) -> void:
	var profile: PersonProfile = p_suit.get_profile()
	var is_known: bool = p_suit == _suit and profile.name == _name
	if not is_known or profile.calibration != _calibration:
		_before.clear()
	_suit = p_suit
	_name = profile.name
	_calibration = profile.calibration


## The map before all changes; the present one where there are none.
func kept() -> SensorMap:
	return _before[0] if is_changed() else _suit.get_profile().map


## Whether something has not been accepted.
func is_changed() -> bool:
	return not _before.is_empty()


## Puts a sensor on a mount, -1: on none; a sensor that was there goes where this one was.
func move(p_sensor: String, p_mount: int) -> void:
	var map: SensorMap = _change()
	var from: int = map.mounts.get(p_sensor, -1)
	if p_mount >= 0 and map.sensor_at(p_mount) != "" and from >= 0:
		map.exchange(from, p_mount)
	else:
		map.assign(p_sensor, p_mount)
	_suit.set_map(map)


## Exchanges the sensors of two mounts.
func exchange(p_mounts: Vector2i) -> void:
	var map: SensorMap = _change()
	map.exchange(p_mounts.x, p_mounts.y)
	_suit.set_map(map)


## Puts every sensor where it seems to be: a mount for each of the sensors, -1 for those that stay
## without.
func assign(p_mounts: PackedInt32Array) -> void:
	var map: SensorMap = _change()
	var sensors: Array[SensorInfo] = _suit.feed.list_sensors()
	for sensor: int in mini(sensors.size(), p_mounts.size()):
		map.assign(sensors[sensor].id, -1)
	for sensor: int in mini(sensors.size(), p_mounts.size()):
		if p_mounts[sensor] >= 0:
			map.assign(sensors[sensor].id, p_mounts[sensor])
	_suit.set_map(map)


## Takes the last change back; whether there was one.
func undo() -> bool:
	if _before.is_empty():
		return false
	_suit.set_map(_before.pop_back())
	return true


## The changes are accepted.
func accept() -> void:
	_before.clear()


func _change() -> SensorMap:
	_before.append(_suit.get_profile().map)
	if _before.size() > DEPTH:
		_before.remove_at(1)
	return _suit.get_profile().map.duplicate()

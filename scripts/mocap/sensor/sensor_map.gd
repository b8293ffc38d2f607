class_name SensorMap
extends RefCounted
## Which sensor is worn where: sensors by their ids, mounts of [BodyMounts].

## For each number of sensors the mounts, in the order in which they are plugged in.
## Legs and arms come left before right, from the trunk outwards.
const LAYOUTS: Dictionary[int, Array] = {
	5: [0, 5, 9, 12, 15],
	6: [0, 2, 5, 9, 12, 15],
	7: [0, 1, 2, 5, 9, 12, 15],
	8: [0, 1, 4, 5, 8, 9, 12, 15],
	9: [0, 1, 2, 4, 5, 8, 9, 12, 15],
	10: [0, 1, 4, 5, 8, 9, 11, 12, 14, 15],
	11: [0, 1, 2, 4, 5, 8, 9, 11, 12, 14, 15],
	12: [0, 1, 4, 5, 8, 9, 11, 12, 13, 14, 15, 16],
	13: [0, 1, 2, 4, 5, 8, 9, 11, 12, 13, 14, 15, 16],
	14: [0, 1, 4, 5, 6, 8, 9, 10, 11, 12, 13, 14, 15, 16],
	15: [0, 1, 2, 4, 5, 6, 8, 9, 10, 11, 12, 13, 14, 15, 16],
	16: [0, 1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16],
	17: [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16],
}

## Mounts by the sensors' ids.
var mounts: Dictionary[String, int] = {}
## Whether nobody has set it: then it is guessed anew when more sensors are found.
var is_guessed: bool = false


## A map for sensors that nobody has set yet: mounts that they report themselves, the others by the
## layout for their number, in their order.
static func guess(p_sensors: Array[SensorInfo]) -> SensorMap:
	var map: SensorMap = SensorMap.new()
	var free: PackedInt32Array = layout(p_sensors.size())
	for sensor: SensorInfo in p_sensors:
		var mount: int = BodyMounts.find(sensor.mount)
		if mount >= 0:
			map.assign(sensor.id, mount)
			if free.has(mount):
				free.remove_at(free.find(mount))
	# In their order on the bus, whichever master was found first.
	var sorted: Array[SensorInfo] = p_sensors.duplicate()
	sorted.sort_custom(
		func(a: SensorInfo, b: SensorInfo) -> bool: return a.where.naturalnocasecmp_to(b.where) < 0
	)
	for sensor: SensorInfo in sorted:
		if not map.mounts.has(sensor.id) and not free.is_empty():
			map.assign(sensor.id, free[0])
			free.remove_at(0)
	map.is_guessed = true
	return map


## The mounts for so many sensors; for more than 17 all, for fewer than 5 the first of 5.
static func layout(p_count: int) -> PackedInt32Array:
	var found: PackedInt32Array = PackedInt32Array(LAYOUTS[clampi(p_count, 5, 17)])
	return found.slice(0, mini(p_count, found.size()))


## Puts a sensor on a mount, and takes away whichever was there. A mount of -1: it is not worn.
func assign(p_id: String, p_mount: int) -> void:
	var there: String = sensor_at(p_mount)
	is_guessed = false
	if there != "":
		mounts.erase(there)
	mounts.erase(p_id)
	if p_mount >= 0:
		mounts[p_id] = p_mount


## Exchanges what two mounts hold, which may be nothing.
func exchange(p_first: int, p_second: int) -> void:
	var first: String = sensor_at(p_first)
	var second: String = sensor_at(p_second)
	is_guessed = false
	mounts.erase(first)
	mounts.erase(second)
	if first != "":
		mounts[first] = p_second
	if second != "":
		mounts[second] = p_first


## The sensor on a mount, or an empty text.
func sensor_at(p_mount: int) -> String:
	var found: Variant = mounts.find_key(p_mount)
	return "" if found == null or p_mount < 0 else found


## The mount of each sensor of a list, -1 for those that are not worn.
func of_sensors(p_sensors: Array[SensorInfo]) -> PackedInt32Array:
	var found: PackedInt32Array = PackedInt32Array()
	for sensor: SensorInfo in p_sensors:
		found.append(mounts.get(sensor.id, -1))
	return found


## The mounts that have a sensor, in their order.
func worn() -> PackedInt32Array:
	var found: PackedInt32Array = PackedInt32Array(mounts.values())
	found.sort()
	return found


## A copy that can be changed.
func duplicate() -> SensorMap:
	var map: SensorMap = SensorMap.new()
	map.mounts = mounts.duplicate()
	map.is_guessed = is_guessed
	return map


## For files: names of mounts by ids.
func to_dictionary() -> Dictionary:
	var found: Dictionary = {}
	for id: String in mounts:
		found[id] = String(BodyMounts.NAMES[mounts[id]])
	return found

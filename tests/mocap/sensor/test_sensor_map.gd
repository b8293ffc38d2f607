extends TestCase
## Which sensor is worn where.


func test_layouts_are_plausible() -> void:
	for count: int in range(5, 18):
		var mounts: PackedInt32Array = SensorMap.layout(count)
		equal(mounts.size(), count)
		equal(mounts[0], BodyMounts.PELVIS)
		for mount: int in mounts:
			equal(mounts.count(mount), 1)
			contains(mounts, BodyMounts.MIRRORS[mount], "%d sensors: both sides" % count)
	equal(SensorMap.layout(3), PackedInt32Array([0, 5, 9]))
	equal(SensorMap.layout(40).size(), 17)
	equal(SensorMap.layout(0).size(), 0)


func test_mounts_and_their_names() -> void:
	for mount: int in BodyMounts.COUNT:
		equal(BodyMounts.find(BodyMounts.NAMES[mount]), mount)
		equal(BodyMounts.MIRRORS[BodyMounts.MIRRORS[mount]], mount)
		equal(BodyMounts.side(BodyMounts.MIRRORS[mount]), -BodyMounts.side(mount))
		is_true(BodyMounts.PARENTS[mount] < mount)
	equal(BodyMounts.find(&"wing"), -1)
	equal(BodyMounts.title(4), "left upper arm")


func test_guess_by_order_and_by_what_devices_tell() -> void:
	var map: SensorMap = SensorMap.guess(_sensors(["a", "b", "c", "d", "e"]))
	equal(map.worn(), PackedInt32Array([0, 5, 9, 12, 15]))
	equal(map.mounts["b"], 5)
	var sensors: Array[SensorInfo] = _sensors(["a", "b", "c", "d", "e", "f"])
	sensors[0].mount = &"head"
	sensors[1].mount = &"no such place"
	map = SensorMap.guess(sensors)
	equal(map.mounts["a"], BodyMounts.HEAD)
	equal(map.mounts["b"], BodyMounts.PELVIS)
	equal(map.worn(), PackedInt32Array([0, 2, 5, 9, 12, 15]))
	equal(SensorMap.guess([]).mounts.size(), 0)


func test_two_sensors_never_share_a_mount() -> void:
	var map: SensorMap = SensorMap.guess(_sensors(["a", "b", "c", "d", "e"]))
	map.assign("a", 5)
	equal(map.sensor_at(5), "a")
	is_false(map.mounts.has("b"))
	equal(map.sensor_at(0), "")
	map.assign("a", -1)
	is_false(map.mounts.has("a"))
	map.exchange(9, 0)
	equal(map.sensor_at(0), "c")
	equal(map.sensor_at(9), "")
	map.exchange(1, 2)
	equal(map.of_sensors(_sensors(["e", "x", "c"])), PackedInt32Array([15, -1, 0]))
	var copy: SensorMap = map.duplicate()
	copy.assign("e", 1)
	equal(map.mounts["e"], 15)


func test_more_than_17_sensors() -> void:
	var ids: PackedStringArray = []
	for at: int in 20:
		ids.append("s%d" % at)
	var map: SensorMap = SensorMap.guess(_sensors(ids))
	equal(map.mounts.size(), 17)


func _sensors(p_ids: PackedStringArray) -> Array[SensorInfo]:
	var found: Array[SensorInfo] = []
	for id: String in p_ids:
		var info: SensorInfo = SensorInfo.new()
		info.id = id
		found.append(info)
	return found

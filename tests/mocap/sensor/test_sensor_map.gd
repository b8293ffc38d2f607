extends TestCase
## Which sensor is worn where.


func test_layouts_are_plausible() -> void:
	for count: int in range(5, 18):
		var places: PackedInt32Array = SensorMap.layout(count)
		equal(places.size(), count)
		equal(places[0], BodyMounts.PELVIS)
		for place: int in places:
			equal(places.count(place), 1)
			contains(places, BodyMounts.MIRRORS[place], "%d sensors: both sides" % count)
	equal(SensorMap.layout(3), PackedInt32Array([0, 5, 9]))
	equal(SensorMap.layout(40).size(), 17)
	equal(SensorMap.layout(0).size(), 0)


func test_places_and_their_names() -> void:
	for place: int in BodyMounts.COUNT:
		equal(BodyMounts.find(BodyMounts.NAMES[place]), place)
		equal(BodyMounts.MIRRORS[BodyMounts.MIRRORS[place]], place)
		equal(BodyMounts.side(BodyMounts.MIRRORS[place]), -BodyMounts.side(place))
		is_true(BodyMounts.PARENTS[place] < place)
	equal(BodyMounts.find(&"wing"), -1)
	equal(BodyMounts.title(4), "left upper arm")


func test_guess_by_order_and_by_what_devices_tell() -> void:
	var map: SensorMap = SensorMap.guess(_sensors(["a", "b", "c", "d", "e"]))
	equal(map.worn(), PackedInt32Array([0, 5, 9, 12, 15]))
	equal(map.places["b"], 5)
	var sensors: Array[SensorInfo] = _sensors(["a", "b", "c", "d", "e", "f"])
	sensors[0].place = &"head"
	sensors[1].place = &"no such place"
	map = SensorMap.guess(sensors)
	equal(map.places["a"], BodyMounts.HEAD)
	equal(map.places["b"], BodyMounts.PELVIS)
	equal(map.worn(), PackedInt32Array([0, 2, 5, 9, 12, 15]))
	equal(SensorMap.guess([]).places.size(), 0)


func test_two_sensors_never_share_a_place() -> void:
	var map: SensorMap = SensorMap.guess(_sensors(["a", "b", "c", "d", "e"]))
	map.assign("a", 5)
	equal(map.sensor_at(5), "a")
	is_false(map.places.has("b"))
	equal(map.sensor_at(0), "")
	map.assign("a", -1)
	is_false(map.places.has("a"))
	map.exchange(9, 0)
	equal(map.sensor_at(0), "c")
	equal(map.sensor_at(9), "")
	map.exchange(1, 2)
	equal(map.of_sensors(_sensors(["e", "x", "c"])), PackedInt32Array([15, -1, 0]))
	var copy: SensorMap = map.duplicate()
	copy.assign("e", 1)
	equal(map.places["e"], 15)


func test_more_than_17_sensors() -> void:
	var ids: PackedStringArray = []
	for at: int in 20:
		ids.append("s%d" % at)
	var map: SensorMap = SensorMap.guess(_sensors(ids))
	equal(map.places.size(), 17)


func _sensors(p_ids: PackedStringArray) -> Array[SensorInfo]:
	var found: Array[SensorInfo] = []
	for id: String in p_ids:
		var info: SensorInfo = SensorInfo.new()
		info.id = id
		found.append(info)
	return found

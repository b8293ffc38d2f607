extends TestCase
## What is kept of people survives, and what others wrote is refused with a reason.

const Wearer: GDScript = preload("wearer.gd")

var _store: CalibrationStore = null
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 8
	_store = CalibrationStore.new("user://test-calibrations-%d" % OS.get_process_id())


func after_each() -> void:
	if DirAccess.dir_exists_absolute(_store.folder):
		for file: String in DirAccess.get_files_at(_store.folder):
			DirAccess.remove_absolute(_store.folder.path_join(file))
		DirAccess.remove_absolute(_store.folder)


func test_a_profile_comes_back_as_it_was() -> void:
	var profile: PersonProfile = _profile()
	is_true(_store.write(profile), _store.error)
	equal(_store.list(), PackedStringArray(["Anna Ö. Meyer"]))
	var again: PersonProfile = _store.read("Anna Ö. Meyer")
	equal(_store.error, "")
	equal(again.name, profile.name)
	equal(again.size.height, 1.62)
	equal(again.size.measured, profile.size.measured)
	equal(again.map.mounts, profile.map.mounts)
	equal(again.calibration.kind, CalibrationGuide.Kind.FULL)
	equal(again.calibration.made_s, profile.calibration.made_s)
	for id: String in profile.calibration.entries:
		var was: Calibration.Entry = profile.calibration.entries[id]
		var entry: Calibration.Entry = again.calibration.entries[id]
		equal(entry.mount, was.mount)
		almost_equal(entry.heading, was.heading, 1e-12)
		is_true(Rotations.between_deg(entry.mounting, was.mounting) < 1e-4)
	_store.remove("Anna Ö. Meyer")
	equal(_store.list().size(), 0)


func test_a_person_without_calibration() -> void:
	var profile: PersonProfile = PersonProfile.new()
	profile.name = "new"
	is_true(_store.write(profile))
	is_null(_store.read("new").calibration)


func test_nothing_is_left_half() -> void:
	is_true(_store.write(_profile()))
	is_true(_store.write(_profile()))
	equal(DirAccess.get_files_at(_store.folder).size(), 1)
	is_null(_store.read("nobody"))
	contains(_store.error, "nobody.json: cannot be read")


func test_names() -> void:
	for name: String in ["", "../x", "a/b", " a", "a.", ".a", "x\n", "a".repeat(61), "a:b", "%s"]:
		not_equal(PersonProfile.find_name_fault(name), "", name)
		is_null(_store.read(name))
		var profile: PersonProfile = PersonProfile.new()
		profile.name = name
		is_false(_store.write(profile))
		not_equal(_store.error, "")
	equal(PersonProfile.find_name_fault("José-María 2"), "")


func test_faults_name_file_and_field() -> void:
	var cases: Dictionary[String, Array] = {
		"{": ["line 1", "Expected"],
		"[]": ["it holds no object"],
		"{}": ["version: expected a number, found nothing"],
		'{"version": 9}': ["version: 9 is not known here, only 1"],
		'{"version": 1}': ["name: expected a text"],
	}
	for text: String in cases:
		_put(text)
		is_null(_store.read("bad"))
		contains(_store.error, "bad.json: ")
		for part: String in cases[text]:
			contains(_store.error, part)
	var good: PersonProfile = _profile()
	good.name = "bad"
	var text: String = ProfileReader.write(good)
	var id: String = good.map.mounts.keys()[0]
	for change: Array in [
		["1.62", "9.0", "size.height_m: a person is between"],
		["1.62", "-1e99", "size.height_m"],
		['"trunk"', '"tail"', "size.measured_m.tail: there is no measure 'tail'"],
		['"%s": "pelvis"' % id, '"%s": "wing"' % id, "sensors.%s: there is no mount 'wing'" % id],
		['"%s": "pelvis"' % id, '"%s": "head"' % id, "there are two on the head"],
		['"kind": "full"', '"kind": "half"', "calibration.kind: one of"],
		['"pose": "T"', '"pose": "Z"', "calibration.pose: T or N, found 'Z'"],
		['"heading_rad": ', '"heading_rad": "x", "y": ', ".heading_rad: expected a number"],
		['"mounting_xyzw": [', '"mounting_xyzw": [7, ', ".mounting_xyzw: expected 4 numbers"],
		['"name": "bad"', '"name": "good"', "name: it is that of 'good'"],
	]:
		_put(text.replace(change[0], change[1]))
		is_null(_store.read("bad"), change[2])
		contains(_store.error, change[2])
	_put(text)
	not_null(_store.read("bad"), _store.error)


func test_damaged_files_never_do_harm() -> void:
	var bytes: PackedByteArray = ProfileReader.write(_profile()).to_utf8_buffer()
	allow_error("Unicode")
	var read: int = 0
	for round: int in 400:
		var damaged: PackedByteArray = bytes.duplicate()
		for change: int in 1 + _random.randi() % 4:
			damaged[_random.randi() % damaged.size()] = 32 + _random.randi() % 95
		if _random.randf() < 0.2:
			damaged = damaged.slice(0, _random.randi() % damaged.size())
		var reader: ProfileReader = ProfileReader.new()
		var profile: PersonProfile = reader.read(damaged.get_string_from_utf8())
		equal(profile == null, reader.error != "")
		if profile != null:
			read += 1
			for id: String in profile.map.mounts:
				is_true(profile.map.mounts[id] >= 0 and profile.map.mounts[id] < 17)
	is_true(read < 400)


func test_huge_and_binary_files() -> void:
	_put("x".repeat(CalibrationStore.MAX_BYTES + 1))
	is_null(_store.read("bad"))
	contains(_store.error, "too many")
	var file: FileAccess = FileAccess.open(_store.path_of("bad"), FileAccess.WRITE)
	file.store_buffer(PackedByteArray([0, 1, 2, 255]))
	file.close()
	is_null(_store.read("bad"))
	contains(_store.error, "no text")


func _put(p_text: String) -> void:
	DirAccess.make_dir_recursive_absolute(_store.folder)
	var file: FileAccess = FileAccess.open(_store.path_of("bad"), FileAccess.WRITE)
	file.store_string(p_text)
	file.close()


func _profile() -> PersonProfile:
	var wearer: Wearer = Wearer.new()
	wearer.random = _random
	wearer.wear(PackedInt32Array(range(17)))
	var profile: PersonProfile = PersonProfile.new()
	profile.name = "Anna Ö. Meyer"
	profile.size.set_height(1.62)
	profile.size.measure(&"trunk", 0.5)
	profile.map = SensorMap.guess(wearer.feed.list_sensors())
	profile.calibration = wearer.calibrate(CalibrationGuide.Kind.FULL).calibration
	return profile

extends TestCase
## What a ragdoll is made of: the file of the soldier, and errors that name file and entry.

const SCENE: PackedScene = preload("res://scenes/actor/soldier.tscn")
const SOLDIER: String = "res://assets/avatar/shapes/soldier.json"
const SAVED_TEXT: String = "user://test_profile.tres"
const SAVED_BINARY: String = "user://test_profile.res"
const SCRATCH: String = "user://test_limb_shapes.json"

var _reader: RagdollProfileReader = RagdollProfileReader.new()


func after_each() -> void:
	if FileAccess.file_exists(SCRATCH):
		DirAccess.remove_absolute(SCRATCH)


func test_file_of_the_soldier() -> void:
	var profile: RagdollProfile = _reader.read(SOLDIER)
	equal(_reader.error, "")
	equal(profile.find_fault(), "")
	equal(profile.limbs.size(), Limbs.COUNT)
	for limb: int in Limbs.COUNT:
		var shape: RagdollLimb = profile.find(Limbs.BONES[limb])
		not_null(shape, Limbs.BONES[limb])
		var parent: int = Limbs.PARENTS[limb]
		equal(shape.parent_bone, &"" if parent < 0 else Limbs.BONES[parent])
		almost_equal(shape.mass_fraction, Limbs.MASS_FRACTIONS[limb], 0.001)
	is_null(profile.find(&"Tail"))
	var hips: RagdollLimb = profile.find(&"Hips")
	equal(hips.type, RagdollLimb.BOX)
	almost_equal(hips.position, Vector3(0.0, 1.01723, 0.02227))
	var arm: RagdollLimb = profile.find(&"LeftUpperArm")
	equal(arm.type, RagdollLimb.PILL)
	almost_equal([arm.radius, arm.length], [0.0746, 0.25741])


func test_the_scene_is_made_from_the_file() -> void:
	var from_file: RagdollProfile = _reader.read(SOLDIER)
	var soldier: Ragdoll = SCENE.instantiate()
	for shape: RagdollLimb in from_file.limbs:
		var other: RagdollLimb = soldier.profile.find(shape.bone)
		if other.is_foot:
			# Toes bend: the body of a foot ends behind them.
			is_true(other.size.z < shape.size.z - 0.01 and other.position.z < shape.position.z)
			continue
		for field: String in ["position", "orientation", "anchor", "mass_fraction", "parent_bone"]:
			almost_equal(other.get(field), shape.get(field), 1e-5, shape.bone)
	soldier.free()


func test_both_sides_are_alike() -> void:
	var profile: RagdollProfile = _reader.read(SOLDIER)
	for shape: RagdollLimb in profile.limbs:
		if String(shape.bone).begins_with("Left"):
			var bone: String = String(shape.bone).replace("Left", "Right")
			var other: RagdollLimb = profile.find(StringName(bone))
			almost_equal(other.position, shape.position * Vector3(-1, 1, 1), 0.01, bone)
			almost_equal(other.anchor, shape.anchor * Vector3(-1, 1, 1), 0.01, bone)


func test_files_that_are_none() -> void:
	is_null(_reader.read("res://assets/avatar/no_such.json"))
	contains(_reader.error, "no_such.json: cannot be read: ")
	var cases: Dictionary[String, String] = {
		"": SCRATCH,
		'{\n"geoms": [\n': SCRATCH + ":",
		"[]": "expected an object with a list 'geoms'",
		'{"geoms": {}}': "expected an object with a list 'geoms'",
		'{"geoms": []}': "there are no limbs",
		'{"geoms": [5]}': "geom 1: expected an object",
		'{"geoms": [{}]}': "geom 1: expected a text as 'bone'",
	}
	for text: String in cases:
		_read_text(text)
		contains(_reader.error, cases[text])
		is_true(_reader.error.begins_with(SCRATCH), _reader.error)


func test_bytes_that_are_no_text() -> void:
	var file: FileAccess = FileAccess.open(SCRATCH, FileAccess.WRITE)
	file.store_buffer(PackedByteArray([0x7B, 0x80, 0xFF, 0x00, 0x22]))
	file.close()
	is_null(_reader.read(SCRATCH))
	is_true(_reader.error.begins_with(SCRATCH), _reader.error)


func test_entries_that_are_none_are_named() -> void:
	var cases: Array[Array] = [
		["bone", null, "geom 2: expected a text as 'bone'"],
		["bone", 5, "geom 2: expected a text as 'bone'"],
		["bone", "", "names no bone"],
		["parent_bone", 5, "geom 2: expected a text or null as 'parent_bone'"],
		["type", "ball", "geom 2: expected type 'pill' or 'box', found 'ball'"],
		["position", [1, 2], "geom 2: expected 3 numbers as 'position'"],
		["position", "here", "geom 2: expected 3 numbers as 'position'"],
		["position", [1, 2, null], "geom 2: expected 3 numbers as 'position'"],
		["orientation", [0, 0, 1], "geom 2: expected 4 numbers as 'orientation'"],
		["orientation", [0, 0, 0, 0], "Spine's orientation is not a rotation"],
		["anchor", null, "geom 2: expected 3 numbers as 'anchor'"],
		["size", [1, 2, 3, 4], "geom 2: expected 3 numbers as 'size'"],
		["size", [1, -2, 3], "Spine's sizes must be above 0"],
		["mass_fraction", "much", "geom 2: expected a number as 'mass_fraction'"],
		["mass_fraction", 0.5, "add up to"],
		["parent_bone", "Tail", "Spine comes before its parent Tail"],
		["parent_bone", null, "Spine: the first limb, and only the first"],
		["bone", "Hips", "Hips is there twice"],
	]
	for case: Array in cases:
		var data: Dictionary = JSON.parse_string(FileAccess.get_file_as_string(SOLDIER))
		data["geoms"][1][case[0]] = case[1]
		_read_text(JSON.stringify(data))
		contains(_reader.error, case[2], str(case))
		is_true(_reader.error.begins_with(SCRATCH + ": "), _reader.error)


func test_a_missing_key_is_named() -> void:
	for key: String in ["bone", "type", "position", "orientation", "anchor", "radius", "length"]:
		var data: Dictionary = JSON.parse_string(FileAccess.get_file_as_string(SOLDIER))
		data["geoms"][4].erase(key)
		_read_text(JSON.stringify(data))
		contains(_reader.error, "geom 5: expected")
		contains(_reader.error, "'%s'" % key if key != "type" else "type")


func test_a_good_file_after_a_bad_one() -> void:
	_read_text("")
	not_null(_reader.read(SOLDIER))
	equal(_reader.error, "")


func test_saves_and_loads() -> void:
	var made: RagdollProfile = _soldier_profile()
	for path: String in [SAVED_TEXT, SAVED_BINARY]:
		equal(ResourceSaver.save(made, path), OK)
		var loaded: RagdollProfile = ResourceLoader.load(
			path, "", ResourceLoader.CACHE_MODE_IGNORE_DEEP
		)
		DirAccess.remove_absolute(path)
		equal(loaded.find_fault(), "")
		equal(loaded.limbs.size(), Limbs.COUNT)
		almost_equal(loaded.mass, made.mass)
		for i: int in Limbs.COUNT:
			for property: Dictionary in made.limbs[i].get_property_list():
				if (
					property["usage"] & PROPERTY_USAGE_STORAGE
					and property["name"] != "resource_path"
				):
					var name: String = property["name"]
					equal(loaded.limbs[i].get(name), made.limbs[i].get(name), name)


func test_the_scene_is_complete() -> void:
	var made: RagdollProfile = _soldier_profile()
	equal(made.find_fault(), "")
	equal(RagdollBuilder.overlaps(made), [] as Array[Array])
	var groups: Array = ["head", "left_arm", "left_leg", "right_arm", "right_leg", "trunk"]
	var found: Array = Array(made.get_groups())
	found.sort()
	equal(found, groups)
	for i: int in Limbs.COUNT:
		var limb: RagdollLimb = made.limbs[i]
		var number: int = Limbs.find(limb.bone)
		equal(made.get_parent_index(i), made.limbs.find(made.find(limb.parent_bone)))
		almost_equal(limb.max_torque, Limbs.TORQUES[number])
		equal(limb.is_foot, limb.bone in [&"LeftFoot", &"RightFoot"])
		equal(limb.contact_points.size() == 5, limb.is_foot, limb.bone)
		is_true(limb.contact_points.size() > 0)


func test_hostile_values_are_faults() -> void:
	var made: RagdollProfile = RagdollProfile.new()
	equal(made.find_fault(), "there are no limbs")
	made.limbs = [null] as Array[RagdollLimb]
	contains(made.find_fault(), "limb 0 is empty: make a RagdollLimb there")
	is_null(made.find(&"Hips"))
	equal(made.get_parent_index(0), -1)
	equal(made.get_groups(), PackedStringArray())
	equal(RagdollBuilder.overlaps(made), [] as Array[Array])
	expect_error("there is no limb of this number")
	equal(made.get_parent_index(5), -1)
	expect_error("there is no limb of this number")
	equal(made.get_parent_index(-1), -1)
	var many: Array[RagdollLimb] = []
	many.resize(10000)
	made.limbs = many
	contains(made.find_fault(), "there are 10000 limbs, at most 64")
	for mass: float in [NAN, INF, -80.0, 0.0]:
		var soldier: RagdollProfile = _soldier_profile().duplicate()
		soldier.mass = mass
		contains(soldier.find_fault(), "the mass is")


func test_a_limb_may_hang_on_itself_or_on_nothing_without_a_crash() -> void:
	var made: RagdollProfile = _soldier_profile().duplicate(true)
	made.limbs[3].parent_bone = made.limbs[3].bone
	contains(made.find_fault(), "comes before its parent")
	made.limbs[3].parent_bone = &"Tail"
	contains(made.find_fault(), "Head comes before its parent Tail")
	equal(made.get_parent_index(3), -1)


func _soldier_profile() -> RagdollProfile:
	var soldier: Ragdoll = SCENE.instantiate()
	var made: RagdollProfile = soldier.profile
	soldier.free()
	return made


func _read_text(p_text: String) -> void:
	var file: FileAccess = FileAccess.open(SCRATCH, FileAccess.WRITE)
	file.store_string(p_text)
	file.close()
	is_null(_reader.read(SCRATCH), p_text.left(60))

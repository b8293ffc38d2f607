extends TestCase
## Finds the limbs in the skeletons of common programs, and says what is missing in others.

const People: GDScript = preload("res://tests/mocap/people_samples.gd")

## Names of each scheme in the order of [constant Schemes.KEYS].
const SCHEMES: Dictionary[String, Array] = {
	"humanoid":
	[
		"Hips,Spine,Chest,Neck,Head",
		"LeftShoulder,LeftUpperArm,LeftLowerArm,LeftHand",
		"LeftUpperLeg,LeftLowerLeg,LeftFoot,LeftToes"
	],
	"Mixamo":
	[
		"mixamorig:Hips,mixamorig:Spine,mixamorig:Spine1,mixamorig:Neck,mixamorig:Head",
		"mixamorig:LeftShoulder,mixamorig:LeftArm,mixamorig:LeftForeArm,mixamorig:LeftHand",
		"mixamorig:LeftUpLeg,mixamorig:LeftLeg,mixamorig:LeftFoot,mixamorig:LeftToeBase"
	],
	"3ds Max":
	[
		"Bip01,Bip01 Spine,Bip01 Spine1,Bip01 Neck,Bip01 Head",
		"Bip01 L Clavicle,Bip01 L UpperArm,Bip01 L Forearm,Bip01 L Hand",
		"Bip01 L Thigh,Bip01 L Calf,Bip01 L Foot,Bip01 L Toe0"
	],
	"DAZ":
	["hip,abdomen,chest,neck,head", "lCollar,lShldr,lForeArm,lHand", "lThigh,lShin,lFoot,lToe"],
	"Blender":
	[
		"hips,spine,chest,neck,head",
		"shoulder.L,upper_arm.L,forearm.L,hand.L",
		"thigh.L,shin.L,foot.L,toe.L"
	],
	"Unreal":
	[
		"pelvis,spine_01,spine_02,neck_01,head",
		"clavicle_l,upperarm_l,lowerarm_l,hand_l",
		"thigh_l,calf_l,foot_l,ball_l"
	],
	"Xsens":
	[
		"Hips,Chest,Chest2,Neck,Head",
		"LeftCollar,LeftShoulder,LeftElbow,LeftWrist",
		"LeftHip,LeftKnee,LeftAnkle,LeftToe"
	],
	"Rokoko":
	[
		"Hips,Spine,Spine1,Neck,Head",
		"LeftShoulder,LeftArm,LeftForeArm,LeftHand",
		"LeftThigh,LeftShin,LeftFoot,LeftToe"
	],
	"VRoid":
	[
		"J_Bip_C_Hips,J_Bip_C_Spine,J_Bip_C_Chest,J_Bip_C_Neck,J_Bip_C_Head",
		"J_Bip_L_Shoulder,J_Bip_L_UpperArm,J_Bip_L_LowerArm,J_Bip_L_Hand",
		"J_Bip_L_UpperLeg,J_Bip_L_LowerLeg,J_Bip_L_Foot,J_Bip_L_ToeBase"
	],
	"capitals":
	[
		"HIPS,SPINE,CHEST,NECK,HEAD",
		"LEFT_COLLAR,LEFT_UPPER_ARM,LEFT_FOREARM,LEFT_HAND",
		"LEFT_THIGH,LEFT_CALF,LEFT_FOOT,LEFT_TOE"
	],
}
const Schemes: GDScript = preload("foreign_schemes.gd")
const SIDES: Dictionary[String, String] = {
	"Left": "Right", "LEFT": "RIGHT", " L ": " R ", ".L": ".R", "_l": "_r", "_L_": "_R_"
}


func test_naming_schemes() -> void:
	for scheme: String in SCHEMES:
		var person: People.Person = People.Person.new()
		person.names = _names(",".join(SCHEMES[scheme]))
		var clip: BvhClip = People.make(person)
		var map: HumanoidMap = HumanoidMap.from_clip(clip)
		equal(map.error, "", scheme)
		if map.error != "":
			continue
		for limb: int in Limbs.COUNT:
			var wanted: String = person.names[String(Limbs.BONES[limb])]
			equal(clip.joints[map.joints[limb]].name, wanted, scheme)
		_check_structure(clip, map, scheme)


func test_places_where_limbs_begin_and_end() -> void:
	var clip: BvhClip = People.make(People.Person.new())
	var map: HumanoidMap = HumanoidMap.from_clip(clip)
	var rest: PackedVector3Array = clip.rest_positions()
	var tails: Dictionary[StringName, String] = {
		&"Hips": "Spine",
		&"Spine": "Chest",
		&"Chest": "Neck",
		&"LeftUpperArm": "LeftLowerArm",
		&"LeftLowerArm": "LeftHand",
		&"RightUpperLeg": "RightLowerLeg",
		&"RightLowerLeg": "RightFoot",
	}
	for bone: StringName in tails:
		equal(clip.joints[map.tails[Limbs.find(bone)]].name, tails[bone], bone)
	var scale: float = clip.unit_metres
	almost_equal(rest[map.tails[Limbs.find(&"LeftHand")]], Vector3(90, 145, 0) * scale, 1e-4)
	almost_equal(rest[map.tails[Limbs.find(&"RightHand")]], Vector3(-90, 145, 0) * scale, 1e-4)
	almost_equal(rest[map.tails[Limbs.find(&"Head")]], Vector3(0, 180, 0) * scale, 1e-4)


func test_missing_hands_feet_and_head() -> void:
	var person: People.Person = People.Person.new()
	for key: String in ["LeftHand", "RightHand", "LeftFoot", "RightFoot", "LeftToes", "RightToes"]:
		person.names[key] = ""
	person.names["Head"] = ""
	var clip: BvhClip = People.make(person)
	var map: HumanoidMap = HumanoidMap.from_clip(clip)
	equal(map.error, "")
	equal(clip.joints[map.joints[Limbs.find(&"LeftHand")]].name, "LeftLowerArm")
	equal(clip.joints[map.joints[Limbs.find(&"RightFoot")]].name, "RightLowerLeg")
	equal(clip.joints[map.joints[Limbs.find(&"Head")]].name, "Neck")
	_check_structure(clip, map, "no hands")


func test_short_trunk() -> void:
	var person: People.Person = People.Person.new()
	person.names = {"Spine": "", "Neck": "", "LeftShoulder": "", "RightShoulder": ""}
	var clip: BvhClip = People.make(person)
	var map: HumanoidMap = HumanoidMap.from_clip(clip)
	equal(map.error, "")
	equal(clip.joints[map.joints[Limbs.find(&"Chest")]].name, "Chest")
	equal(clip.joints[map.joints[Limbs.find(&"Head")]].name, "Head")
	_check_structure(clip, map, "short trunk")


func test_files() -> void:
	_check_file("res://assets/motion/01_01.bvh", "Hips,Head,LeftArm,LeftForeArm,LeftHand,LeftUpLeg")
	_check_file(
		"res://assets/motion/Boxing_Toes.bvh",
		"Hips,Head,LeftShoulder,LeftElbow,LeftWrist,LeftHip",
	)
	_check_file(
		"res://tests/data/bvh/thesis_example.bvh",
		"Hips,Head,LeftUpArm,LeftLowArm,LeftHand,LeftUpLeg",
	)


func test_what_is_no_person_lists_the_names() -> void:
	var person: People.Person = People.Person.new()
	for i: int in Schemes.KEYS.size():
		person.names[Schemes.KEYS[i]] = "Part%d" % i
		person.names[Schemes.KEYS[i].replace("Left", "Right")] = "Part%d" % i
	# Two arms and one leg: the structure is no person's either.
	for part: String in ["LeftUpperLeg", "LeftLowerLeg", "LeftFoot"]:
		person.names[part] = ""
	var map: HumanoidMap = HumanoidMap.from_clip(People.make(person))
	contains(map.error, "person.bvh: no joint is recognised as LeftUpperArm, LeftLowerArm")
	contains(map.error, "Part0, Part1, Part2")
	is_true(map.error.length() < 700)


func test_one_missing_limb_is_named() -> void:
	var person: People.Person = People.Person.new()
	person.names["RightLowerLeg"] = ""
	var map: HumanoidMap = HumanoidMap.from_clip(People.make(person))
	contains(map.error, "no joint is recognised as RightLowerLeg among")
	is_false(map.error.get_slice(" among", 0).contains("Left"))


func test_any_skeleton_is_survived() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 1
	var names: PackedStringArray = ["LeftArm", "RightLeg", "Head", "Neck", "LeftHand", "", "x"]
	var persons: int = 0
	for _round: int in 1000:
		var joints: Array[BvhJoint] = People.make(People.Person.new()).joints
		var sound: float = random.randf()
		for i: int in range(1, joints.size()):
			if random.randf() > sound:
				joints[i].parent = random.randi_range(0, i - 1)
			if random.randf() > sound:
				joints[i].name = names[random.randi_range(0, names.size() - 1)]
		var inner: Dictionary[int, bool] = {}
		for joint: BvhJoint in joints:
			inner[joint.parent] = true
		for i: int in joints.size():
			joints[i].is_end_site = not inner.has(i) and random.randf() < 0.5
		var clip: BvhClip = BvhClip.new()
		clip.set_data(joints, PackedFloat64Array(), 0.1)
		var map: HumanoidMap = HumanoidMap.from_clip(clip)
		if map.error == "":
			persons += 1
			_check_structure(clip, map, "random")
	is_true(persons > 20 and persons < 980, "%d persons" % persons)


func test_thousands_of_joints_of_one_name() -> void:
	# Tried in all pairs, these would take minutes.
	var joints: Array[BvhJoint] = []
	for number: int in 2000:
		var joint: BvhJoint = BvhJoint.new()
		joint.name = ["LeftArm", "LeftForeArm", "LeftHand", "RightLeg"][number % 4]
		joint.parent = number - 1 if number % 250 else mini(number, 1) - 1
		joint.offset = Vector3.UP
		joints.append(joint)
	var clip: BvhClip = BvhClip.new()
	clip.set_data(joints, PackedFloat64Array(), 0.1)
	contains(HumanoidMap.from_clip(clip).error, "no joint is recognised as")


func _check_file(p_path: String, p_names: String) -> void:
	var clip: BvhClip = BvhParser.parse_file(p_path).clip
	var map: HumanoidMap = HumanoidMap.from_clip(clip)
	equal(map.error, "", p_path)
	var wanted: PackedStringArray = p_names.split(",")
	var bones: Array[StringName] = [
		&"Hips", &"Head", &"LeftUpperArm", &"LeftLowerArm", &"LeftHand", &"LeftUpperLeg"
	]
	for i: int in bones.size():
		var left: String = clip.joints[map.joints[Limbs.find(bones[i])]].name
		equal(left, wanted[i], p_path)
		var other: StringName = StringName(String(bones[i]).replace("Left", "Right"))
		var right: String = clip.joints[map.joints[Limbs.find(other)]].name
		equal(right, wanted[i].replace("Left", "Right"), p_path)
	_check_structure(clip, map, p_path)


func _check_structure(p_clip: BvhClip, p_map: HumanoidMap, p_note: String) -> void:
	for table: PackedInt32Array in [p_map.joints, p_map.bases, p_map.tails]:
		equal(table.size(), Limbs.COUNT, p_note)
	for limb: int in Limbs.COUNT:
		var last: int = p_clip.joints.size() - 1
		is_true(p_map.joints[limb] >= 0 and p_map.joints[limb] <= last, p_note)
		is_false(p_clip.joints[p_map.joints[limb]].is_end_site, p_note)
		is_true(p_map.tails[limb] >= -1 and p_map.tails[limb] <= last, p_note)
		is_true(p_map.bases[limb] >= 0 and p_map.bases[limb] <= last, p_note)


func _names(p_scheme: String) -> Dictionary[String, String]:
	var names: Dictionary[String, String] = {}
	var list: PackedStringArray = p_scheme.split(",")
	for i: int in Schemes.KEYS.size():
		names[Schemes.KEYS[i]] = list[i]
		if Schemes.KEYS[i].begins_with("Left"):
			names[Schemes.KEYS[i].replace("Left", "Right")] = _mirror(list[i])
	return names


func _mirror(p_name: String) -> String:
	for left: String in SIDES:
		if p_name.contains(left):
			return p_name.replace(left, SIDES[left])
	return "r" + p_name.substr(1)

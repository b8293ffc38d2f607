extends TestCase
## Sides and parts of joints, in the naming schemes of common programs.

const LEFT: JointNames.BodySide = JointNames.BodySide.LEFT
const RIGHT: JointNames.BodySide = JointNames.BodySide.RIGHT
const MIDDLE: JointNames.BodySide = JointNames.BodySide.MIDDLE


func test_sides() -> void:
	var sides: Dictionary[String, JointNames.BodySide] = {
		"LeftUpLeg": LEFT,
		"mixamorig:RightArm": RIGHT,
		"Bip01 L Thigh": LEFT,
		"Bip01_R_Calf": RIGHT,
		"lThigh": LEFT,
		"rShldr": RIGHT,
		"LThigh": LEFT,
		"thigh_l": LEFT,
		"upper_arm.R": RIGHT,
		"LEFT_LEG": LEFT,
		"leg-right": RIGHT,
		"J_Bip_L_UpperArm": LEFT,
		"Hips": MIDDLE,
		"Head": MIDDLE,
		"LowerBack": MIDDLE,
		"Root": MIDDLE,
		"lshoulder": LEFT,
		"rhip": RIGHT,
		"relbow": RIGHT,
		"lfoot": LEFT,
		"leftupleg": LEFT,
		"handl": LEFT,
		"upperarmright": RIGHT,
		"LUArm": LEFT,
		"rhumerus": RIGHT,
		"ShoulderLeft": LEFT,
		"Lf_Hip_JNT": LEFT,
		"b_r_arm": RIGHT,
		"mKneeLeft": LEFT,
		"L_UpperLeg": LEFT,
		"左ひざ": LEFT,
		"右腕": RIGHT,
		"radius": MIDDLE,
		"shoulder": MIDDLE,
		"lowerleg": MIDDLE,
		"rib": MIDDLE,
		"leg": MIDDLE,
		"": MIDDLE,
	}
	for name: String in sides:
		equal(_one(name).side(0), sides[name], name)


func test_cores() -> void:
	var cores: Dictionary[String, String] = {
		"LeftUpLeg": "upleg",
		"mixamorig:LeftUpLeg": "upleg",
		"a:b:LeftUpLeg": "upleg",
		"Bip01 L Thigh": "thigh",
		"lShldr": "shldr",
		"upper_arm.L": "upperarm",
		"LEFT_LEG": "leg",
		"J_Bip_L_UpperArm": "upperarm",
		"J_Bip_C_Head": "head",
		"lshoulder": "shoulder",
		"rhip": "hip",
		"LFArm": "farm",
		"LeftFoot_jnt": "foot",
		"Armature|Hips": "hips",
		"右手首": "手首",
		"Neck1": "neck1",
		"": "",
		"...": "",
	}
	for name: String in cores:
		equal(_one(name).core(0), cores[name], name)


func test_ranks() -> void:
	equal(_one("LeftUpLeg").rank(0, &"UpperLeg"), 0)
	is_true(_one("LeftHip").rank(0, &"UpperLeg") > 0)
	equal(_one("LeftHip").rank(0, &"LowerLeg"), -1)
	var arm: int = _one("LeftArm").rank(0, &"UpperArm")
	is_true(arm < _one("LeftShoulder").rank(0, &"UpperArm"))


func test_the_first_of_several_segments_stands_for_the_limb() -> void:
	for first: String in ["upperleg01.L", "upperleg1.L", "upperleg_00_l", "upperleg.L"]:
		equal(_one(first).rank(0, &"UpperLeg"), 1, first)
	for later: String in ["upperleg02.L", "upperleg_3_l", "upperleg.L.002"]:
		equal(_one(later).rank(0, &"UpperLeg"), -1, later)
	is_true(_one("leg02.L").rank(0, &"LowerLeg") >= 0)


func test_words_of_most_joints_say_nothing() -> void:
	var cores: PackedStringArray = ["hips", "upleg", "leg", "foot", "spine1", "head", "arm", "hand"]
	var names: PackedStringArray = [
		"Hips", "LeftUpLeg", "LeftLeg", "LeftFoot", "Spine1", "Head", "LeftArm", "LeftHand"
	]
	for scheme: String in ["Character1_%s", "Robot:Suit_%s", "%s_%03d", "%03d_%s", "My Rig %s jnt"]:
		var written: PackedStringArray = []
		for i: int in names.size():
			var parts: Array = [names[i]]
			if scheme.contains("%03d"):
				parts.insert(0 if scheme.begins_with("%03d") else 1, i + 7)
			written.append(scheme % parts)
		var known: JointNames = JointNames.new(written)
		for i: int in names.size():
			equal(known.core(i), cores[i], written[i])
			equal(known.side(i), LEFT if names[i].begins_with("Left") else MIDDLE, written[i])


func test_helpers_with_names_of_their_own_hide_no_shared_word() -> void:
	var names: PackedStringArray = []
	for part: String in ["Hips", "Spine", "LeftUpLeg", "LeftLeg", "LeftFoot", "LeftArm"]:
		names.append("Character1_" + part)
	for part: String in ["L_Femur", "L_Tibia", "L_Talus", "Pelvis"]:
		names.append(part + "_RIGMESH")
	var known: JointNames = JointNames.new(names)
	equal(known.core(2), "upleg")
	equal(known.rank(3, &"LowerLeg") >= 0, true)
	equal(known.side(4), LEFT)


func test_shared_sides_and_parts_are_kept() -> void:
	var names: PackedStringArray = []
	for i: int in 12:
		names.append("Left_Hand_%d" % i)
	var known: JointNames = JointNames.new(names)
	for i: int in names.size():
		equal(known.side(i), LEFT)
		contains(known.core(i), "hand")


func test_no_name_is_two_parts_of_one_chain_at_equal_rank() -> void:
	for chain: Array in [["UpperLeg", "LowerLeg", "Foot"], ["UpperArm", "LowerArm", "Hand"]]:
		for first: String in chain:
			for second: String in chain:
				if first != second:
					for core: String in JointNames.PARTS[StringName(first)]:
						var rank: int = JointNames.PARTS[StringName(first)].find(core)
						is_true(JointNames.PARTS[StringName(second)].find(core) != rank, core)


func test_any_text_is_survived() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 1
	for _round: int in 2000:
		var name: String = ""
		for _letter: int in random.randi_range(0, 12):
			name += ":_. LlRrÄß東😀0"[random.randi_range(0, 12)]
		var known: JointNames = _one(name)
		equal(known.core(0), known.core(0).to_lower(), name)
		is_true(known.side(0) in [LEFT, RIGHT, MIDDLE])


func _one(p_name: String) -> JointNames:
	return JointNames.new(PackedStringArray([p_name]))

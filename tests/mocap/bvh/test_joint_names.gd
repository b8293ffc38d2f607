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
		"rib": MIDDLE,
		"leg": MIDDLE,
		"": MIDDLE,
	}
	for name: String in sides:
		equal(JointNames.side(name), sides[name], name)


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
		"Neck1": "neck1",
		"": "",
		"...": "",
	}
	for name: String in cores:
		equal(JointNames.core(name), cores[name], name)


func test_ranks() -> void:
	equal(JointNames.rank("LeftUpLeg", &"UpperLeg"), 0)
	is_true(JointNames.rank("LeftHip", &"UpperLeg") > 0)
	equal(JointNames.rank("LeftHip", &"LowerLeg"), -1)
	is_true(JointNames.rank("LeftArm", &"UpperArm") < JointNames.rank("LeftShoulder", &"UpperArm"))


func test_no_name_is_two_parts_of_one_chain_at_equal_rank() -> void:
	for chain: Array in [["UpperLeg", "LowerLeg", "Foot"], ["UpperArm", "LowerArm", "Hand"]]:
		for first: String in chain:
			for second: String in chain:
				if first != second:
					for core: String in JointNames.PARTS[StringName(first)]:
						is_false(JointNames.PARTS[StringName(second)].has(core), core)


func test_any_text_is_survived() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 1
	for _round: int in 2000:
		var name: String = ""
		for _letter: int in random.randi_range(0, 12):
			name += ":_. LlRrÄß東😀0"[random.randi_range(0, 12)]
		var core: String = JointNames.core(name)
		equal(core, core.to_lower(), name)
		is_true(JointNames.side(name) in [LEFT, RIGHT, MIDDLE])

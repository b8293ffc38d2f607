extends TestCase
## Arms and legs of people whose joints have names that say nothing.

const Files: GDScript = preload("foreign_files.gd")

const CLIPS: PackedStringArray = ["01_01", "01_03", "Boxing_Toes"]


func test_limbs_without_names_are_those_with_names() -> void:
	for clip_name: String in CLIPS:
		var named: BvhClip = _clip(clip_name)
		var wanted: HumanoidMap = HumanoidMap.from_clip(named)
		for kind: String in ["numbers", "one name", "letters"]:
			var clip: BvhClip = _clip(clip_name)
			_rename(clip, kind)
			var map: HumanoidMap = HumanoidMap.from_clip(clip)
			var note: String = "%s, %s" % [clip_name, kind]
			equal(map.error, "", note)
			for limb: int in Limbs.ARMS + Limbs.LEGS:
				equal(map.joints[limb], wanted.joints[limb], note + ", " + Limbs.BONES[limb])
			equal(map.bases[Limbs.LEFT_FOOT], wanted.bases[Limbs.LEFT_FOOT], note)
			equal(map.joints[Limbs.HIPS], wanted.joints[Limbs.HIPS], note)


func test_six_legs_are_no_person() -> void:
	var clip: BvhClip = _clip("01_03")
	var map: HumanoidMap = HumanoidMap.from_clip(clip)
	var joints: Array[BvhJoint] = clip.joints.duplicate()
	for pair: int in 2:
		for upper: int in [Limbs.LEFT_UPPER_LEG, Limbs.RIGHT_UPPER_LEG]:
			var parent: int = 0
			for part: int in 3:
				var joint: BvhJoint = BvhJoint.new()
				joint.offset = clip.joints[map.joints[upper + part]].offset
				joint.parent = parent
				parent = joints.size()
				joints.append(joint)
	clip.set_data(joints, clip.values, clip.frame_time)
	_rename(clip, "numbers")
	contains(HumanoidMap.from_clip(clip).error, "no joint is recognised as")


func _clip(p_name: String) -> BvhClip:
	return BvhParser.parse_file("res://assets/motion/%s.bvh" % p_name).clip


func _rename(p_clip: BvhClip, p_kind: String) -> void:
	for joint: int in p_clip.joints.size():
		match p_kind:
			"numbers":
				p_clip.joints[joint].name = str(joint)
			"one name":
				p_clip.joints[joint].name = "кость"
			_:
				p_clip.joints[joint].name = String.chr(0x3042 + joint)

extends TestCase
## Clips of any rest pose and heading become the same motion of a person.

const People: GDScript = preload("res://tests/mocap/people_samples.gd")
## Rest poses: how far the arms hang.
const ARMS_DEG: PackedFloat32Array = [0.0, 45.0, 70.0, 89.9]
const HEADINGS_DEG: PackedFloat32Array = [0.0, 90.0, 180.0, -90.0, -30.0]

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 1


func test_t_pose_is_identity_whatever_the_rest_pose_and_heading() -> void:
	for arms: float in ARMS_DEG:
		for heading: float in HEADINGS_DEG:
			var rig: BvhRig = _rig(arms, heading, [People.t_pose(arms)])
			for limb: int in Limbs.COUNT:
				_check_turn(rig, limb, Quaternion.IDENTITY, "%s/%s deg" % [arms, heading])


func test_rest_pose_with_hanging_arms_is_shown_hanging() -> void:
	var rig: BvhRig = _rig(60.0, 180.0, [{}])
	var hang: Quaternion = Quaternion(Vector3.BACK, deg_to_rad(-60.0))
	for limb: int in Limbs.COUNT:
		var wanted: Quaternion = Quaternion.IDENTITY
		if Limbs.BONES[limb] in [&"LeftUpperArm", &"LeftLowerArm", &"LeftHand"]:
			wanted = hang
		elif limb in [7, 8, 9]:
			wanted = hang.inverse()
		_check_turn(rig, limb, wanted, "hanging")


func test_turning_the_whole_person_turns_every_limb_alike() -> void:
	for arms: float in ARMS_DEG:
		for heading: float in HEADINGS_DEG:
			var axis: Vector3 = Vector3(_random.randfn(), _random.randfn(), _random.randfn())
			var turn: Quaternion = Quaternion(axis.normalized(), _random.randf_range(-3.0, 3.0))
			var frame: Dictionary = People.t_pose(arms)
			frame["Hips"] = turn
			var rig: BvhRig = _rig(arms, heading, [frame])
			for limb: int in Limbs.COUNT:
				_check_turn(rig, limb, turn, "%s/%s deg" % [arms, heading])


func test_bent_elbow() -> void:
	# Forward, from the T-pose: the left lower arm turns about -Y, the right one about +Y.
	var bend: Quaternion = Quaternion(Vector3.UP, deg_to_rad(-80.0))
	for heading: float in HEADINGS_DEG:
		var rig: BvhRig = _rig(0.0, heading, [{"LeftLowerArm": bend}])
		for limb: int in Limbs.COUNT:
			var bent: bool = Limbs.BONES[limb] in [&"LeftLowerArm", &"LeftHand"]
			_check_turn(rig, limb, bend if bent else Quaternion.IDENTITY, "%s deg" % heading)


func test_hips_travel_in_the_direction_that_the_person_faces() -> void:
	for heading: float in HEADINGS_DEG:
		var ahead: Vector3 = Vector3(0, 100, 300).rotated(Vector3.UP, deg_to_rad(heading))
		var rig: BvhRig = _rig(0.0, heading, [{}, {"root": ahead}])
		almost_equal(rig.hips_position(0.0), Vector3(0, 1, 0), 1e-4)
		almost_equal(rig.hips_position(1.0 / 60.0), Vector3(0, 1, 3), 1e-4)
		almost_equal(rig.hips_position(0.5 / 60.0), Vector3(0, 1, 1.5), 1e-4)


func test_stays_at_its_ends() -> void:
	var rig: BvhRig = _rig(0.0, 0.0, [{}, {"root": Vector3(0, 100, 300)}])
	almost_equal(rig.hips_position(-5.0), Vector3(0, 1, 0), 1e-4)
	almost_equal(rig.hips_position(5.0), Vector3(0, 1, 3), 1e-4)
	for time: float in [-5.0, 5.0]:
		equal(rig.limb_rotation(0, time).is_finite(), true)


func test_height_of_the_hips() -> void:
	# The toes' joints are the lowest, 2 cm above the ground.
	almost_equal(_rig(0.0, 0.0, [{}]).hip_height, 0.98, 1e-4)
	almost_equal(_rig(45.0, 90.0, [{}]).hip_height, 0.98, 1e-4)


func test_hips_below_a_root() -> void:
	var clip: BvhClip = People.make(_person(0.0, 0.0, [{}]))
	var joints: Array[BvhJoint] = []
	var root: BvhJoint = BvhJoint.new()
	root.name = "World"
	root.offset = Vector3(0.0, 0.0, 20.0)
	joints.append(root)
	for joint: BvhJoint in clip.joints:
		joint.parent += 1
		joints.append(joint)
	clip.set_data(joints, clip.values, clip.frame_time)
	var rig: BvhRig = BvhRig.from_clip(clip)
	equal(rig.error, "")
	almost_equal(rig.hips_position(0.0), Vector3(0.0, 1.0, 0.2), 1e-4)
	for limb: int in Limbs.COUNT:
		_check_turn(rig, limb, Quaternion.IDENTITY, "below a root")


func test_errors() -> void:
	var empty: BvhRig = _rig(0.0, 0.0, [])
	contains(empty.error, "person.bvh: the clip has no frames")
	var nobody: People.Person = People.Person.new()
	nobody.names["LeftUpperLeg"] = ""
	contains(BvhRig.from_clip(People.make(nobody)).error, "LeftUpperLeg")


func test_skeleton_of_a_rig() -> void:
	for heading: float in [0.0, 90.0]:
		var rig: BvhRig = _rig(45.0, heading, [{}])
		var skeleton: Skeleton3D = BvhSkeleton.make(rig)
		for limb: int in Limbs.COUNT:
			var bone: int = skeleton.find_bone(Limbs.BONES[limb])
			var rest: Transform3D = skeleton.get_bone_global_rest(bone)
			var lift: Vector3 = Vector3(0.0, rig.rest_floor(), 0.0)
			almost_equal(rest.origin + lift, rig.rest_base(limb), 1e-4, Limbs.BONES[limb])
			almost_equal(rest.basis.determinant(), 1.0, 1e-4)
			var along: Vector3 = rig.rest_tail(limb) - rig.rest_base(limb)
			almost_equal(rest.basis.y, along.normalized(), 1e-3, Limbs.BONES[limb])
		skeleton.free()


func _person(p_arms: float, p_heading: float, p_frames: Array[Dictionary]) -> People.Person:
	var person: People.Person = People.Person.new()
	person.arms_deg = p_arms
	person.heading_deg = p_heading
	person.frames = p_frames
	return person


func _rig(p_arms: float, p_heading: float, p_frames: Array[Dictionary]) -> BvhRig:
	return BvhRig.from_clip(People.make(_person(p_arms, p_heading, p_frames)))


func _check_turn(p_rig: BvhRig, p_limb: int, p_wanted: Quaternion, p_note: String) -> void:
	var got: Quaternion = p_rig.limb_rotation(p_limb, 0.0)
	almost_equal(got, p_wanted, 2e-4, "%s, %s" % [Limbs.BONES[p_limb], p_note])

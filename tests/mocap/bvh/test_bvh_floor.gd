extends TestCase
## The ground of a clip is where the body's surface is lowest, standing on soles, lying on the back.

const People: GDScript = preload("res://tests/mocap/people_samples.gd")
const SHAPES: String = "res://assets/avatar/shapes/soldier.json"


func test_the_body_is_as_thick_as_the_ragdoll() -> void:
	var data: Dictionary = JSON.parse_string(FileAccess.get_file_as_string(SHAPES))
	for geom: Dictionary in data["geoms"]:
		var limb: int = Limbs.find(StringName(geom["bone"] as String))
		var thick: float = BvhFloor.RADII[limb]
		if limb == Limbs.HIPS:
			almost_equal(BvhFloor.HIPS, (geom["anchor"] as Array)[1], 1e-3)
		if limb in Limbs.FEET:
			equal(thick, 0.0)
		elif geom["type"] == "pill":
			almost_equal(thick, geom["radius"], 1e-3, geom["bone"])
		else:
			almost_equal(thick, (geom["size"] as Array)[2] / 2.0, 1e-3, geom["bone"])


func test_standing_on_the_soles() -> void:
	# The toes' joints, which are the lowest, are 2 cm above the ground of the file.
	for height: float in [100.0, 130.0, 20.0]:
		var rig: BvhRig = _rig([{"root": Vector3(0.0, height, 0.0)}])
		almost_equal(BvhFloor.find(rig), height / 100.0 - 0.98, 1e-3)


func test_lying_on_back_face_and_side() -> void:
	var turns: Dictionary[String, Quaternion] = {
		"back": Quaternion(Vector3.RIGHT, -PI / 2),
		"face": Quaternion(Vector3.RIGHT, PI / 2),
	}
	for way: String in turns:
		var rig: BvhRig = _rig([{"root": Vector3(0.0, 30.0, 0.0), "Hips": turns[way]}])
		var floor_below: float = 0.3 - BvhFloor.find(rig)
		# The chest is thicker than the hips; somebody on his face lies on his toes too.
		is_true(floor_below > 0.12 and floor_below < 0.22, "%s: %f m" % [way, floor_below])
	var side: BvhRig = _rig(
		[{"root": Vector3(0.0, 60.0, 0.0), "Hips": Quaternion(Vector3.BACK, PI / 2)}]
	)
	almost_equal(0.6 - BvhFloor.find(side), 0.9, 0.03, "an arm that is stretched out is below")


func test_kneeling() -> void:
	var rig: BvhRig = _rig(
		[
			{
				"root": Vector3(0.0, 60.0, 0.0),
				"LeftLowerLeg": Quaternion(Vector3.RIGHT, PI / 2),
				"RightLowerLeg": Quaternion(Vector3.RIGHT, PI / 2),
				"LeftFoot": Quaternion(Vector3.RIGHT, PI / 2),
				"RightFoot": Quaternion(Vector3.RIGHT, PI / 2),
			}
		]
	)
	# Knees 50 cm below the hips; feet that are stretched reach no lower.
	almost_equal(0.6 - BvhFloor.find(rig), 0.5 + 0.078 * rig.hip_height / BvhFloor.HIPS, 1e-3)


func test_a_moment_below_the_ground_does_not_count() -> void:
	var frames: Array[Dictionary] = []
	for frame: int in 100:
		var height: float = 90.0 if frame < 5 else (150.0 if frame > 60 else 100.0)
		frames.append({"root": Vector3(0.0, height, 0.0)})
	almost_equal(BvhFloor.find(_rig(frames)), 0.02, 1e-3, "nor does a jump")


func test_a_joint_that_is_not_of_the_body_says_nothing() -> void:
	var person: People.Person = People.Person.new()
	var clip: BvhClip = People.make(person)
	var joints: Array[BvhJoint] = clip.joints
	var prop: BvhJoint = BvhJoint.new()
	prop.name = "Hole"
	prop.parent = 0
	prop.offset = Vector3(0.0, -300.0, 0.0)
	joints.append(prop)
	clip.set_data(joints, clip.values, clip.frame_time)
	var rig: BvhRig = BvhRig.from_clip(clip)
	almost_equal(BvhFloor.find(rig), 0.02, 1e-3)
	almost_equal(rig.hip_height, 0.98, 1e-3)


func test_feet_without_toes_have_a_height() -> void:
	var person: People.Person = People.Person.new()
	for side: String in ["Left", "Right"]:
		person.names[side + "Toes"] = ""
		person.names[side + "ToesEnd"] = ""
	var rig: BvhRig = BvhRig.from_clip(People.make(person))
	# Ankles 8 cm above the file's ground, legs of 87 cm: feet of 0.039 / 0.491 of that.
	almost_equal(rig.hip_height, 0.92 + 0.87 * 0.039 / 0.491, 1e-3)
	almost_equal(BvhFloor.find(rig), 0.08 - 0.87 * 0.039 / 0.491, 1e-3)


func _rig(p_frames: Array[Dictionary]) -> BvhRig:
	var person: People.Person = People.Person.new()
	person.frames = p_frames
	var rig: BvhRig = BvhRig.from_clip(People.make(person))
	equal(rig.error, "")
	return rig

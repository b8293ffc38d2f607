extends TestCase
## Sizes of people: plausible from the height, checked when measured, fitted to skeletons.


func test_a_person_of_usual_build_stands_on_the_ground() -> void:
	for height: float in [1.2, 1.75, 2.1]:
		var size: BodySize = BodySize.of_height(height)
		var bases: PackedVector3Array = size.joints()
		var tails: PackedVector3Array = size.tails()
		almost_equal(tails[3].y, height, 0.01, "the top of the head")
		almost_equal(bases[0].y, height * 0.53, 1e-5)
		almost_equal(bases[11].distance_to(bases[12]), size.length(&"shank"), 1e-5)
		almost_equal(bases[4].distance_to(bases[5]), height * 0.186, 1e-5)
		almost_equal(tails[6].x - tails[9].x, height * 1.139, 0.01, "arms' span")
		for limb: int in Limbs.COUNT:
			is_true(tails[limb].y >= 0.0 and bases[limb].y <= height, Limbs.BONES[limb])
		for limb: int in [4, 5, 10, 11, 12]:
			var right: int = limb + 3
			almost_equal(bases[right], bases[limb] * Vector3(-1, 1, 1), 1e-6)


func test_measures_and_their_ranges() -> void:
	var size: BodySize = BodySize.of_height(1.8)
	equal(size.measure(&"thigh", 0.46), "")
	almost_equal(size.length(&"thigh"), 0.46, 1e-9)
	contains(size.measure(&"thigh", 1.4), "thigh is between 0.22 and 0.79 m for a height of 1.80 m")
	contains(size.measure(&"thigh", NAN), "found nan")
	contains(size.measure(&"tail", 0.4), "there is no measure 'tail', only hip_height")
	almost_equal(size.length(&"thigh"), 0.46, 1e-9)
	contains(size.set_height(3.0), "a person is between 0.8 and 2.5 m tall, found 3.00 m")
	contains(size.set_height(NAN), "found nan")
	equal(size.set_height(0.9), "")
	almost_equal(size.length(&"thigh"), 0.9 * 0.245, 1e-9, "0.46 m does not fit any more")
	equal(size.measured.size(), 0)
	almost_equal(BodySize.of_hip_height(0.95).length(&"hip_height"), 0.95, 1e-6)


func test_a_figure_in_the_reset_pose_is_the_body() -> void:
	var size: BodySize = BodySize.of_height(1.7)
	var figure: BodySegments = BodySegments.new(size)
	var pose: PoseSample = CalibrationMotion.new().pose_at(0.0)
	pose.root = size.joints()[0]
	figure.solve(pose)
	almost_equal(figure.bases, size.joints(), 1e-5)
	almost_equal(figure.tails, size.tails(), 1e-5)


func test_limbs_of_a_figure_keep_their_lengths() -> void:
	var source: BvhSource = BvhSource.new()
	source.open("res://assets/motion/Boxing_Toes.bvh")
	var size: BodySize = source.get_body()
	var figure: BodySegments = BodySegments.new(size)
	for step: int in 20:
		figure.solve(source.pose_at(step * 0.5))
		for limb: int in [4, 5, 7, 8, 10, 11, 13, 14]:
			var length: float = figure.bases[limb].distance_to(figure.tails[limb])
			var wanted: float = size.joints()[limb].distance_to(size.tails()[limb])
			almost_equal(length, wanted, 1e-4)
			almost_equal(figure.tails[limb], figure.bases[limb + 1], 1e-4)


func test_an_avatar_gets_the_size() -> void:
	var soldier: Node3D = (load("res://assets/avatar/soldier.glb") as PackedScene).instantiate()
	add_child(soldier)
	var skeleton: Skeleton3D = soldier.find_children("*", "Skeleton3D")[0]
	for height: float in [1.4, 1.75, 2.0]:
		var size: BodySize = BodySize.of_height(height)
		size.measure(&"forearm", height * 0.16)
		for twice: int in 2:
			BodyFit.apply(skeleton, size)
		var lower: Vector3 = _place(skeleton, &"LeftLowerArm")
		almost_equal(lower.distance_to(_place(skeleton, &"LeftHand")), height * 0.16, 1e-3)
		var knee: Vector3 = _place(skeleton, &"RightLowerLeg")
		var thigh: float = knee.distance_to(_place(skeleton, &"RightUpperLeg"))
		almost_equal(thigh, height * 0.245, 1e-3)
		var hip: Vector3 = _place(skeleton, &"LeftUpperLeg")
		almost_equal(hip.y, height * 0.53, 0.01, "hips at their height")
		var shoulder: Vector3 = _place(skeleton, &"LeftUpperArm")
		almost_equal(shoulder.y - hip.y, height * 0.288, 0.04, "the trunk")
		almost_equal(shoulder.x, height * 0.259 / 2.0, 0.01, "half the shoulders")
	soldier.free()


func _place(p_skeleton: Skeleton3D, p_bone: StringName) -> Vector3:
	return p_skeleton.get_bone_global_pose(p_skeleton.find_bone(p_bone)).origin

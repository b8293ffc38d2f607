extends TestCase
## The table of limbs is consistent, and the reset pose is what it says.


func test_tables_fit_together() -> void:
	for table: Array in [Limbs.BONES, Limbs.PARENTS, Limbs.TAILS, Limbs.MASS_FRACTIONS]:
		equal(table.size(), Limbs.COUNT)
	equal(Limbs.TORQUES.size(), Limbs.COUNT)
	equal(Limbs.PARENTS[Limbs.ROOT], -1)
	for limb: int in range(1, Limbs.COUNT):
		is_true(Limbs.PARENTS[limb] >= 0 and Limbs.PARENTS[limb] < limb, Limbs.BONES[limb])
		is_true(Limbs.TORQUES[limb] > 0.0, Limbs.BONES[limb])


func test_names_are_those_of_the_humanoid_profile() -> void:
	var profile: SkeletonProfileHumanoid = SkeletonProfileHumanoid.new()
	for limb: int in Limbs.COUNT:
		is_true(profile.find_bone(Limbs.BONES[limb]) >= 0, Limbs.BONES[limb])
		equal(Limbs.find(Limbs.BONES[limb]), limb)
	equal(Limbs.find(&"Tail"), -1)


func test_parents_are_ancestors_in_the_humanoid_profile() -> void:
	var profile: SkeletonProfileHumanoid = SkeletonProfileHumanoid.new()
	for limb: int in range(1, Limbs.COUNT):
		var wanted: StringName = Limbs.BONES[Limbs.PARENTS[limb]]
		var bone: StringName = Limbs.BONES[limb]
		while bone != wanted and bone != &"":
			bone = profile.get_bone_parent(profile.find_bone(bone))
		equal(bone, wanted, Limbs.BONES[limb])


func test_masses_and_sides() -> void:
	var total: float = 0.0
	for limb: int in Limbs.COUNT:
		total += Limbs.MASS_FRACTIONS[limb]
		var bone: String = Limbs.BONES[limb]
		if bone.begins_with("Left"):
			var other: int = Limbs.find(StringName(bone.replace("Left", "Right")))
			equal(Limbs.MASS_FRACTIONS[limb], Limbs.MASS_FRACTIONS[other], bone)
			equal(Limbs.TORQUES[limb], Limbs.TORQUES[other], bone)
	almost_equal(total, 1.0, 0.002)


func test_rest_to_reset_turns_limbs_into_the_t_pose() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 1
	for limb: int in Limbs.COUNT:
		for _round: int in 50:
			var direction: Vector3 = Vector3(random.randfn(), random.randfn(), random.randfn())
			var turn: Quaternion = Limbs.rest_to_reset(limb, direction)
			if Limbs.RESET_DIRECTIONS.has(limb):
				var wanted: Vector3 = Limbs.RESET_DIRECTIONS[limb]
				almost_equal(turn * direction.normalized(), wanted, 1e-4)
			else:
				equal(turn, Quaternion.IDENTITY)


func test_rest_to_reset_of_opposite_and_missing_directions() -> void:
	for limb: int in Limbs.RESET_DIRECTIONS:
		var wanted: Vector3 = Limbs.RESET_DIRECTIONS[limb]
		for off: Vector3 in [Vector3.ZERO, Vector3(1e-5, 1e-5, 1e-5), Vector3(0.01, 0.01, 0.01)]:
			var opposite: Vector3 = off - wanted
			var turn: Quaternion = Limbs.rest_to_reset(limb, opposite)
			is_true(turn.is_finite())
			is_true((turn * opposite.normalized()).angle_to(wanted) < 0.05, Limbs.BONES[limb])
		equal(Limbs.rest_to_reset(limb, Vector3.ZERO), Quaternion.IDENTITY)
		almost_equal(Limbs.rest_to_reset(limb, wanted * 3.0), Quaternion.IDENTITY)


func test_a_person_faces_plus_z() -> void:
	# Then the left side is at +X.
	equal(Limbs.RESET_DIRECTIONS[Limbs.find(&"LeftUpperArm")], Vector3.RIGHT)
	equal(Limbs.RESET_DIRECTIONS[Limbs.find(&"RightUpperArm")], Vector3.LEFT)

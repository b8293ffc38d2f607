extends TestCase
## The soldier's body in the sizes of other people: skeleton, bodies, skin.

const RestSamples: GDScript = preload("rest_samples.gd")
const SOLDIER: PackedScene = preload("res://scenes/actor/soldier.tscn")
const ROUNDS: int = 12

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _soldier: Ragdoll = null
var _own: PackedFloat32Array = PackedFloat32Array()
var _person: Ragdoll = null


func before_each() -> void:
	_random.seed = 5
	_soldier = SOLDIER.instantiate()
	_own = BodyScale.own_lengths(_soldier)


func after_each() -> void:
	_soldier.free()
	if _person != null:
		_person.free()
		_person = null


func test_limbs_get_the_lengths_that_are_reported() -> void:
	for _round: int in ROUNDS:
		var given: PackedFloat32Array = _random_lengths(0.55, 1.75, 0.0)
		_make(given)
		var got: PackedFloat32Array = BodyScale.own_lengths(_person)
		for limb: int in range(3, Limbs.COUNT):
			almost_equal(got[limb], given[limb], 0.001, Limbs.BONES[limb])
		# Where in the back the joints are, every skeleton has its own opinion.
		almost_equal(got[0] + got[1] + got[2], given[0] + given[1] + given[2], 0.001, "trunk")
		for limb: int in [4, 5, 7, 8, 10, 11, 13, 14]:
			var length: float = _anchor(limb).distance_to(_anchor(limb + 1))
			almost_equal(length, given[limb], 0.001, Limbs.BONES[limb])


func test_what_is_not_told_follows_from_the_rest() -> void:
	for _round: int in ROUNDS:
		var factor: float = _random.randf_range(0.7, 1.3)
		var given: PackedFloat32Array = []
		for limb: int in Limbs.COUNT:
			given.append(_own[limb] * factor if _random.randf() < 0.4 else 0.0)
		given[[4, 5, 10, 11][_random.randi() % 4]] = 0.0
		given[14] = _own[14] * factor
		_make(given, _soldier.get_hip_height() * factor if _random.randf() < 0.5 else 0.0)
		var got: PackedFloat32Array = BodyScale.own_lengths(_person)
		for limb: int in Limbs.COUNT:
			almost_equal(got[limb], _own[limb] * factor, 0.001, Limbs.BONES[limb])


func test_one_side_tells_of_the_other_and_the_hips_of_the_legs() -> void:
	var given: PackedFloat32Array = _nothing()
	given[4] = _own[4] * 1.2
	_make(given, _soldier.get_hip_height() * 0.9)
	var got: PackedFloat32Array = BodyScale.own_lengths(_person)
	almost_equal(got[7], _own[7] * 1.2, 0.001)
	for limb: int in [10, 11, 13, 14]:
		almost_equal(got[limb], _own[limb] * 0.9, 0.001)


func test_the_hips_are_as_high_as_legs_and_feet_are_long() -> void:
	for factor: float in [0.7, 0.8, 1.13, 1.3]:
		_make(_times(factor))
		almost_equal(_person.get_hip_height(), _soldier.get_hip_height() * factor, 0.005)
		var given: PackedFloat32Array = _times(1.0)
		for limb: int in [10, 11, 13, 14]:
			given[limb] *= factor
		_make(given)
		var legs: float = (_own[10] + _own[11]) * (factor - 1.0)
		almost_equal(_person.get_hip_height() - _soldier.get_hip_height(), legs, 0.05)


func test_profiles_are_sound_and_soles_on_the_ground() -> void:
	for _round: int in ROUNDS:
		_make(_random_lengths(0.5, 1.8))
		equal(_person.profile.find_fault(), "")
		is_true(_person.get_joints().is_sound())
		almost_equal(_sole(_person), _sole(_soldier), 1e-3)
		for limb: RagdollLimb in _person.profile.limbs:
			var bone: PhysicalBone3D = _bone(limb.bone)
			var rest: Transform3D = RestSkeleton.new(_person.get_skeleton()).rest(limb.bone)
			almost_equal((rest * bone.body_offset).origin, limb.position, 1e-4, limb.bone)
			almost_equal(rest.origin, limb.anchor, 1e-4, limb.bone)
			_check_shape(bone, limb)


func test_mass_goes_with_the_square_of_the_height() -> void:
	for factor: float in [0.7, 0.8, 1.13, 1.3]:
		_make(_times(factor))
		almost_equal(_person.profile.mass, _soldier.profile.mass * factor ** 2, 0.05)
	for _round: int in ROUNDS:
		_make(_random_lengths(0.5, 1.8))
		var shares: float = 0.0
		var bodies: float = 0.0
		for limb: RagdollLimb in _person.profile.limbs:
			shares += limb.mass_fraction
			bodies += _bone(limb.bone).mass
		almost_equal(shares, 1.0, 1e-4)
		almost_equal(bodies, _person.profile.mass, 0.01)
		is_true(bodies > 15.0 and bodies < 300.0, "%f kg" % bodies)


func test_a_longer_limb_is_heavier_than_its_neighbour() -> void:
	var given: PackedFloat32Array = _times(1.0)
	given[4] *= 1.4
	_make(given)
	is_true(_bone(&"LeftUpperArm").mass > 1.3 * _bone(&"RightUpperArm").mass)
	is_true(_strength(&"LeftUpperArm") > 1.2 * _strength(&"RightUpperArm"))


func test_the_reset_pose_is_still_a_t_pose() -> void:
	for _round: int in ROUNDS:
		_make(_random_lengths(0.55, 1.75))
		var moves: Array[Transform3D] = LimbDistance.rest_to_reset(_person.profile)
		for limb: int in Limbs.RESET_DIRECTIONS:
			if limb in [6, 9]:
				continue
			var move: Transform3D = moves[_person.profile.find_index(Limbs.BONES[limb])]
			var from: Vector3 = move * _anchor(limb)
			var to: Vector3 = move * _anchor(limb + 1)
			var off: float = rad_to_deg((to - from).angle_to(Limbs.RESET_DIRECTIONS[limb]))
			is_true(off < 0.2, "%s is off by %f deg" % [Limbs.BONES[limb], off])


func test_limbs_do_not_touch_in_the_reset_pose() -> void:
	equal(RagdollBuilder.overlaps(_soldier.profile), [] as Array[Array])
	for factor: float in [0.5, 0.8, 1.13, 1.8]:
		_make(_times(factor))
		equal(RagdollBuilder.overlaps(_person.profile), [] as Array[Array], "times %f" % factor)
	for _round: int in ROUNDS:
		_make(_random_lengths(0.75, 1.3))
		equal(RagdollBuilder.overlaps(_person.profile), [] as Array[Array])


func test_a_client_makes_the_same_body_of_the_joints() -> void:
	for _round: int in ROUNDS:
		_make(_random_lengths(0.5, 1.8))
		var joints: PersonSkeleton = _person.get_joints()
		var shown: Ragdoll = SOLDIER.instantiate()
		is_true(shown.fit_to(joints))
		var got: PersonSkeleton = shown.get_joints()
		for limb: int in Limbs.COUNT:
			almost_equal(got.joints_in_limb[limb], joints.joints_in_limb[limb], 1e-4)
			if limb > 0:
				almost_equal(got.joints_in_parent[limb], joints.joints_in_parent[limb], 1e-4)
		almost_equal(shown.get_hip_height(), _person.get_hip_height(), 1e-4)
		shown.free()


func test_the_skin_follows() -> void:
	var before: Array[PackedVector3Array] = _skin(_soldier)
	for factor: float in [0.8, 1.13]:
		_make(_times(factor))
		var after: Array[PackedVector3Array] = _skin(_person)
		for limb: int in Limbs.COUNT:
			# A body of another size is the same picture from another distance.
			equal(after[limb].size(), before[limb].size())
			for i: int in range(0, before[limb].size(), 20):
				var way: float = before[limb][i].distance_to(before[limb][0])
				var now: float = after[limb][i].distance_to(after[limb][0])
				almost_equal(now, way * factor, 0.002)
	for _round: int in 4:
		_make(_random_lengths(0.55, 1.75))
		var skin: Array[PackedVector3Array] = _skin(_person)
		for limb: int in Limbs.COUNT:
			var shape: RagdollLimb = _person.profile.find(Limbs.BONES[limb])
			var former: float = _farthest(_soldier.profile.find(Limbs.BONES[limb]), before[limb])
			var now: float = _farthest(shape, skin[limb])
			is_true(now < 2.0 * former + 0.01, "%s %f m off" % [Limbs.BONES[limb], now])


func test_characters_of_any_kind_can_be_fitted() -> void:
	for unit: float in [1.0, 0.01]:
		for axes: int in 3:
			var kind: RestSamples.Kind = RestSamples.Kind.new()
			kind.unit = unit
			kind.axes = axes
			kind.is_z_up = axes == 1
			if _person != null:
				_person.free()
			_person = RestSamples.make(kind)
			_person.make_bodies()
			var given: PackedFloat32Array = BodyScale.own_lengths(_person)
			for limb: int in Limbs.COUNT:
				given[limb] *= 0.9 if limb <= 3 else 0.8 if limb < 10 else 1.2
			is_true(_person.fit(given))
			equal(_person.profile.find_fault(), "")
			var got: PackedFloat32Array = BodyScale.own_lengths(_person)
			for limb: int in Limbs.COUNT:
				almost_equal(got[limb], given[limb], 0.001, Limbs.BONES[limb])
			var skin: Array[PackedVector3Array] = _skin(_person)
			for limb: RagdollLimb in _person.profile.limbs:
				var off: float = _farthest(limb, skin[Limbs.find(limb.bone)])
				is_true(off < 0.1, "the skin of %s is %f m off" % [limb.bone, off])


func test_scenes_of_other_people_stay_as_they_are() -> void:
	_make(_times(0.8))
	var fresh: Ragdoll = SOLDIER.instantiate()
	equal(BodyScale.own_lengths(fresh), _own)
	equal(fresh.profile.mass, _soldier.profile.mass)
	equal(_skin(fresh), _skin(_soldier))
	for limb: int in Limbs.COUNT:
		var name: StringName = Limbs.BONES[limb]
		equal(fresh.profile.find(name).position, _soldier.profile.find(name).position)
		_check_shape(fresh.get_simulator().get_node(NodePath(name)), fresh.profile.find(name))
	fresh.free()


func test_nothing_told_changes_nothing() -> void:
	for given: PackedFloat32Array in [_nothing(), _own, PackedFloat32Array()]:
		var person: Ragdoll = SOLDIER.instantiate()
		var profile: RagdollProfile = person.profile
		is_false(person.fit(given, 0.0))
		is_false(person.fit(given, 0.0), "and again")
		is_true(person.profile == profile)
		equal(person.get_hip_height(), _soldier.get_hip_height())
		person.free()
	var same: Ragdoll = SOLDIER.instantiate()
	is_false(same.fit_to(_soldier.get_joints()))
	is_false(same.fit_to(PersonSkeleton.new()))
	is_false(same.fit_to(null))
	same.free()


func test_hostile_lengths_are_limited() -> void:
	var bad: Array[float] = [NAN, INF, -INF, -1.0, 1e30, 1e-30, 0.031, 1.19, 0.0]
	for _round: int in 40:
		var given: PackedFloat32Array = []
		for limb: int in Limbs.COUNT:
			given.append(bad[_random.randi() % bad.size()] if _random.randf() < 0.7 else _own[limb])
		_make(given, bad[_random.randi() % bad.size()])
		equal(_person.profile.find_fault(), "")
		is_true(_person.get_joints().is_sound())
		for limb: int in Limbs.COUNT:
			var factor: float = BodyScale.own_lengths(_person)[limb] / _own[limb]
			is_true(factor > 0.49 and factor < 1.81, "%s times %f" % [Limbs.BONES[limb], factor])
	for size: int in [1, 15, 17, 1000]:
		var person: Ragdoll = SOLDIER.instantiate()
		var given: PackedFloat32Array = []
		given.resize(size)
		given.fill(0.4)
		is_false(person.fit(given))
		person.free()


func test_a_hostile_server_cannot_make_monsters() -> void:
	for factor: float in [0.0, 1e-6, 0.01, 8.0]:
		var joints: PersonSkeleton = _soldier.get_joints()
		for limb: int in Limbs.COUNT:
			joints.joints_in_limb[limb] *= factor
			joints.joints_in_parent[limb] *= factor
		var person: Ragdoll = SOLDIER.instantiate()
		person.fit_to(joints)
		equal(person.profile.find_fault(), "")
		is_true(person.get_joints().is_sound())
		is_true(person.get_hip_height() > 0.4 and person.get_hip_height() < 2.0)
		person.free()


func test_a_body_is_fitted_once() -> void:
	_make(_times(0.8))
	var lengths: PackedFloat32Array = BodyScale.own_lengths(_person)
	is_false(_person.fit(_times(1.2)))
	equal(BodyScale.own_lengths(_person), lengths)


func _make(p_lengths: PackedFloat32Array, p_hip_height: float = 0.0) -> void:
	if _person != null:
		_person.free()
	_person = SOLDIER.instantiate()
	_person.fit(p_lengths, p_hip_height)


func _nothing() -> PackedFloat32Array:
	var lengths: PackedFloat32Array = []
	lengths.resize(Limbs.COUNT)
	return lengths


func _times(p_factor: float) -> PackedFloat32Array:
	var lengths: PackedFloat32Array = []
	for length: float in _own:
		lengths.append(length * p_factor)
	return lengths


func _random_lengths(p_least: float, p_most: float, p_lopsided: float = 0.03) -> PackedFloat32Array:
	var lengths: PackedFloat32Array = []
	for limb: int in Limbs.COUNT:
		var other: int = MeshShapes.mirrored(limb)
		var factor: float = _random.randf_range(p_least, p_most)
		if other < limb and other >= 0:
			factor = lengths[other] / _own[other]
			factor *= 1.0 + _random.randf_range(-p_lopsided, p_lopsided)
		lengths.append(_own[limb] * clampf(factor, p_least, p_most))
	return lengths


func _anchor(p_limb: int) -> Vector3:
	return _person.profile.find(Limbs.BONES[p_limb]).anchor


func _bone(p_name: StringName) -> PhysicalBone3D:
	return _person.get_simulator().get_node(NodePath(p_name))


func _strength(p_name: StringName) -> float:
	return _person.profile.find(p_name).max_torque


func _sole(p_person: Ragdoll) -> float:
	var lowest: float = INF
	for limb: RagdollLimb in p_person.profile.limbs:
		for point: Vector3 in limb.contact_points if limb.is_foot else PackedVector3Array():
			lowest = minf(lowest, point.y)
	return lowest


func _check_shape(p_bone: PhysicalBone3D, p_limb: RagdollLimb) -> void:
	var wanted: Shape3D = RagdollBuilder.make_shape(p_limb)
	var shape: Shape3D = (p_bone.get_child(0) as CollisionShape3D).shape
	if wanted is BoxShape3D:
		almost_equal((shape as BoxShape3D).size, (wanted as BoxShape3D).size, 1e-4)
		return
	var capsule: CapsuleShape3D = shape
	almost_equal(capsule.radius, (wanted as CapsuleShape3D).radius, 1e-4)
	almost_equal(capsule.height, (wanted as CapsuleShape3D).height, 1e-4)


func _skin(p_person: Ragdoll) -> Array[PackedVector3Array]:
	return SkinnedSurface.new(RestSkeleton.new(p_person.get_skeleton())).points


func _farthest(p_limb: RagdollLimb, p_points: PackedVector3Array) -> float:
	var farthest: float = 0.0
	for point: Vector3 in p_points:
		farthest = maxf(farthest, LimbDistance.to_surface(p_limb, point))
	return farthest

extends TestCase
## A skeleton that comes from the network is checked before it is used.


func test_a_whole_one_is_sound() -> void:
	var joints: PersonSkeleton = _skeleton()
	equal(joints.count(), Limbs.COUNT)
	is_true(joints.is_sound())


func test_too_few_and_too_many_limbs() -> void:
	is_false(PersonSkeleton.new().is_sound())
	var joints: PersonSkeleton = _skeleton()
	joints.add(Vector3.ZERO, Vector3.ZERO, Quaternion.IDENTITY)
	is_false(joints.is_sound())


func test_joints_that_are_no_persons() -> void:
	for bad: Vector3 in [
		Vector3(NAN, 0.0, 0.0), Vector3(0.0, INF, 0.0), Vector3(0.0, 0.0, -PersonSkeleton.MAX_M)
	]:
		var joints: PersonSkeleton = _skeleton()
		joints.joints_in_parent[3] = bad
		is_false(joints.is_sound(), "in parent: %s" % bad)
		joints = _skeleton()
		joints.joints_in_limb[0] = bad
		is_false(joints.is_sound(), "in limb: %s" % bad)


func test_orientations_that_are_none() -> void:
	for bad: Quaternion in [
		Quaternion(0.0, 0.0, 0.0, 0.0),
		Quaternion(NAN, 0.0, 0.0, 1.0),
		Quaternion(1.0, 1.0, 0.0, 0.0)
	]:
		var joints: PersonSkeleton = _skeleton()
		joints.reset_orientations[15] = bad
		is_false(joints.is_sound(), str(bad))


func test_where_a_body_is() -> void:
	var joints: PersonSkeleton = _skeleton()
	joints.reset_orientations[2] = Quaternion(Vector3.RIGHT, 0.5)
	var turn: Quaternion = Quaternion(Vector3.UP, 1.0)
	var body: Transform3D = joints.body_at(2, Vector3(1.0, 2.0, 3.0), turn)
	almost_equal(body.origin, Vector3(1.0, 2.0, 3.0))
	almost_equal(body.basis.get_rotation_quaternion(), turn * Quaternion(Vector3.RIGHT, 0.5))
	almost_equal(
		joints.body_at(0, Vector3.ZERO, Quaternion.IDENTITY), Transform3D.IDENTITY, 1e-6, "reset"
	)


func test_the_root_follows_the_hips() -> void:
	var joints: PersonSkeleton = _skeleton()
	joints.joints_in_limb[Limbs.ROOT] = Vector3(0.0, -0.1, 0.05)
	var sample: PoseSample = PoseSample.new()
	sample.orientations.resize(4 * Limbs.COUNT)
	for limb: int in Limbs.COUNT:
		sample.orientations[4 * limb + 3] = 1.0
	var hips: Vector3 = Vector3(1.0, 0.9, 2.0)
	almost_equal(joints.root_of(sample, hips), Vector3(1.0, 1.0, 1.95))
	# Half a turn about the vertical: what was before is behind.
	sample.orientations[4 * Limbs.ROOT + 1] = 1.0
	sample.orientations[4 * Limbs.ROOT + 3] = 0.0
	almost_equal(joints.root_of(sample, hips), Vector3(1.0, 1.0, 2.05))


func _skeleton() -> PersonSkeleton:
	var joints: PersonSkeleton = PersonSkeleton.new()
	for limb: int in Limbs.COUNT:
		joints.add(Vector3(0.0, 0.1, 0.0), Vector3(0.0, -0.1, 0.01 * limb), Quaternion.IDENTITY)
	return joints

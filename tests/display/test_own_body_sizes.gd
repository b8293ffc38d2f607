extends TestCase
## Wearers of other sizes see their own body where the motion has it, without gaps.

const SOLDIER: PackedScene = preload("res://scenes/actor/soldier.tscn")
const RATE: int = 60
const FLOATS: int = 7

var _source: BvhSource = BvhSource.new()


func test_the_own_body_has_the_size_and_no_gaps() -> void:
	_source.open("res://assets/motion/01_01.bvh")
	for factors: Vector2 in [Vector2(0.797, 0.797), Vector2(1.126, 1.126), Vector2(0.8, 1.25)]:
		var person: Ragdoll = SOLDIER.instantiate()
		var lengths: PackedFloat32Array = BodyScale.own_lengths(person)
		for limb: int in Limbs.COUNT:
			lengths[limb] *= factors.x if limb < 10 else factors.y
		is_true(person.fit(lengths))
		_check(person)
		person.free()


func _check(p_person: Ragdoll) -> void:
	var joints: PersonSkeleton = p_person.get_joints()
	var body: OwnBody = OwnBody.new()
	var scale: float = p_person.get_hip_height() / _source.get_hip_height()
	body.setup(joints, scale, RATE)
	for step: int in 90:
		var sample: PoseSample = _source.pose_at(step / float(RATE))
		sample.time_usec = step * 1000000 / RATE
		is_true(body.add_sample(sample))
		var now: int = sample.time_usec + 500000 / RATE
		var floats: PackedFloat32Array = body.evaluate(now / 1e6, now)
		equal(floats.size(), Limbs.COUNT * FLOATS)
		if step < 5:
			continue
		var hips: Vector3 = _at(floats, 0) * joints.joints_in_limb[0]
		almost_equal(hips, sample.root * scale, 0.02, "hips")
		for limb: int in range(1, Limbs.COUNT):
			var outer: Vector3 = _at(floats, Limbs.PARENTS[limb]) * joints.joints_in_parent[limb]
			almost_equal(_at(floats, limb) * joints.joints_in_limb[limb], outer, 1e-3)


func _at(p_floats: PackedFloat32Array, p_limb: int) -> Transform3D:
	var i: int = p_limb * FLOATS
	var turn: Quaternion = Quaternion(
		p_floats[i + 3], p_floats[i + 4], p_floats[i + 5], p_floats[i + 6]
	)
	var place: Vector3 = Vector3(p_floats[i], p_floats[i + 1], p_floats[i + 2])
	return Transform3D(Basis(turn.normalized()), place)

extends TestCase
## The wearer's own body: at once where nothing is in the way, stopped where something is.

const SOLDIER: PackedScene = preload("res://scenes/actor/soldier.tscn")
const RATE: int = 60
## From sample to the server's answer, samples.
const ANSWER: int = 4

var _skeleton: PersonSkeleton = null
var _scale: float = 1.0
var _source: BvhSource = BvhSource.new()
var _body: OwnBody = OwnBody.new()


func before_each() -> void:
	var soldier: Ragdoll = SOLDIER.instantiate()
	_skeleton = soldier.get_joints()
	_source.open("res://assets/motion/01_01.bvh")
	_scale = soldier.get_hip_height() / _source.get_hip_height()
	soldier.free()
	_body.setup(_skeleton, _scale, RATE)


func test_the_skeleton_makes_the_rest_pose_of_the_profile() -> void:
	var soldier: Ragdoll = SOLDIER.instantiate()
	equal(_skeleton.count(), Limbs.COUNT)
	var places: Array[Transform3D] = []
	for bone: StringName in Limbs.BONES:
		var limb: RagdollLimb = soldier.profile.find(bone)
		var from_reset: Basis = Basis(limb.rest_orientation * limb.reset_orientation.inverse())
		places.append(Transform3D(from_reset, limb.position))
	soldier.free()
	equal(_skeleton.parents[0], -1)
	for i: int in range(1, _skeleton.count()):
		is_true(_skeleton.parents[i] < i and _skeleton.parents[i] >= 0)
		var outer: Vector3 = places[_skeleton.parents[i]] * _skeleton.joints_in_parent[i]
		almost_equal(places[i] * _skeleton.joints_in_limb[i], outer, 1e-5)


func test_the_hips_joint_is_where_the_sample_has_it() -> void:
	var sample: PoseSample = _source.pose_at(1.0)
	var turns: PackedFloat32Array = sample.orientations
	var turn: Quaternion = Quaternion(turns[0], turns[1], turns[2], turns[3])
	var root: Vector3 = _skeleton.root_of(sample, Vector3(1, 2, 3))
	almost_equal(root + turn * _skeleton.joints_in_limb[0], Vector3(1, 2, 3), 1e-5)


func test_nothing_is_shown_before_the_first_sample() -> void:
	is_true(_body.evaluate(0.0, 0).is_empty())


func test_the_delay_is_half_a_period_and_the_same_in_every_frame() -> void:
	# A display that is not in step with the samples.
	var next: int = 0
	for frame: int in 120:
		var now: int = frame * 1000000 / 70 + 3000
		while next * 1000000 / RATE <= now:
			is_true(_body.add_sample(_sample(next)))
			next += 1
		var shown: PackedFloat32Array = _body.evaluate(now / 1e6, now)
		almost_equal(now - _body.shown_moment_usec(now), 1e6 / RATE / 2.0, 1.0)
		var true_pose: PackedFloat32Array = (
			_source.pose_at((now - 1e6 / RATE / 2.0) / 1e6).orientations
		)
		for limb: int in _skeleton.count() if frame > 10 else 0:
			is_true(_off(shown, true_pose, limb) < deg_to_rad(3.0), "limb %d" % limb)


func test_an_arm_is_stopped_where_the_server_stops_it() -> void:
	var arm: int = Limbs.find(&"LeftUpperArm")
	var held: Quaternion = Quaternion(Vector3.UP, deg_to_rad(30.0))
	for sample: int in 90:
		var local: PoseSample = _sample(0)
		local.time_usec = sample * 1000000 / RATE
		_body.add_sample(local)
		if sample >= 30 + ANSWER:
			_body.add_truth((sample - ANSWER) * 1000000 / RATE, _truth(local, arm, held))
		_body.evaluate(sample / float(RATE), local.time_usec)
		if sample == 30 + ANSWER + 12:
			almost_equal(_body.deviation(arm), deg_to_rad(30.0), deg_to_rad(1.0))
	for limb: int in _skeleton.count():
		almost_equal(_body.deviation(limb), deg_to_rad(30.0) if limb == arm else 0.0, 0.002)


func _sample(p_number: int) -> PoseSample:
	var sample: PoseSample = _source.pose_at(p_number / float(RATE))
	sample.id = p_number
	sample.time_usec = p_number * 1000000 / RATE
	return sample


## What the server has: the sample's pose, one limb turned.
func _truth(p_sample: PoseSample, p_limb: int, p_turn: Quaternion) -> PackedFloat32Array:
	var turns: PackedFloat32Array = p_sample.orientations
	var root: Vector3 = _skeleton.root_of(p_sample, p_sample.root * _scale)
	var floats: PackedFloat32Array = []
	for limb: int in _skeleton.count():
		var at: int = limb * 4
		var turn: Quaternion = Quaternion(turns[at], turns[at + 1], turns[at + 2], turns[at + 3])
		turn = p_turn * turn if limb == p_limb else turn
		floats.append_array([root.x, root.y, root.z, turn.x, turn.y, turn.z, turn.w])
	return floats


static func _off(p_shown: PackedFloat32Array, p_true: PackedFloat32Array, p_limb: int) -> float:
	var at: int = p_limb * 7 + 3
	var shown: Quaternion = Quaternion(
		p_shown[at], p_shown[at + 1], p_shown[at + 2], p_shown[at + 3]
	)
	at = p_limb * 4
	return shown.angle_to(Quaternion(p_true[at], p_true[at + 1], p_true[at + 2], p_true[at + 3]))

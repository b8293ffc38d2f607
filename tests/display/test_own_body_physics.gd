extends "res://tests/actor/ragdoll/stage_case.gd"
## The own body with a real server's body behind it: free motion stays smooth, a wall is felt.

const RATE: int = 60
## From a sample to the server's answer, ticks.
const ANSWER: int = 4

var _body: OwnBody = null
var _skeleton: PersonSkeleton = null
var _truths: Array[PackedFloat32Array] = []
## Places of the hands, one after the other: shown, and as the wearer has them.
var _shown: PackedVector3Array = []
var _local: PackedVector3Array = []


func test_free_motion_does_not_jitter() -> void:
	for clip: String in ["01_01", "Boxing_Toes"]:
		_clear_stage()
		_stage.add_floor()
		var source: BvhSource = BvhSource.new()
		source.open("res://assets/motion/%s.bvh" % clip)
		var player: Stage.Player = _play(source.pose_at)
		var scale: float = player.ragdoll.get_hip_height() / source.get_hip_height()
		player.place = func(time: float) -> Vector3: return source.pose_at(time).root * scale
		_begin(player)
		await _stage.run(600, _see.bind(player))
		var ratio: float = _jerk(_shown) / _jerk(_local)
		is_true(ratio <= 1.1, "%s: jerk %.2f" % [clip, ratio])


func test_a_wall_stops_the_arm_that_is_shown() -> void:
	_stage.add_floor()
	var wall: Block = Block.new()
	wall.size = Vector3(1.0, 1.0, 0.5)
	wall.position = Vector3(0.7, 1.4, 0.6)
	_stage.add_child(wall)
	# The left arm swings ahead by 60 degrees within half a second; the wall is in its way.
	var player: Stage.Player = _play(
		func(time: float) -> PoseSample:
			var angle: float = deg_to_rad(60.0) * clampf((time - 1.0) / 0.5, 0.0, 1.0)
			var turn: Quaternion = Quaternion(Vector3.UP, -angle)
			return Stage.reset_pose(
				{&"LeftUpperArm": turn, &"LeftLowerArm": turn, &"LeftHand": turn}
			)
	)
	var hips: float = player.ragdoll.get_hip_height()
	player.place = func(_time: float) -> Vector3: return Vector3(0.0, hips, 0.0)
	_begin(player)
	await _stage.run(200, _see.bind(player))
	var hand: int = _shown.size() - 2
	for frame: int in 60:
		var at: int = hand - 2 * frame
		is_true(_local[at].z > 0.45, "the wearer's own hand is far inside the wall")
		is_true(_shown[at].z < 0.4, "what is shown is not: %.2f m" % _shown[at].z)
	almost_equal(_shown[hand], _truth_place(player, &"LeftHand"), 0.03)


func _truth_place(p_player: Stage.Player, p_bone: StringName) -> Vector3:
	return p_player.body(Limbs.find(p_bone)).origin


func _play(p_pose: Callable) -> Stage.Player:
	var player: Stage.Player = _stage.make_soldier(Vector3.ZERO, RagdollMotor.ROOT_SOFT)
	player.pose = p_pose
	return player


func _begin(p_player: Stage.Player) -> void:
	_stage.enter(p_player)
	_skeleton = p_player.ragdoll.get_joints()
	_body = OwnBody.new()
	# The places that the stage tells are those of the body already.
	_body.setup(_skeleton, 1.0, RATE)
	_truths.clear()
	_shown.clear()
	_local.clear()


## A frame of the display after each step: the server's answer is some ticks old.
func _see(p_time_s: float, p_player: Stage.Player) -> void:
	var sample: PoseSample = p_player.pose.call(p_time_s)
	sample.root = p_player.place.call(p_time_s)
	sample.time_usec = roundi(p_time_s * 1e6)
	_body.add_sample(sample)
	_truths.append(_truth(p_player))
	if _truths.size() > ANSWER:
		var moment: int = roundi((p_time_s - ANSWER / float(RATE)) * 1e6)
		_body.add_truth(moment, _truths[-1 - ANSWER])
	# Half a period is taken off again: what is shown is this sample.
	var shown: PackedFloat32Array = _body.evaluate(p_time_s, sample.time_usec + roundi(5e5 / RATE))
	if p_time_s < 1.0:
		return
	for bone: StringName in [&"LeftHand", &"RightHand"]:
		var limb: int = Limbs.find(bone)
		_shown.append(Vector3(shown[limb * 7], shown[limb * 7 + 1], shown[limb * 7 + 2]))
		_local.append(_local_place(sample, limb))


## Where the wearer has a limb, by forward kinematics.
func _local_place(p_sample: PoseSample, p_limb: int) -> Vector3:
	var turns: PackedFloat32Array = p_sample.orientations
	var place: Vector3 = Vector3.ZERO
	var limb: int = p_limb
	while limb > 0:
		var parent: int = _skeleton.parents[limb]
		place -= _turn(turns, limb) * _skeleton.joints_in_limb[limb]
		place += _turn(turns, parent) * _skeleton.joints_in_parent[limb]
		limb = parent
	return place + _skeleton.root_of(p_sample, p_sample.root)


func _truth(p_player: Stage.Player) -> PackedFloat32Array:
	var floats: PackedFloat32Array = []
	for limb: int in Limbs.COUNT:
		var place: Transform3D = p_player.body(limb)
		var reset: Quaternion = _skeleton.reset_orientations[limb]
		var turn: Quaternion = place.basis.get_rotation_quaternion() * reset.inverse()
		var origin: Vector3 = place.origin
		floats.append_array([origin.x, origin.y, origin.z, turn.x, turn.y, turn.z, turn.w])
	return floats


static func _turn(p_floats: PackedFloat32Array, p_limb: int) -> Quaternion:
	var at: int = p_limb * 4
	return Quaternion(p_floats[at], p_floats[at + 1], p_floats[at + 2], p_floats[at + 3])


## RMS of the third differences; two hands take turns.
static func _jerk(p_places: PackedVector3Array) -> float:
	var sum: float = 0.0
	for i: int in range(6, p_places.size()):
		var third: Vector3 = (
			p_places[i] - 3.0 * (p_places[i - 2] - p_places[i - 4]) - p_places[i - 6]
		)
		sum += third.length_squared()
	return sqrt(sum)

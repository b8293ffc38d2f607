extends Node3D
## Ragdolls that are driven through simulated time, and what can be measured of them.

const FastPhysics: GDScript = preload("fast_physics.gd")
const SOLDIER: PackedScene = preload("res://scenes/actor/soldier.tscn")

## Who plays.
var players: Array[Player] = []
## Simulated time, s.
var time_s: float = 0.0


## A ragdoll with its motion.
class Player:
	var ragdoll: Ragdoll = null
	## The pose at a time, s: a PoseSample.
	var pose: Callable = Callable()
	## Where the hips are to be at a time, s: a Vector3.
	var place: Callable = Callable()

	## Whether the sample of a time, s, gets lost; may be empty.
	var lost: Callable = Callable()
	## What is added to a sample's time of sending, s; may be empty.
	var jitter: Callable = Callable()

	## Where the body of a limb is.
	func body(p_limb: int) -> Transform3D:
		return PhysicsServer3D.body_get_state(
			ragdoll.get_bodies()[index(p_limb)], PhysicsServer3D.BODY_STATE_TRANSFORM
		)

	## Where the joint at the beginning of a limb is, by the limb's body.
	func joint(p_limb: int) -> Vector3:
		return _bone(p_limb).origin

	## The largest gap of any joint, m.
	func gap() -> float:
		var largest: float = 0.0
		for limb: int in range(1, Limbs.COUNT):
			var parent: int = Limbs.PARENTS[limb]
			var in_parent: Vector3 = (_rest(parent).affine_inverse() * _rest(limb)).origin
			largest = maxf(largest, joint(limb).distance_to(_bone(parent) * in_parent))
		return largest

	## The angle between a limb and where the motion wants it, degrees.
	func error_deg(p_limb: int, p_pose: PoseSample) -> float:
		var wanted: Quaternion = (
			p_pose.orientation(p_limb) * ragdoll.profile.limbs[index(p_limb)].reset_orientation
		)
		return rad_to_deg(wanted.angle_to(body(p_limb).basis.get_rotation_quaternion()))

	## The same, for the limb that is worst.
	func worst_error_deg(p_pose: PoseSample) -> float:
		var worst: float = 0.0
		for limb: int in Limbs.COUNT:
			worst = maxf(worst, error_deg(limb, p_pose))
		return worst

	## The highest speed of any body, m/s.
	func speed() -> float:
		var highest: float = 0.0
		for rid: RID in ragdoll.get_bodies():
			var velocity: Vector3 = PhysicsServer3D.body_get_state(
				rid, PhysicsServer3D.BODY_STATE_LINEAR_VELOCITY
			)
			highest = maxf(highest, velocity.length())
		return highest

	## Bodies come in the order of the profile.
	func index(p_limb: int) -> int:
		return ragdoll.profile.limbs.find(ragdoll.profile.find(Limbs.BONES[p_limb]))

	func _bone(p_limb: int) -> Transform3D:
		var simulator: Node = ragdoll.get_simulator()
		var bone: PhysicalBone3D = simulator.get_node(NodePath(Limbs.BONES[p_limb]))
		return body(p_limb) * bone.body_offset.affine_inverse()

	func _rest(p_limb: int) -> Transform3D:
		var skeleton: Skeleton3D = ragdoll.get_skeleton()
		return skeleton.get_bone_global_rest(skeleton.find_bone(Limbs.BONES[p_limb]))


## Adds a soldier who stands at a place in the reset pose, and starts it.
func add_soldier(p_place: Vector3, p_mode: RagdollMotor.RootMode) -> Player:
	var player: Player = make_soldier(p_place, p_mode)
	enter(player)
	return player


## A soldier who is not started yet.
func make_soldier(p_place: Vector3, p_mode: RagdollMotor.RootMode) -> Player:
	var player: Player = Player.new()
	player.ragdoll = SOLDIER.instantiate()
	player.ragdoll.root_mode = p_mode
	player.pose = func(_time: float) -> PoseSample: return reset_pose()
	player.place = func(_time: float) -> Vector3: return p_place
	return player


## Lets such a soldier play.
func enter(p_player: Player) -> void:
	add_child(p_player.ragdoll)
	p_player.ragdoll.start()
	players.append(p_player)


## Lets steps pass, and calls [param p_after] with the time, if given, after each.
func run(p_steps: int, p_after: Callable = Callable()) -> void:
	for _step: int in p_steps:
		await get_tree().physics_frame
		if time_s > 0.0 and p_after.is_valid():
			p_after.call(time_s)
		for player: Player in players:
			if not player.lost.is_valid() or not player.lost.call(time_s):
				# A sample taken a little earlier or later is of that moment.
				var at: float = time_s + (player.jitter.call() if player.jitter.is_valid() else 0.0)
				player.ragdoll.push_sample(at, player.pose.call(at), player.place.call(at))
			player.ragdoll.drive(time_s, FastPhysics.DELTA)
		time_s += FastPhysics.DELTA
	await get_tree().physics_frame
	if p_after.is_valid():
		p_after.call(time_s)


## A floor at height 0.
func add_floor() -> void:
	add_block(Vector3(20.0, 1.0, 20.0), Vector3(0.0, -0.5, 0.0))


## A fixed box of a size, m, about a place.
func add_block(p_size: Vector3, p_place: Vector3) -> void:
	var block: Block = Block.new()
	block.size = p_size
	block.position = p_place
	add_child(block)


## The reset pose, with some limbs turned.
static func reset_pose(p_turns: Dictionary = {}) -> PoseSample:
	var sample: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		sample.set_orientation(limb, p_turns.get(Limbs.BONES[limb], Quaternion.IDENTITY))
	return sample


## A pose with the whole arms turned about the axis ahead: positive angles hang them down.
static func arms_pose(p_left_deg: float, p_right_deg: float) -> PoseSample:
	var left: Quaternion = Quaternion(Vector3.BACK, deg_to_rad(-p_left_deg))
	var right: Quaternion = Quaternion(Vector3.BACK, deg_to_rad(p_right_deg))
	return reset_pose(
		{
			&"LeftUpperArm": left,
			&"LeftLowerArm": left,
			&"LeftHand": left,
			&"RightUpperArm": right,
			&"RightLowerArm": right,
			&"RightHand": right,
		}
	)

extends RefCounted
## What the cases of the gait benchmark have in common: a world of their own, a body in it, and how
## it is measured.

const Walker: GDScript = preload("walker.gd")
const Stats: GDScript = preload("gait_stats.gd")
## What people can stand on: the world and props.
const _GROUND_MASK: int = 5
const _CRATE_LAYER: int = 4

var report: BenchReport = null
var root_mode: RagdollMotor.RootMode = RagdollMotor.ROOT_INERTIAL
## What cases are named after.
var root_name: String = ""
var random: RandomNumberGenerator = RandomNumberGenerator.new()
## The seed that was given.
var first_seed: int = 1
var world: Node3D = null
var ragdoll: Ragdoll = null
var time_s: float = 0.0

var _tree: SceneTree = null


func _init(p_tree: SceneTree, p_report: BenchReport, p_seed: int) -> void:
	_tree = p_tree
	report = p_report
	first_seed = p_seed
	random.seed = p_seed


## Makes a world with a body that has not begun yet.
func begin() -> void:
	world = Node3D.new()
	_tree.root.add_child(world)
	ragdoll = BenchBodies.soldier(root_mode)
	time_s = 0.0


## Plays the case. The real ones say how.
func run() -> void:
	pass


func end() -> void:
	world.queue_free()
	world = null
	ragdoll = null
	await _tree.process_frame


## Puts the body into the world, where its motor begins.
func enter() -> void:
	world.add_child(ragdoll)
	ragdoll.start()


## One step in which the body gets a pose.
func step(p_pose: PoseSample, p_told: Vector3, p_sends: bool = true) -> void:
	await _tree.physics_frame
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	if p_sends:
		ragdoll.push_sample(time_s, p_pose, p_told)
	ragdoll.drive(time_s, delta)
	time_s += delta


## A floor, 200 m long, that rises along +Z by an angle, rad. It passes through the origin.
static func make_floor(p_angle: float, p_width: float = 60.0) -> Block:
	var block: Block = Block.new()
	block.size = Vector3(p_width, 4.0, 200.0)
	block.basis = Basis(Vector3.RIGHT, -p_angle)
	block.position = block.basis * Vector3(0.0, -2.0, 0.0)
	return block


func add_floor(p_angle: float, p_width: float = 60.0) -> void:
	world.add_child(make_floor(p_angle, p_width))


## Rough ground: hills and hollows of an amplitude (m), 3 m apart.
func add_bumps(p_amplitude: float) -> void:
	var shape: HeightMapShape3D = HeightMapShape3D.new()
	shape.map_width = 65
	shape.map_depth = 65
	var heights: PackedFloat32Array = []
	for z: int in 65:
		for x: int in 65:
			heights.append(p_amplitude * sin(x * TAU / 6.0) * sin(z * TAU / 6.0))
	shape.map_data = heights
	var owner: CollisionShape3D = BenchBodies.collision(shape)
	# Half a metre a cell: waves of 3 m.
	owner.scale = Vector3(0.5, 1.0, 0.5)
	owner.position = Vector3(0.0, 0.0, 12.0)
	var ground: StaticBody3D = StaticBody3D.new()
	ground.add_child(owner)
	world.add_child(ground)


func add_crate(p_size: Vector3, p_place: Vector3, p_mass: float) -> RigidBody3D:
	var crate: RigidBody3D = RigidBody3D.new()
	crate.mass = p_mass
	crate.collision_layer = _CRATE_LAYER
	crate.collision_mask = 0xFFFFFFFF
	crate.position = p_place
	crate.add_child(BenchBodies.box(p_size))
	world.add_child(crate)
	return crate


## Height of what is under a place, m; NaN for nothing.
func ground_under(p_place: Vector3) -> float:
	var query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		p_place, p_place + Vector3.DOWN * 30.0, _GROUND_MASK, ragdoll.get_bodies()
	)
	var hit: Dictionary = world.get_world_3d().direct_space_state.intersect_ray(query)
	return (hit["position"] as Vector3).y if hit.has("position") else NAN


## How far the body's lowest point is above what is under it, m; INF over nothing.
func clearance() -> float:
	var least: float = INF
	for i: int in ragdoll.profile.limbs.size():
		var limb: RagdollLimb = ragdoll.profile.limbs[i]
		for point: Vector3 in limb.contact_points:
			var local: Vector3 = limb.rest_orientation.inverse() * (point - limb.anchor)
			var place: Vector3 = point_of(ragdoll, i, local)
			var ground: float = ground_under(place + Vector3.UP * 0.05)
			if is_finite(ground):
				least = minf(least, place.y - limb.contact_radius - ground)
	return least


## Mean angle between the limbs and the motion, degrees.
func pose_error_deg() -> float:
	var sum: float = 0.0
	var errors: PackedFloat32Array = ragdoll.motor.get_limb_errors()
	for error: float in errors:
		sum += rad_to_deg(error)
	return sum / maxi(errors.size(), 1)


## How far the root is from where it shall be, m.
func target_distance() -> float:
	return ragdoll.motor.get_root_target().distance_to(root_of(ragdoll))


## Where a point of a limb's frame is, by the limb's body.
static func point_of(p_ragdoll: Ragdoll, p_limb: int, p_local: Vector3) -> Vector3:
	var limb: RagdollLimb = p_ragdoll.profile.limbs[p_limb]
	var body: Transform3D = PhysicsServer3D.body_get_state(
		p_ragdoll.get_bodies()[p_limb], PhysicsServer3D.BODY_STATE_TRANSFORM
	)
	var centre: Vector3 = limb.rest_orientation.inverse() * (limb.position - limb.anchor)
	return body * (p_local - centre)


static func root_of(p_ragdoll: Ragdoll) -> Vector3:
	return point_of(p_ragdoll, 0, Vector3.ZERO)


## The ball of a foot: the middle of its second and third contact points.
static func ball_of(p_ragdoll: Ragdoll, p_side: int) -> Vector3:
	var foot: RagdollLimb = p_ragdoll.profile.find(&"LeftFoot" if p_side < 0 else &"RightFoot")
	var ball: Vector3 = (foot.contact_points[1] + foot.contact_points[2]) / 2.0
	var local: Vector3 = foot.rest_orientation.inverse() * (ball - foot.anchor)
	return point_of(p_ragdoll, p_ragdoll.profile.limbs.find(foot), local)


## Whether what this root mode does is measured against goals.
func has_goals() -> bool:
	return root_mode == RagdollMotor.ROOT_INERTIAL


## Notes how fast balls of feet move that stand still in truth; where they were before is kept.
func note_skate(
	p_walker: Walker, p_time_s: float, p_stats: Stats, r_before: Dictionary[int, Vector3]
) -> void:
	for side: int in [-1, 1]:
		var ball: Vector3 = ball_of(ragdoll, side)
		if r_before.has(side) and p_walker.is_standing(side, p_time_s):
			var moved: Vector3 = ball - r_before[side]
			p_stats.skate.add(Vector2(moved.x, moved.z).length() * Engine.physics_ticks_per_second)
		r_before[side] = ball


## Turns every limb of a pose at random, by a standard deviation in degrees.
static func add_noise(
	p_sample: PoseSample, p_degrees: float, p_random: RandomNumberGenerator
) -> void:
	for limb: int in Limbs.COUNT if p_degrees > 0.0 else 0:
		var axis: Vector3 = Vector3(p_random.randfn(), p_random.randfn(), p_random.randfn())
		var turn: Quaternion = Quaternion(axis.normalized(), axis.length() * deg_to_rad(p_degrees))
		p_sample.set_orientation(limb, p_sample.orientation(limb) * turn)

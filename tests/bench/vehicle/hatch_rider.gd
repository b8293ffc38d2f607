class_name HatchRider
extends RefCounted
## Somebody on the server who plays a motion, in or on a vehicle, and what comes of it.

## A server's session; nobody else is there.
const SESSION: int = 7
const START_USEC: int = 1780000000000000
## Limbs above the legs without the hips: the upper body.
const UPPER: Array[int] = [1, 2, 3, 4, 5, 6, 7, 8, 9]

## A limb that the seat turns by less than this is as the wearer has it, degrees.
const SAME_DEG: float = 1.0

## The body.
var person: ServerPerson = null
## Server side of people.
var people: ServerPeople = null
## Angle between the upper body and its motion, and how often measured.
var error_sum_deg: float = 0.0
var error_count: int = 0
## Angle between the upper body and what the wearer's limbs did in truth.
var raw_sum_deg: float = 0.0
## The same of the limbs that the hatch left as the wearer had them, and how many these were.
var free_sum_deg: float = 0.0
var free_count: int = 0
## Largest distance of the hips from the middle of the seat, m, lowest and highest above it.
var hips_across: float = 0.0
var hips_lowest: float = INF
var hips_highest: float = -INF
## Deepest that a limb that meets the vehicle was in it, m.
var deepest: float = 0.0
## Fastest that a limb was against the vehicle, m/s.
var fastest: float = 0.0

var _vehicle: Vehicle = null
var _source: BvhSource = null
var _pose: PoseSample = null
var _tick: int = 0
var _order: PackedInt32Array = []
var _errors: PackedFloat32Array = []
var _query: PhysicsShapeQueryParameters3D = PhysicsShapeQueryParameters3D.new()


func _init(p_ground: VehicleGround, p_vehicle: Vehicle, p_at: Transform3D) -> void:
	_vehicle = p_vehicle
	people = ServerPeople.new()
	people.scene = load("res://scenes/actor/soldier.tscn")
	people.root_mode = RagdollMotor.ROOT_GROUNDED
	p_ground.view.add_child(people)
	people.setup(EntityTable.new())
	people.enter([p_at])
	people.set_people(SESSION, [PersonCard.of("Ada", 1.0115)], "Ada")
	people.settle()
	person = people.list()[0]
	_order = person.ragdoll.get_limb_order()
	_query.collision_mask = PhysicsLayers.PROPS


## Plays a clip from now on; an empty path: stands.
func play(p_path: String) -> void:
	_source = null
	if p_path != "":
		_source = BvhSource.new()
		_source.open(p_path)
		person.scale = person.ragdoll.get_hip_height() / _source.get_hip_height()


## Holds a pose from now on.
func hold(p_pose: PoseSample) -> void:
	_pose = p_pose


## Before a step.
func drive() -> void:
	var now_s: float = 1000.0 + _tick / 60.0
	var sample: PoseSample = _sample()
	sample.id = _tick
	sample.time_usec = START_USEC + roundi(_tick * 1e6 / 60.0)
	_tick += 1
	people.push_sample(SESSION, sample, now_s)
	people.drive(now_s, 1.0 / 60.0)
	# Now, as the state that is compared is that of the beginning of the step.
	_errors = person.ragdoll.motor.get_limb_errors()


## After a step.
func measure() -> void:
	people.measure()


## Notes what the last step did.
func note() -> void:
	_note_truth()
	for limb: int in UPPER:
		var error: float = rad_to_deg(_errors[_order[limb]])
		error_sum_deg += error
		error_count += 1
	if person.sitting != null:
		var hips: Vector3 = person.sitting.hips_in_seat()
		hips_across = maxf(hips_across, Vector2(hips.x, hips.z).length())
		hips_lowest = minf(hips_lowest, hips.y)
		hips_highest = maxf(hips_highest, hips.y)
	_note_depth()


## Mean angle of the upper body to what the wearer did, whether or not there was room, degrees.
func raw_deg() -> float:
	return raw_sum_deg / maxi(error_count, 1)


## The same of limbs for which the hatch had room, degrees.
func free_deg() -> float:
	return free_sum_deg / maxi(free_count, 1)


## The part of all limbs for which it had, in percent.
func free_share() -> float:
	return 100.0 * free_count / maxi(error_count, 1)


## Mean angle of the upper body to its motion, degrees.
func mean_deg() -> float:
	return error_sum_deg / maxi(error_count, 1)


## Forgets what was measured.
func forget() -> void:
	error_sum_deg = 0.0
	raw_sum_deg = 0.0
	free_sum_deg = 0.0
	free_count = 0
	error_count = 0
	hips_across = 0.0
	hips_lowest = INF
	hips_highest = -INF
	deepest = 0.0
	fastest = 0.0


func hips() -> Vector3:
	var state: Transform3D = PhysicsServer3D.body_get_state(
		person.ragdoll.get_bodies()[0], PhysicsServer3D.BODY_STATE_TRANSFORM
	)
	return state.origin


func _sample() -> PoseSample:
	var sample: PoseSample = PoseSample.new()
	if _source != null:
		return _source.pose_at(_tick / 60.0)
	for limb: int in Limbs.COUNT:
		sample.set_orientation(limb, Quaternion.IDENTITY)
	sample.root = Vector3(0.0, 1.0115, 0.0)
	if _pose != null:
		sample.orientations = _pose.orientations.duplicate()
		sample.root = _pose.root
	return sample


## Against the sample as it came, in the frame of the seat.
func _note_truth() -> void:
	if person.newest == null:
		return
	var frame: Quaternion = person.ragdoll.motor.get_frame().basis.get_rotation_quaternion()
	var limbs: Array[RagdollLimb] = person.ragdoll.profile.limbs
	var fitted: PoseSample = person.newest
	if person.sitting != null:
		fitted = person.sitting.fit(person.newest)
	for limb: int in UPPER:
		var index: int = _order[limb]
		var state: Transform3D = PhysicsServer3D.body_get_state(
			person.ragdoll.get_bodies()[index], PhysicsServer3D.BODY_STATE_TRANSFORM
		)
		var wanted: Quaternion = frame * person.newest.orientation(limb)
		wanted = wanted * limbs[index].reset_orientation
		var off: float = rad_to_deg(wanted.angle_to(state.basis.get_rotation_quaternion()))
		raw_sum_deg += off
		var turned: float = fitted.orientation(limb).angle_to(person.newest.orientation(limb))
		if rad_to_deg(turned) < SAME_DEG:
			free_sum_deg += off
			free_count += 1


func _note_depth() -> void:
	var space: PhysicsDirectSpaceState3D = _vehicle.get_world_3d().direct_space_state
	var bodies: Array[RID] = person.ragdoll.get_bodies()
	var wheels: Array[RID] = _vehicle.wheel_bodies()
	_query.exclude = wheels
	for limb: int in UPPER:
		var body: RID = bodies[_order[limb]]
		var at: Transform3D = PhysicsServer3D.body_get_state(
			body, PhysicsServer3D.BODY_STATE_TRANSFORM
		)
		_query.shape_rid = PhysicsServer3D.body_get_shape(body, 0)
		_query.transform = at * PhysicsServer3D.body_get_shape_transform(body, 0)
		var points: PackedVector3Array = space.collide_shape(_query, 8)
		for pair: int in range(0, points.size(), 2):
			var depth: float = points[pair].distance_to(points[pair + 1])
			deepest = maxf(deepest, depth)
		var state: PhysicsDirectBodyState3D = PhysicsServer3D.body_get_direct_state(body)
		fastest = maxf(fastest, (state.linear_velocity - _vehicle.linear_velocity).length())

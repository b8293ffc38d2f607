class_name ShellHits
extends RefCounted
## Applies hits and blasts to bodies and people: impulses at the point of impact, within plausible
## limits.

## Greatest speed that one hit gives to a body, m/s: a real shell would go through a light one.
const MAX_GAIN: float = 12.0
## Greatest angular speed that one hit gives to a body, rad/s.
const MAX_SPIN: float = 15.0
## Greatest speed that one hit gives to a limb, m/s.
const MAX_LIMB_GAIN: float = 10.0
## Impulse that makes a person fall, N s; of a burst, the sum over all limbs.
const _FALL_IMPULSE: float = 80.0
## What the hit limb's group has left of its strength, and how long until all is back (s): for a
## bullet, and for what fells.
const _FLINCH: Vector2 = Vector2(0.1, 0.7)
const _FELLED: Vector2 = Vector2(0.02, 2.0)
## Mean density by which a body's mass gives its area, as its shape is not looked at, kg/m^3.
const _DENSITY: float = 500.0
## Distance below which a blast grows no further, m.
const _MIN_DISTANCE_M: float = 0.5
## Depth in the tree, in nodes below the person, down to which limbs are found.
const _MAX_DEPTH: int = 8
## Most bodies and limbs that a blast pushes.
const _MAX_BODIES: int = 256


## Pushes what is there at a point, in N s and m of the world. What does not move, or is freed, does
## nothing.
static func push(p_body: Variant, p_impulse: Vector3, p_point: Vector3) -> void:
	if not is_instance_valid(p_body) or not (p_impulse.is_finite() and p_point.is_finite()):
		return
	if p_body is PhysicalBone3D:
		push_limb(p_body as PhysicalBone3D, p_impulse, p_point)
	elif p_body is RigidBody3D:
		push_thing(p_body as RigidBody3D, p_impulse, p_point)


## Pushes a rigid body, which gains neither too much speed nor too much spin.
static func push_thing(p_body: RigidBody3D, p_impulse: Vector3, p_point: Vector3) -> void:
	var state: PhysicsDirectBodyState3D = PhysicsServer3D.body_get_direct_state(p_body.get_rid())
	if p_body.freeze or state == null or p_impulse.is_zero_approx():
		return
	# The offset of the middle is in the world's axes.
	var arm: Vector3 = p_point - state.transform.origin - state.center_of_mass
	var gain: float = p_impulse.length() * state.inverse_mass
	var spin: float = (state.inverse_inertia_tensor * arm.cross(p_impulse)).length()
	var share: float = minf(1.0, minf(MAX_GAIN / maxf(gain, 1e-6), MAX_SPIN / maxf(spin, 1e-6)))
	p_body.apply_impulse(p_impulse * share, p_point - p_body.global_position)


## Hits a person's limb: the person flinches, or falls.
## [param p_together] is what the whole person gets, N s, where that is more.
static func push_limb(
	p_limb: PhysicalBone3D, p_impulse: Vector3, p_point: Vector3, p_together: float = 0.0
) -> void:
	var motor: RagdollMotor = motor_of(p_limb)
	if motor == null:
		return
	var mass: float = PhysicsServer3D.body_get_param(
		p_limb.get_rid(), PhysicsServer3D.BODY_PARAM_MASS
	)
	var given: Vector3 = p_impulse.limit_length(MAX_LIMB_GAIN * mass)
	var weight: float = maxf(p_impulse.length(), p_together)
	var flinch: Vector2 = _FLINCH if weight < _FALL_IMPULSE else _FELLED
	motor.hit(given, p_point, flinch.x, flinch.y)


## What moves a person, of whom a limb is known; null where nobody does.
static func motor_of(p_limb: Node) -> RagdollMotor:
	var node: Node = p_limb.get_parent()
	for _level: int in _MAX_DEPTH:
		if node == null:
			return null
		for child: Node in node.get_children():
			if child is RagdollMotor:
				return child
		node = node.get_parent()
	return null


## Bursts at a position: pushes all that it sees, less with distance, and pierces thin vehicles.
static func burst(
	p_space: PhysicsDirectSpaceState3D, p_place: Vector3, p_ammunition: Ammunition
) -> void:
	var sphere: SphereShape3D = SphereShape3D.new()
	sphere.radius = p_ammunition.blast_radius
	var query: PhysicsShapeQueryParameters3D = PhysicsShapeQueryParameters3D.new()
	query.shape = sphere
	query.transform.origin = p_place
	query.collision_mask = PhysicsLayers.PEOPLE | PhysicsLayers.PROPS
	var pushed: Dictionary[Object, bool] = {}
	var people: Dictionary[RagdollMotor, Array] = {}
	for found: Dictionary in p_space.intersect_shape(query, _MAX_BODIES):
		var body: CollisionObject3D = found["collider"] as CollisionObject3D
		if body == null or pushed.has(body):
			continue
		pushed[body] = true
		var given: Array[Vector3] = _find_push(p_space, p_place, p_ammunition, body)
		var motor: RagdollMotor = motor_of(body) if body is PhysicalBone3D else null
		if given.is_empty():
			continue
		if motor == null:
			push(body, given[0], given[1])
			_pierce(body, given, p_ammunition, p_place)
		else:
			people.get_or_add(motor, []).append([body, given[0], given[1]])
	for motor: RagdollMotor in people:
		_push_person(people[motor])


## Limbs of one person, each with its impulse and position.
static func _push_person(p_limbs: Array) -> void:
	var together: float = 0.0
	for limb: Array in p_limbs:
		together += (limb[1] as Vector3).length()
	for limb: Array in p_limbs:
		push_limb(limb[0], limb[1], limb[2], together)


static func _pierce(
	p_body: Object, p_given: Array[Vector3], p_ammunition: Ammunition, p_place: Vector3
) -> void:
	var is_near: bool = p_place.distance_to(p_given[1]) < 0.5 * p_ammunition.blast_radius
	var armour: Armour = Armour.find_in(p_body as Node) if is_near and p_body is Node else null
	if armour != null:
		armour.take_fragments(p_ammunition, p_given[0].normalized(), p_given[1])


## Impulse and position of what a burst gives to a body; empty where it does not reach it.
static func _find_push(
	p_space: PhysicsDirectSpaceState3D,
	p_place: Vector3,
	p_ammunition: Ammunition,
	p_body: CollisionObject3D
) -> Array[Vector3]:
	var state: PhysicsDirectBodyState3D = PhysicsServer3D.body_get_direct_state(p_body.get_rid())
	if state == null:
		return []
	var middle: Vector3 = state.transform.origin + state.center_of_mass
	# Who stands behind a wall or a crate is spared; a limb does not shield the next.
	var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		p_place, middle, PhysicsLayers.STATIC | PhysicsLayers.PROPS
	)
	var between: Dictionary = p_space.intersect_ray(ray)
	if not between.is_empty() and between["collider"] != p_body:
		return []
	var point: Vector3 = between["position"] if not between.is_empty() else middle
	var away: float = p_place.distance_to(point)
	var share: float = 1.0 - away / p_ammunition.blast_radius
	var ahead: Vector3 = (middle - p_place).normalized()
	if share <= 0.0 or not ahead.is_normalized():
		return []
	var area: float = pow(1.0 / maxf(state.inverse_mass, 1e-6) / _DENSITY, 2.0 / 3.0)
	var impulse: float = p_ammunition.blast_impulse * area * share / maxf(away, _MIN_DISTANCE_M)
	return [ahead * impulse, point]

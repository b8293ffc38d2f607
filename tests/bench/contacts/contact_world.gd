class_name ContactWorld
extends SubViewport
## A physics world of its own, made after the project settings of a case were set, in which people
## are driven through simulated time in fixed steps.

## Who plays.
var people: Array[ContactPerson] = []
## Simulated time, s.
var time_s: float = 0.0
## Length of a step, s.
var delta_s: float = 1.0 / 60.0
## Widest gap of any joint so far, m.
var widest_gap: float = 0.0


func _init(p_hz: int) -> void:
	own_world_3d = true
	render_target_update_mode = SubViewport.UPDATE_DISABLED
	delta_s = 1.0 / p_hz


## Adds somebody and starts the ragdoll. The motion is given as in [ContactPerson].
func add_person(p_person: ContactPerson, p_pose: Callable, p_place: Callable) -> void:
	p_person.pose = p_pose
	p_person.place = p_place
	p_person.ragdoll.start()
	people.append(p_person)


## Adds somebody who holds a pose, the hips at a place.
func add_standing(p_person: ContactPerson, p_pose: PoseSample, p_hips: Vector3) -> void:
	add_person(
		p_person,
		func(_time: float) -> PoseSample: return p_pose,
		func(_time: float) -> Vector3: return p_hips
	)


## A static box.
func add_block(p_size: Vector3, p_place: Transform3D, p_friction: float = 1.0) -> StaticBody3D:
	var block: StaticBody3D = StaticBody3D.new()
	block.physics_material_override = _material(p_friction)
	block.transform = p_place
	_add(block, BenchBodies.box(p_size))
	return block


## A wide floor at a height.
func add_floor(p_height: float) -> void:
	add_block(Vector3(40.0, 1.0, 40.0), Transform3D(Basis(), Vector3(0.0, p_height - 0.5, 0.0)))


## A free box, such as a crate.
func add_crate(p_size: Vector3, p_place: Vector3, p_mass: float) -> RigidBody3D:
	return _add_free(BenchBodies.box(p_size), p_place, p_mass)


## A free ball.
func add_ball(p_radius: float, p_place: Vector3, p_mass: float) -> RigidBody3D:
	return _add_free(BenchBodies.ball(p_radius), p_place, p_mass)


## Lets time pass; calls [param p_after], if given, after each step, and may return true to stop.
func run(p_seconds: float, p_after: Callable = Callable()) -> void:
	if time_s == 0.0:
		await get_tree().physics_frame
	for _step: int in roundi(p_seconds / delta_s):
		for person: ContactPerson in people:
			var pose: PoseSample = person.pose.call(time_s)
			var place: Vector3 = person.place.call(time_s)
			person.ragdoll.push_sample(time_s, pose, place)
			person.ragdoll.drive(time_s, delta_s)
		# The step follows this signal, and the next one follows the step.
		await get_tree().physics_frame
		time_s += delta_s
		for person: ContactPerson in people:
			widest_gap = maxf(widest_gap, person.gap(person.bodies()))
		if p_after.is_valid() and p_after.call():
			return


func _add_free(p_shape: CollisionShape3D, p_place: Vector3, p_mass: float) -> RigidBody3D:
	var body: RigidBody3D = RigidBody3D.new()
	body.mass = p_mass
	body.position = p_place
	body.continuous_cd = true
	body.can_sleep = false
	body.collision_layer = PhysicsLayers.PROPS
	body.collision_mask = PhysicsLayers.ALL
	_add(body, p_shape)
	return body


func _add(p_body: PhysicsBody3D, p_shape: CollisionShape3D) -> void:
	p_body.add_child(p_shape)
	add_child(p_body)


static func _material(p_friction: float) -> PhysicsMaterial:
	var material: PhysicsMaterial = PhysicsMaterial.new()
	material.friction = p_friction
	return material

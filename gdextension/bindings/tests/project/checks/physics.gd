extends CheckSuite
## A motor's work: direct states, torques and joints on the physics server.


func run() -> void:
	var upper := _body(Vector3.ZERO)
	var probe := BodyProbe.new()
	var bodies: Array[RID] = [upper.get_rid()]
	probe.set_bodies(bodies)
	add_child(probe)
	for i in 30:
		await get_tree().physics_frame
	check("_physics_process", probe.get_ticks() >= 28, probe.get_ticks())
	check("body fell", probe.get_height() < -0.3, probe.get_height())
	check("torque turned it", upper.angular_velocity.y > 0.01, upper.angular_velocity)
	var lower := _body(upper.position + Vector3(0, 2, 0))
	var joint := probe.join(upper.get_rid(), lower.get_rid())
	check(
		"joint",
		(
			joint.is_valid()
			and PhysicsServer3D.joint_get_type(joint) == PhysicsServer3D.JOINT_TYPE_6DOF
		)
	)
	PhysicsServer3D.free_rid(joint)
	var nanoseconds := probe.time_state_ns(1000)
	print("state, transform and velocity of a body: %.0f ns" % nanoseconds)
	check("calls are quick", nanoseconds > 0.0 and nanoseconds < 2000.0, nanoseconds)
	probe.free()


func _body(at: Vector3) -> RigidBody3D:
	var body := RigidBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = SphereShape3D.new()
	body.add_child(shape)
	body.position = at
	body.can_sleep = false
	add_child(body)
	return body

# SPDX-License-Identifier: MIT
extends Node
## Objects: references, wrappers, virtual methods, notifications, the engine's singletons.


## Runs the checks.
func run(checks: Checks) -> void:
	_check_references(checks)
	_check_churn(checks)
	await _check_nodes(checks)
	await _check_physics(checks)


func _check_references(checks: Checks) -> void:
	var probe := BindingsProbe.new()
	checks.equal("one alive", BindingsProbe.alive_count(), 1)
	probe.gain = 2.5
	var child := probe.make_child()
	checks.that("child", child.get_class() == "BindingsProbe" and child.gain == 5.0, child.gain)
	checks.equal("references to the child", child.get_reference_count(), 1)
	checks.equal("two alive", BindingsProbe.alive_count(), 2)
	child = null
	checks.equal("child is freed", BindingsProbe.alive_count(), 1)
	checks.that("hold", probe.hold(probe) == probe)
	checks.equal("references when held", probe.get_reference_count(), 2)
	probe.release()
	checks.equal("references when released", probe.get_reference_count(), 1)
	checks.that("hold null", probe.hold(null) == null)
	var many := probe.make_many(1000)
	checks.that("many", many.size() == 1000 and many[999].gain == 999.0, many.size())
	checks.equal("many alive", BindingsProbe.alive_count(), 1001)
	many.clear()
	checks.equal("many freed", BindingsProbe.alive_count(), 1)
	var called: Variant = probe.call_back(func(a: int, b: String) -> String: return b + str(a))
	checks.equal("callable from a script", called, "a3")


func _check_churn(checks: Checks) -> void:
	var before := OS.get_static_memory_usage()
	var keeper := BindingsProbe.new()
	for i: int in 20_000:
		var probe := BindingsProbe.new()
		probe.gain = 1.0
		keeper.echo("text %d" % i)
		keeper.make_many(2)
	checks.equal("alive after churn", BindingsProbe.alive_count(), 1)
	var grown := OS.get_static_memory_usage() - before
	checks.that("memory after churn", grown < 100_000, grown)


func _check_nodes(checks: Checks) -> void:
	var node := BindingsNode.new()
	add_child(node)
	checks.equal("_notification", node.get_enter_count(), 1)
	checks.equal("_ready", node.get_ready_count(), 1)
	node.spawn(9)
	checks.equal("kinds of children", node.kinds_of_children(), 231_231_231)
	checks.equal("class of an engine node", node.get_child(2).get_class(), "Node3D")
	var heir: BindingsNodeHeir = node.get_child(1)
	checks.that("object as a result", node.child_object(1) == heir)
	checks.equal("null as an argument", node.kind(null), 0)
	checks.equal("engine node as an argument", node.kind(self), 1)
	checks.that("itself as an argument", node.is_me(node) and not node.is_me(self))
	checks.equal("callable from C++", node.own_callable().call(), 1)
	checks.equal("inherited _notification", heir.get_enter_count(), 1)
	checks.equal("inherited _ready", heir.get_ready_count(), 1)
	await get_tree().process_frame
	await get_tree().process_frame
	checks.that("_process", heir.get_frame_count() >= 1, heir.get_frame_count())
	node.free()
	checks.that("children are freed", not is_instance_valid(heir))


func _check_physics(checks: Checks) -> void:
	var body := RigidBody3D.new()
	var collision := CollisionShape3D.new()
	collision.shape = SphereShape3D.new()
	body.add_child(collision)
	add_child(body)
	var driver := BindingsDriver.new()
	driver.add_body(body.get_rid())
	add_child(driver)
	for i: int in 30:
		await get_tree().physics_frame
	checks.that("_physics_process", driver.get_tick_count() >= 28, driver.get_tick_count())
	checks.that("the body fell", driver.get_height() < -0.3, driver.get_height())
	checks.that("the body turns", body.angular_velocity.y > 0.01, body.angular_velocity)
	var other: RigidBody3D = body.duplicate()
	other.position = Vector3(0, 2, 0)
	add_child(other)
	var joint := driver.add_joint(body.get_rid(), other.get_rid())
	var parameter := PhysicsServer3D.G6DOF_JOINT_ANGULAR_MOTOR_TARGET_VELOCITY
	var speed := PhysicsServer3D.generic_6dof_joint_get_param(joint, Vector3.AXIS_Y, parameter)
	checks.equal("enum arguments of the engine", speed, 1.5)
	PhysicsServer3D.free_rid(joint)
	driver.free()

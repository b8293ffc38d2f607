extends TestCase
## The examples work as their README says, also without a server.

const DOOR: PackedScene = preload("res://examples/01_door/01_door.tscn")
const TURNTABLE: PackedScene = preload("res://examples/02_turntable/02_turntable.tscn")
const BELL: PackedScene = preload("res://examples/04_bell/04_bell.tscn")
const HEALTH: PackedScene = preload("res://examples/03_health/03_health.tscn")


func test_a_door_opens_closes_and_slams() -> void:
	var scene: Node = DOOR.instantiate()
	add_child(scene)
	await process_frames(2)
	var entity: Entity = Entity.find_in(scene)
	var events: Array[StringName] = []
	entity.happened.connect(
		func(event: StringName, _values: PackedFloat32Array) -> void: events.append(event)
	)
	var button: Interactable = scene.find_children("*", "Marker3D", true, false)[0]
	button.interact()
	await until(func() -> bool: return entity.get_value(&"opening") == 1.0)
	var leaf: Node3D = scene.get_node(^"Thing/Leaf")
	almost_equal(leaf.position.x, 1.4, 0.01)
	equal(events, [] as Array[StringName])
	button.interact()
	await until(func() -> bool: return entity.get_value(&"opening") == 0.0)
	equal(events, [&"slammed"] as Array[StringName])
	scene.free()


func test_a_turntable_is_taken_steered_and_left() -> void:
	var scene: Node = TURNTABLE.instantiate()
	add_child(scene)
	await process_frames(2)
	var entity: Entity = Entity.find_in(scene)
	var seat: Seat = scene.get_node(^"Thing/Disc/Seat")
	equal(seat.get_prompt(), "take the seat and steer")
	seat.interact()
	is_true(seat.is_mine())
	equal(seat.get_prompt(), "leave")
	entity.send_command(&"steer", [1.0])
	var disc: Node3D = scene.get_node(^"Thing/Disc")
	await until(func() -> bool: return disc.rotation.y > 0.2)
	seat.interact()
	equal(seat.occupant(), 0)
	await until(func() -> bool: return entity.get_value(&"speed") == 0.0)
	scene.free()


func test_a_bell_rings() -> void:
	var scene: Node = BELL.instantiate()
	add_child(scene)
	await process_frames(2)
	var bell: Node = scene.get_node(^"Shared/Bell")
	var rings: Array[String] = []
	bell.rung.connect(rings.append)
	(scene.get_node(^"Shared/Bell/Button") as Interactable).interact()
	await until(func() -> bool: return bell.count == 1)
	equal(rings, ["the server"] as Array[String], "this machine is the server")
	equal(bell.get_node(^"Board").get_child_count(), 1)
	scene.free()


func test_a_thrown_crate_lowers_health() -> void:
	var scene: Node = HEALTH.instantiate()
	var person: Ragdoll = scene.get_node(^"Thing")
	person.get_node(^"Health").set(&"has_label", true)
	add_child(scene)
	await process_frames(2)
	var entity: Entity = person.get_node(^"Entity")
	equal(entity.get_value(&"health"), 100.0)
	is_false(person.get_node(^"Health").is_processing(), "there is no bar to be moved")
	is_true(person.start())
	person.root_mode = RagdollMotor.ROOT_HELD
	var crate: RigidBody3D = preload("res://scenes/world/props/crate.tscn").instantiate()
	crate.position = Vector3(0.0, 1.3, 2.0)
	crate.linear_velocity = Vector3(0.0, 0.0, -12.0)
	scene.add_child(crate)
	await until(func() -> bool: return entity.get_value(&"health") < 100.0)
	var bar: Label3D = person.get_node(^"Health").get_child(0)
	is_true(bar.visible)
	await process_frames(1)
	var head: Vector3 = person.get_bone_transform(&"Head").origin
	almost_equal(bar.global_position.distance_to(head), 0.35, 0.05)
	entity.set_value(&"health", 100.0)
	is_false(bar.visible)
	is_false(person.get_node(^"Health").is_processing())
	scene.free()

## Waits for something in simulated time, for 6 s at most.

extends TestCase
## A torch is switched by whose hand it is in, shines where the hand is, costs nothing while off.

const PERSON: PackedScene = preload("res://scenes/actor/person.tscn")

var _stage: Node3D = null


func before_each() -> void:
	_stage = Node3D.new()


func after_each() -> void:
	_stage.free()


func test_the_wearer_switches_it() -> void:
	var torch: Torch = _add_torch(Vector3.ZERO)
	await _start()
	is_false(torch.is_lit(), "it is off until somebody switches it")
	is_false(torch.is_processing())
	equal(torch.get_child_count(), 0)
	var held: Array[bool] = []
	torch.held.connect(held.append)
	torch.ask()
	is_true(torch.is_lit())
	is_true(_light_of(torch).visible)
	torch.ask()
	is_false(torch.is_lit())
	is_false(torch.is_processing())
	await process_frames(1)
	equal(torch.get_child_count(), 0)
	equal(held, [true, false])


func test_nobody_else_switches_it() -> void:
	var torch: Torch = _add_torch(Vector3.ZERO)
	await _start()
	var entity: Entity = torch.get_node(^"../Entity")
	entity.take_command(7, entity.type.find_command(Torch.COMMAND), [])
	is_false(torch.is_lit())
	torch.switch(true)
	is_true(torch.is_lit(), "the server may")


func test_it_is_in_the_hand_and_lights_ahead() -> void:
	var torch: Torch = _add_torch(Vector3(3.0, 0.0, 2.0))
	var person: Ragdoll = torch.get_parent()
	person.rotation.y = 0.7
	await _start()
	torch.switch(true)
	await process_frames(2)
	var hand: Vector3 = person.get_bone_transform(&"RightHand").origin
	is_true(torch.global_position.distance_to(hand) < 0.12)
	var ahead: Vector3 = person.global_basis.z
	var beam: Vector3 = -_light_of(torch).global_basis.z
	is_true(rad_to_deg(beam.angle_to(ahead)) < 15.0)
	is_true(beam.y < 0.0, "to where one walks")


func test_only_the_nearest_light() -> void:
	var torches: Array[Torch] = []
	for number: int in Torch.MAX_LIGHTS + 2:
		torches.append(_add_torch(Vector3(0.0, 0.0, -3.0 * number)))
	var camera: Camera3D = Camera3D.new()
	_stage.add_child(camera)
	await _start()
	camera.make_current()
	for torch: Torch in torches:
		torch.switch(true)
	await process_frames(2)
	for number: int in torches.size():
		equal(_light_of(torches[number]).visible, number < Torch.MAX_LIGHTS, str(number))


func _start() -> void:
	_stage.add_child(LocalSession.new())
	add_child(_stage)
	await process_frames(2)


func _add_torch(p_at: Vector3) -> Torch:
	var person: Ragdoll = PERSON.instantiate()
	person.position = p_at
	_stage.add_child(person)
	var torch: Torch = person.get_node(^"Torch")
	torch.has_light = true
	return torch


func _light_of(p_torch: Torch) -> SpotLight3D:
	return p_torch.find_children("*", "SpotLight3D", true, false)[0]

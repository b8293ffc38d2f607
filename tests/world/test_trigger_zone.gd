extends TestCase
## A zone notices bodies that come and go, counts them, and says who it was.


## A program in which the zone's session is this machine, with bodies that have numbers.
class Host:
	extends LocalSession.Host
	var bodies: Dictionary[Node3D, int] = {}
	var names: Dictionary[int, String] = {}
	var sent: Array[Array] = []

	func send_event(_entity: int, p_event: int, p_values: PackedFloat32Array) -> void:
		sent.append([p_event, p_values[0]])

	func find_by_body(p_body: Node3D) -> int:
		return bodies.get(p_body, -1)

	func name_of(p_entity: int) -> String:
		return names.get(p_entity, "")


var _zone: TriggerZone = null
var _host: Host = null
var _heard: PackedStringArray = []


func before_each() -> void:
	_heard.clear()
	_host = Host.new()
	_zone = TriggerZone.new()
	_zone.name = "BackYard"
	_zone.notices = TriggerZone.Notices.THINGS
	add_child(_zone)
	_zone.notified.connect(func(text: String) -> void: _heard.append(text))
	_zone.entered.connect(func(id: int, who: String) -> void: _heard.append("+%d %s" % [id, who]))
	_zone.left.connect(func(id: int, who: String) -> void: _heard.append("-%d %s" % [id, who]))
	_host.names[2000] = "BackYard"


func after_each() -> void:
	_host.bodies.clear()
	for body: Node in get_children():
		body.free()


func test_what_comes_and_goes() -> void:
	_start()
	var crate: RigidBody3D = await _add_crate(Vector3(9.0, 0.0, 0.0), 1024)
	equal(_zone.count_things(), 0)
	await _move(crate, Vector3(1.0, 0.5, 1.0))
	equal(_heard, PackedStringArray(["+1024 Crate", "Crate entered Back Yard"]))
	equal([_zone.count_things(), _zone.count_people()], [1, 0])
	await _move(crate, Vector3(9.0, 0.0, 0.0))
	equal(_heard[-1], "Crate left Back Yard")
	equal(_zone.count_things(), 0)
	equal(_host.sent, [[0, 1024.0], [1, 1024.0]])


func test_what_was_there_before_the_session() -> void:
	await _add_crate(Vector3.UP, 1024)
	_start()
	equal(_heard, PackedStringArray(["+1024 Crate", "Crate entered Back Yard"]))


func test_what_is_freed_inside() -> void:
	_start()
	var crate: RigidBody3D = await _add_crate(Vector3.UP, 1024)
	_host.names.erase(1024)
	crate.free()
	await physics_frames(2)
	equal(_heard[-1], "Crate left Back Yard")
	equal(_zone.count_things(), 0)


func test_what_it_is_not_to_notice() -> void:
	_zone.notices = TriggerZone.Notices.PEOPLE
	_start()
	await _add_crate(Vector3.UP, 1024)
	equal(_heard, PackedStringArray())


func test_bodies_that_are_no_entities() -> void:
	_start()
	var crate: RigidBody3D = await _add_crate(Vector3(9.0, 0.0, 0.0), -1)
	await _move(crate, Vector3.UP)
	equal([_heard, _zone.count_things()], [PackedStringArray(), 0])
	# As a person's body, which is there before the person is.
	_host.bodies[crate] = 1024
	_host.names[1024] = "Ada"
	await physics_frames(2 * TriggerZone.AGAIN_TICKS)
	equal([_heard.size(), _zone.count_things()], [2, 1])
	await _move(crate, Vector3(9.0, 0.0, 0.0))
	equal(_heard[-1], "Ada left Back Yard")


func test_quiet_ones_still_signal() -> void:
	_zone.is_told = false
	_start()
	await _add_crate(Vector3.UP, 1024)
	equal(_heard, PackedStringArray(["+1024 Crate"]))


func test_its_shape() -> void:
	_zone.size = Vector3(4.0, 3.0, 6.0)
	equal(_zone.get_box(), AABB(Vector3(-2.0, 0.0, -3.0), Vector3(4.0, 3.0, 6.0)))
	_zone.form = TriggerZone.Form.CYLINDER
	equal(_zone.get_box(), AABB(Vector3(-2.0, 0.0, -2.0), Vector3(4.0, 3.0, 4.0)))
	_start()
	var crate: RigidBody3D = await _add_crate(Vector3(1.9, 1.0, 1.9), 1024)
	equal(_zone.count_things(), 0, "in the corner that a cylinder has not")
	await _move(crate, Vector3(0.0, 1.0, 1.9))
	equal(_zone.count_things(), 1)
	_zone.size = Vector3(-1.0, 0.0, 1.0)
	equal(_zone.size, Vector3(TriggerZone.MIN_M, TriggerZone.MIN_M, 1.0))


func test_warnings() -> void:
	equal(_zone._get_configuration_warnings(), PackedStringArray())
	_zone.notices = 0
	contains(_zone._get_configuration_warnings()[0], "switch on People or Things")
	_zone.scale.x = 2.0
	contains(_zone._get_configuration_warnings()[0], "set the scale to 1")


func test_names() -> void:
	equal(_zone.get_title(), "Back Yard")
	_zone.title = "the yard"
	equal(_zone.get_title(), "the yard")


func _start() -> void:
	var entity: Entity = Entity.find_in(_zone.get_child(1, true))
	entity.start(_host, 2000, entity.type.spawn_schema().defaults())


func _add_crate(p_at: Vector3, p_id: int) -> RigidBody3D:
	var crate: RigidBody3D = RigidBody3D.new()
	crate.freeze = true
	crate.freeze_mode = RigidBody3D.FREEZE_MODE_KINEMATIC
	crate.collision_layer = PhysicsLayers.PROPS
	crate.position = p_at
	var shape: CollisionShape3D = CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	(shape.shape as BoxShape3D).size = Vector3.ONE * 0.2
	crate.add_child(shape)
	_host.bodies[crate] = p_id
	_host.names[p_id] = "Crate"
	add_child(crate)
	await physics_frames(3)
	return crate


func _move(p_crate: RigidBody3D, p_at: Vector3) -> void:
	p_crate.global_position = p_at
	await physics_frames(3)

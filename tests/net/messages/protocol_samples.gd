extends RefCounted
## The messages of docs/protocol-bytes.md, made by the program: name to bytes.

const SnapshotStream: GDScript = preload("res://tests/wire/snapshot_stream.gd")


## All of them, in the order of the page.
static func all() -> Dictionary[String, PackedByteArray]:
	var made: Dictionary[String, PackedByteArray] = {}
	_add_joining(made)
	_add_world(made)
	_add_snapshots(made)
	_add_orders(made)
	return made


static func _add_joining(r_made: Dictionary[String, PackedByteArray]) -> void:
	var challenge: Challenge = Challenge.new()
	challenge.locked_roles = 4
	challenge.rounds = 2000
	challenge.salt = _count(16, 0x10)
	challenge.nonce = _count(32, 0x40)
	r_made["challenge"] = challenge.encode()
	var half: PersonCard = PersonCard.of("Ada", 0.95, 0)
	var whole: PersonCard = PersonCard.of("", 0.875, 3)
	half.avatar = "raider"
	for limb: int in Limbs.COUNT:
		whole.lengths.append(0.25 if limb % 2 == 0 else 0.0)
	r_made["people"] = PeopleMessage.encode([half, whole] as Array[PersonCard])
	r_made["clock-question"] = ClockMessage.question(123456789)
	r_made["clock-answer"] = ClockMessage.answer(
		r_made["clock-question"], 5000000001, 300000, 4999990000, 60
	)
	r_made["stats"] = StatsMessage.encode(18.4, 25.0, 1.7, 59.9)
	r_made["leave"] = PackedByteArray([Protocol.Message.LEAVE]) + _count(16, 0xA0)


static func _add_world(r_made: Dictionary[String, PackedByteArray]) -> void:
	r_made["level"] = LevelMessage.encode("yard", _count(8, 1))
	var request: LevelRequestMessage = LevelRequestMessage.new()
	request.number = 9
	request.content_hash = _count(32, 0x60)
	request.file = 2
	request.offset = 65536
	request.length = 65536
	r_made["level-request"] = request.encode()
	r_made["level-data"] = LevelDataMessage.encode(9, 65536, 200000, _count(4, 1))
	r_made["level-refused"] = LevelDataMessage.refuse(9, "gone")
	var table: EntityTable = EntityTable.new()
	var door: EntityRow = EntityRow.new()
	door.type = _door()
	door.source = EntityRow.Source.LEVEL
	door.path = "Props/Door/Entity"
	door.tick = 77
	table.spawn(door)
	r_made["table"] = EntityTableMessage.of_table(table, 0.1).encode()
	r_made["part"] = MessageParts.split(r_made["level"], 9)[0]
	var command: EntityCommand = EntityCommand.new()
	command.number = 513
	command.tick = 1200
	command.entity = door.id
	command.command = 0
	command.bytes = door.type.commands[0].encode([0.5])
	r_made["command"] = CommandMessage.encode([command] as Array[EntityCommand])
	var event: EntityEvent = EntityEvent.new()
	event.number = 7
	event.tick = 1201
	event.entity = door.id
	event.event = 0
	r_made["events"] = EventMessage.encode([event] as Array[EntityEvent])
	var impact: Impact = Impact.new()
	impact.entity = 1030
	impact.place = Vector3(1.5, 0.0, -2.0)
	impact.impulse = 10.24
	impact.material = 15
	impact.other_material = 4
	r_made["impacts"] = ImpactMessage.encode(1200, [impact] as Array[Impact])
	r_made["motion-set"] = MotionSetMessage.split(_count(4, 1), 12)[0]
	r_made["motion-set-refused"] = MotionSetMessage.answer(
		12, MotionSetMessage.Outcome.REFUSED, "this is no motion set"
	)


static func _add_snapshots(r_made: Dictionary[String, PackedByteArray]) -> void:
	var encoder: SnapshotEncoder = SnapshotEncoder.new()
	encoder.configure(PackedInt32Array(Limbs.PARENTS), Protocol.POSE_ERROR_DEG, 60)
	encoder.add_client(1, 0, 1e8)
	var decoder: SnapshotDecoder = SnapshotStream.decoder()
	for tick: int in [1000, 1001]:
		var limbs: PackedFloat32Array = []
		for limb: int in Limbs.COUNT:
			var turn: float = deg_to_rad(10.0 * (tick - 1000)) if limb == Limbs.HEAD else 0.0
			var rotation: Quaternion = Quaternion(Vector3.RIGHT, turn)
			limbs.append_array([rotation.x, rotation.y, rotation.z, rotation.w])
		encoder.begin_tick(tick)
		encoder.put_person(1, Vector3(0.25, 1.0, 0.02 * (tick - 1000)), limbs)
		var place: Transform3D = Transform3D(Basis.IDENTITY, Vector3(1.0, 0.5, -2.0))
		encoder.put_body(1024, place, Vector3.ZERO, Vector3.ZERO, true)
		encoder.end_tick()
		var datagram: PackedByteArray = encoder.encode(1, 0)[0]
		if tick == 1000:
			r_made["key"] = datagram
			decoder.decode(datagram)
			r_made["ack"] = decoder.get_ack(Vector3(0.0, 1.6, 3.0))
			encoder.take_ack(1, r_made["ack"])
		else:
			r_made["snapshot"] = datagram


static func _add_orders(r_made: Dictionary[String, PackedByteArray]) -> void:
	r_made["tell"] = NoticeMessage.tell("the server has room for 128 people")
	var order: OrderMessage = OrderMessage.new()
	order.number = 3
	order.kind = OrderMessage.Kind.KICK
	order.target = 12
	order.argument = "too loud"
	r_made["order"] = order.encode()
	r_made["answer"] = AnswerMessage.encode(3, AnswerMessage.Outcome.DONE, "Bob: kicked")
	var row: RosterRow = RosterRow.new()
	row.session = 12
	row.peer = 0x1234567
	row.role = Roles.Role.TRAINEE
	row.state = RosterRow.State.HERE
	row.name = "Zoë"
	row.address = "10.0.0.7"
	row.people = 1
	row.round_trip_ms = 2.5
	row.delay_ms = 18.4
	row.suit = "17 trackers on USB, calibrated"
	r_made["roster"] = RosterMessage.encode([row] as Array[RosterRow])
	r_made["wearer"] = WearerMessage.encode(5, false, "this motion comes calibrated")
	var call: CallMessage = CallMessage.new()
	call.number = 260
	call.path = "Bell"
	call.method = "paint"
	call.arguments = [Color(1.0, 0.5, 0.0), 3, "red", [true]]
	r_made["call"] = call.encode()
	r_made["refusal"] = RefusalMessage.encode(260, "a role of observer may not call 'paint'")


static func _door() -> EntityType:
	var opening: EntityField = EntityField.new()
	opening.name = &"opening"
	var speed: EntityField = EntityField.new()
	speed.name = &"speed"
	speed.resolution = 0.001
	var push: EntitySchema = EntitySchema.new()
	push.name = &"push"
	push.fields = [speed]
	var slam: EntitySchema = EntitySchema.new()
	slam.name = &"slammed"
	var type: EntityType = EntityType.new()
	type.name = &"door"
	type.fields = [opening]
	type.commands = [push]
	type.events = [slam]
	type.commanded_by = EntityType.CommandedBy.ANYBODY
	return type


static func _count(p_size: int, p_first: int) -> PackedByteArray:
	var bytes: PackedByteArray = []
	for index: int in p_size:
		bytes.append(p_first + index)
	return bytes

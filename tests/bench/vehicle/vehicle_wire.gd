class_name VehicleWire
extends VehicleCase
## What a vehicle costs on the wire at 30 snapshots a second: a tank that drives over bumps, steers
## and turns its turret all the time, and one that stands. Its body and its fields go through the
## server's encoder, with acknowledgements a round trip later.

const _HZ: int = 60
const _RATE: int = 30
const _SECONDS: int = 30
const _CLIENT: int = 1
const _ID: int = 2000
## Enough for all, bit/s.
const _BITS: float = 1e6
const _ROUND_TRIP: int = 5
const _GOAL_KBIT: float = 6.0


## Hands the fields of the only entity to an encoder.
class Host:
	extends SeatAuthority
	var encoder: SnapshotEncoder = SnapshotEncoder.new()
	var possessed: Possession = Possession.new()

	func session() -> int:
		return 0

	func set_field(p_entity: int, p_field: int, p_value: float) -> void:
		encoder.set_field(p_entity, p_field, p_value)

	func send_event(_entity: int, _event: int, _values: PackedFloat32Array) -> void:
		pass

	func send_command(_entity: int, _command: int, _values: PackedFloat32Array, _at: int) -> void:
		pass

	func possession() -> Possession:
		return possessed

	func attach(_session: int, _entity: int, _seat: SeatGeometry) -> void:
		pass

	func detach(_session: int) -> void:
		pass

	func carry(_limb: Node3D, _entity: int, _holds: bool) -> void:
		pass

	func put_down(_limb: Node3D, _entity: int) -> void:
		pass

	func refuse(_session: int, _why: String) -> void:
		pass

	func find_by_body(_body: Node3D) -> int:
		return -1

	func name_of(_entity: int) -> String:
		return ""


func run() -> void:
	for drives: bool in [true, false]:
		var sent: float = await _measure(drives)
		var what: String = "%s on %s %s" % [preset, gear, "driving" if drives else "standing"]
		var goal: float = _GOAL_KBIT if drives else 1.0
		report.at_most(what, "snapshots at %d Hz" % _RATE, sent, "kbit/s", goal)


## The payload of all datagrams, kbit/s.
func _measure(p_drives: bool) -> float:
	var ground: VehicleGround = flat_ground()
	ground.view.add_child(VehicleBumps.create())
	var vehicle: Vehicle = ground.add_vehicle(preset, kind)
	var host: Host = Host.new()
	var decoder: SnapshotDecoder = SnapshotDecoder.new()
	_set_up(host, decoder, vehicle)
	await ground.run(3.0)
	var acks: Array[PackedByteArray] = []
	var bytes: int = 0
	for tick: int in _SECONDS * _HZ:
		if p_drives:
			_drive(vehicle, float(tick) / _HZ)
		await ground.run(1.0 / _HZ)
		host.encoder.capture(1000 + tick)
		var datagrams: Array[PackedByteArray] = []
		host.encoder.encode_each([_CLIENT], 0, datagrams)
		for datagram: PackedByteArray in datagrams:
			bytes += datagram.size()
			decoder.decode(datagram)
		acks.append(decoder.get_ack(Vector3.ZERO))
		if acks.size() > _ROUND_TRIP:
			host.encoder.take_ack(_CLIENT, acks.pop_front())
	ground.free_all()
	return bytes * 8.0 / 1000.0 / _SECONDS


## Round and round at some 30 km/h, the turret to and fro.
static func _drive(p_vehicle: Vehicle, p_seconds: float) -> void:
	p_vehicle.input.throttle = 0.7 if VehicleGround.speed_of(p_vehicle) < 8.0 else 0.2
	p_vehicle.input.steer = 0.35 * sin(p_seconds * 0.9)
	var turret: VehicleTurret = p_vehicle.get_node_or_null(^"Turret") as VehicleTurret
	if turret != null:
		turret.aim = Vector2(sin(p_seconds * 0.6), 0.2 * sin(p_seconds * 1.7))


static func _set_up(p_host: Host, p_decoder: SnapshotDecoder, p_vehicle: Vehicle) -> void:
	var parents: PackedInt32Array = PackedInt32Array(Limbs.PARENTS)
	var entity: Entity = Entity.find_in(p_vehicle)
	var values: PackedFloat32Array = entity.type.spawn_schema().defaults()
	p_host.encoder.configure(parents, Protocol.POSE_ERROR_DEG, _HZ)
	p_decoder.configure(parents, Protocol.POSE_ERROR_DEG)
	entity.type.define(p_host.encoder.define_type, 1)
	entity.type.define(p_decoder.define_type, 1)
	p_host.encoder.add_entity(_ID, 1, values, 1)
	p_decoder.add_entity(_ID, 1, values)
	p_decoder.set_table_version(1)
	p_host.encoder.add_body(_ID, p_vehicle.get_rid())
	p_host.encoder.add_client(_CLIENT, _RATE, _BITS)
	entity.start(p_host, _ID, values)

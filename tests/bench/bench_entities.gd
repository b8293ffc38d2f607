extends Bench
## What the fields of entities cost: time to encode for many clients, to decode and to read; bytes
## of each field that changes, and of those that do not.
##
## Options: --entities=4000, --awake=500 (whose fields change in every tick), --clients=32,
## --seconds=4.

const HZ: int = 60
## The fast path's share of a 60 Hz tick that all clients together may take, ms.
const _GOAL_ENCODE_MS: float = 8.0
const _GOAL_DECODE_MS: float = 1.0
## Goal for a field that changes in every tick, in whole datagrams without ENet, UDP and IP.
const _GOAL_BYTES: float = 2.0
const _FIRST: int = 2000
const _KINDS: Array[int] = [0, 1, 2]
const _MINS: Array[float] = [-180.0, 0.0, 0.0]
const _MAXS: Array[float] = [180.0, 1.0, 7.0]
const _RESOLUTIONS: Array[float] = [0.1, 0.001, 1.0]
## Each client's share, bit/s: enough for all.
const _BITS: float = 2e7
## Ticks before an acknowledgement is back.
const _ROUND_TRIP: int = 4


func options() -> Dictionary:
	return {"entities": 4000, "awake": 500, "clients": 32, "seconds": 4.0}


func measure() -> void:
	var entities: int = option("entities")
	var awake: int = option("awake")
	_measure("nothing there", 0, 0)
	_measure("%d at rest" % entities, entities, 0)
	_measure("%d of %d change" % [awake, entities], entities, awake)


func _measure(p_case: String, p_entities: int, p_awake: int) -> void:
	var encoder: SnapshotEncoder = SnapshotEncoder.new()
	var decoder: SnapshotDecoder = SnapshotDecoder.new()
	var smoother: SnapshotSmoother = SnapshotSmoother.new()
	var clients: PackedInt32Array = _set_up(encoder, decoder, p_entities)
	var acks: Array[PackedByteArray] = []
	var encode_usec: int = 0
	var decode_usec: int = 0
	var read_usec: int = 0
	var bytes: int = 0
	var ticks: int = int(option("seconds") * HZ)
	for tick: int in ticks + HZ:
		for i: int in p_awake:
			encoder.set_field(
				_FIRST + i * p_entities / p_awake, 0, fmod(i + tick * 1.7, 360.0) - 180.0
			)
		encoder.begin_tick(1000 + tick)
		encoder.end_tick()
		var datagrams: Array[PackedByteArray] = []
		var begin: int = Time.get_ticks_usec()
		var receivers: PackedInt32Array = encoder.encode_each(clients, 0, datagrams)
		var encoded: int = Time.get_ticks_usec() - begin
		begin = Time.get_ticks_usec()
		var received: int = 0
		for i: int in datagrams.size():
			if receivers[i] == clients[0]:
				if decoder.decode(datagrams[i]) != SnapshotDecoder.OK:
					printerr("a datagram was not of use")
				smoother.take(decoder, tick / float(HZ))
				received += datagrams[i].size()
		var decoded: int = Time.get_ticks_usec() - begin
		begin = Time.get_ticks_usec()
		smoother.evaluate(tick / float(HZ))
		for i: int in p_awake:
			smoother.field(_FIRST + i * p_entities / p_awake, 0)
		var read: int = Time.get_ticks_usec() - begin
		acks.append(decoder.get_ack(Vector3.ZERO))
		if acks.size() > _ROUND_TRIP:
			var ack: PackedByteArray = acks.pop_front()
			# All clients receive the same, so one answers for all.
			for client: int in clients:
				encoder.take_ack(client, ack)
		if tick >= HZ:
			encode_usec += encoded
			decode_usec += decoded
			read_usec += read
			bytes += received
	_add(p_case, p_awake, ticks, [encode_usec, decode_usec, read_usec, bytes])


func _set_up(
	p_encoder: SnapshotEncoder, p_decoder: SnapshotDecoder, p_entities: int
) -> PackedInt32Array:
	var parents: PackedInt32Array = PackedInt32Array(Limbs.PARENTS)
	p_encoder.configure(parents, Protocol.POSE_ERROR_DEG, HZ)
	p_decoder.configure(parents, Protocol.POSE_ERROR_DEG)
	p_encoder.define_type(1, _KINDS, _MINS, _MAXS, _RESOLUTIONS)
	p_decoder.define_type(1, _KINDS, _MINS, _MAXS, _RESOLUTIONS)
	for i: int in p_entities:
		p_encoder.add_entity(_FIRST + i, 1, [0.0, 0.5, 1.0], i + 1)
		p_decoder.add_entity(_FIRST + i, 1, [0.0, 0.5, 1.0])
	p_decoder.set_table_version(p_entities)
	var clients: PackedInt32Array = []
	for client: int in option("clients"):
		p_encoder.add_client(client + 1, HZ, _BITS)
		clients.append(client + 1)
	return clients


func _add(p_case: String, p_awake: int, p_ticks: int, p_sums: Array[int]) -> void:
	var goal: float = _GOAL_ENCODE_MS if p_awake > 0 else 0.2
	var name: String = "encode for %d clients" % option("clients")
	report.at_most(p_case, name, p_sums[0] / 1000.0 / p_ticks, "ms a tick", goal)
	report.at_most(p_case, "decode", p_sums[1] / 1000.0 / p_ticks, "ms a tick", _GOAL_DECODE_MS)
	report.add(p_case, "evaluate and read", p_sums[2] / 1000.0 / p_ticks, "ms a tick")
	if p_awake > 0:
		var each: float = p_sums[3] / float(p_awake * p_ticks)
		report.at_most(p_case, "a field that changes", each, "bytes", _GOAL_BYTES)
	else:
		# Two datagrams a second, of headers alone, keep the clocks in step.
		report.at_most(p_case, "all fields", p_sums[3] / float(p_ticks), "bytes a tick", 0.5)

class_name ReplicationPart
extends ServerPart
## Sends the state of the world to all clients, and records it: makes and conducts [Replication].

## Maximum ticks per second: a snapshot has the rate in a byte.
const _MAX_TICKS: int = 240

var _impacts: ServerImpacts = null


func open(p_context: ServerContext) -> String:
	super(p_context)
	if context.rate() > _MAX_TICKS:
		return "%d ticks/s are set, %d is the most" % [context.rate(), _MAX_TICKS]
	context.replication = Replication.new(
		context.link,
		context.level,
		context.people,
		context.rate(),
		context.bandwidth(),
		context.options.degrees("pose-error")
	)
	_impacts = ServerImpacts.new(context.level, context.people)
	context.link.client_joined.connect(_on_joined)
	context.link.client_returned.connect(_on_returned)
	context.link.client_lost.connect(context.replication.remove_client)
	context.link.client_left.connect(context.replication.remove_client)
	context.level.changed.connect(_survey_soon)
	context.control.describer = _describe_client
	return context.replication.record_to(context.options.file("record"))


func advance(_now_usec: int, _delta_s: float) -> void:
	context.replication.advance_survey()


func send(p_now_usec: int) -> void:
	if context.level.is_between:
		return
	var messages: Array[PackedByteArray] = context.entities.take_messages()
	messages.append(_impacts.take_message(context.tick, 1.0 / context.rate()))
	context.replication.send(context.tick, p_now_usec, messages)


func take_options() -> void:
	context.replication.set_bandwidth(context.bandwidth())


## Of each session, what is sent to it and how its connection is.
func report() -> Dictionary:
	var peers: Dictionary = context.link.stats().get("peers", {})
	var rows: Array[Dictionary] = []
	for client: RosterRow in context.link.roster():
		var row: Dictionary = {"session": client.session, "name": client.name}
		row["role"] = Roles.name_of(client.role)
		row["state"] = client.state_name()
		row["address"] = client.address
		row.merge(context.replication.stats_of(client.session))
		var peer: Dictionary = peers.get(client.session, {})
		if peer.has("round_trip_ms"):
			row["round_trip_ms"] = peer["round_trip_ms"]
		rows.append(row)
	return {"sessions": rows}


func close() -> void:
	if context.replication == null:
		return
	context.replication.close()
	if context.link.client_left.is_connected(context.replication.remove_client):
		context.link.client_left.disconnect(context.replication.remove_client)


func _survey_soon() -> void:
	# Bodies are in the physics space after a step.
	await get_tree().physics_frame
	context.replication.survey()


func _describe_client(p_row: RosterRow) -> void:
	var stats: Dictionary = context.replication.stats_of(p_row.session)
	p_row.round_trip_ms = stats.get("round_trip_ms", -1.0)
	p_row.delay_ms = stats.get("display_latency_ms_p50", -1.0)
	_describe_people(p_row)


## How many people a client has, and how well their bodies follow.
func _describe_people(p_row: RosterRow) -> void:
	var sum_deg: float = 0.0
	for person: ServerPerson in context.people.list():
		if person.session == p_row.session:
			p_row.people += 1
			sum_deg += person.ragdoll.motor.get_tracking().get("mean_deg", 0.0)
	if p_row.people > 0:
		p_row.tracking_deg = sum_deg / p_row.people


func _on_joined(p_session: int, p_hello: Dictionary) -> void:
	context.replication.add_client(p_session, p_hello["rate"])


func _on_returned(p_session: int) -> void:
	context.replication.add_client(p_session, context.link.session(p_session).rate)

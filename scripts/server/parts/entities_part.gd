class_name EntitiesPart
extends ServerPart
## Fields, commands and events of all entities: makes and conducts [ServerEntities].


func open(p_context: ServerContext) -> String:
	super(p_context)
	context.entities = ServerEntities.new(
		context.link, context.level.table, context.people, context.replication.encoder
	)
	context.entities.command_refused.connect(context.control.tell_instructors)
	context.level.entity_added.connect(_on_entity_added)
	context.level.leaving.connect(context.entities.forget_waiting)
	context.people.person_added.connect(_on_person_added)
	context.link.client_joined.connect(
		func(session: int, _hello: Dictionary) -> void: context.entities.add_session(session)
	)
	context.link.client_returned.connect(context.entities.add_session)
	context.link.client_left.connect(context.entities.remove_session)
	return ""


func advance(_now_usec: int, _delta_s: float) -> void:
	if not context.level.is_between:
		context.entities.advance(context.tick, context.rate())


## The bodies are out of the tree already: nobody needs to know who leaves now.
func close() -> void:
	if context.link.client_left.is_connected(context.entities.remove_session):
		context.link.client_left.disconnect(context.entities.remove_session)


func _on_entity_added(p_row: EntityRow, p_node: Entity, p_body: PhysicsBody3D) -> void:
	if p_body != null:
		context.entities.note_body(p_row, p_body)
	if p_node != null:
		context.entities.bind(p_row, p_node)


func _on_person_added(p_person: ServerPerson) -> void:
	if p_person.entity != null:
		context.entities.bind(context.level.table.find(p_person.id), p_person.entity)

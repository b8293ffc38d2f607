class_name WalkersPart
extends ServerPart
## People without a suit, who walk by keys or a stick: makes a [ServerWalker] of whoever sends the
## command [code]walk[/code], and moves all of them.

var _walkers: Dictionary[int, ServerWalker] = {}
var _bodies: WalkerBodies = WalkerBodies.new()
var _sets: WalkerSets = null


func open(p_context: ServerContext) -> String:
	super(p_context)
	context.people.person_added.connect(_on_person_added)
	context.level.table.despawned.connect(func(row: EntityRow) -> void: _forget(row.id))
	context.level.changed.connect(func() -> void: _bodies.set_level(context.level.level))
	context.level.entity_added.connect(_bodies.add_entity)
	_sets = WalkerSets.new(context.link)
	_sets.changed.connect(_on_set_changed)
	return ""


func begin() -> String:
	WalkerPose.prepare()
	return ""


func advance(p_now_usec: int, p_delta_s: float) -> void:
	_sets.advance()
	if context.level.is_between:
		return
	for walker: ServerWalker in _walkers.values():
		if walker.is_over():
			walker.end()
			_forget(walker.person.id)
			continue
		var message: PackedByteArray = walker.advance(context.tick, p_now_usec / 1e6, p_delta_s)
		if not message.is_empty():
			context.link.send_whole(walker.person.session, message)


func report() -> Dictionary:
	var rows: Array[Dictionary] = []
	for walker: ServerWalker in _walkers.values():
		# At the end the bodies are out of the tree already.
		if not walker.person.ragdoll.is_inside_tree():
			continue
		(
			rows
			. append(
				{
					"name": walker.person.name,
					"position": _numbers(walker.mover.get_position()),
					"hips": _numbers(walker.person.hips()),
					"mode": walker.mover.get_mode(),
					"carrier": walker.mover.get_carrier(),
					"inputs": walker.inputs,
					"corrections": walker.corrections,
					"motion_set": walker.set_id,
				}
			)
		)
	return {"walkers": rows, "motion_sets": {"taken": _sets.taken, "refused": _sets.refused}}


func close() -> void:
	if _sets != null:
		_sets.close()


func _on_person_added(p_person: ServerPerson) -> void:
	# Another level has the same bodies once more.
	var entity: Entity = p_person.entity
	if entity != null and not entity.commanded.is_connected(_on_commanded):
		entity.commanded.connect(_on_commanded.bind(p_person))


func _on_commanded(
	p_session: int, p_command: StringName, p_values: PackedFloat32Array, p_person: ServerPerson
) -> void:
	# Anybody may send it, but only for the own people.
	if p_command != WalkerInput.COMMAND or p_person.session != p_session:
		return
	if not _walkers.has(p_person.id):
		var walker: ServerWalker = ServerWalker.new(p_person)
		_bodies.add_mover(walker.mover, context.people.get_world_3d())
		_walkers[p_person.id] = walker
		var own: WalkerSet = _sets.of_session(p_session)
		if own != null:
			walker.use_set(own)
	_walkers[p_person.id].take(p_values)


func _on_set_changed(p_session: int) -> void:
	for walker: ServerWalker in _walkers.values():
		if walker.person.session == p_session:
			walker.use_set(_sets.of_session(p_session))


static func _numbers(p_place: Vector3) -> Array[float]:
	return [p_place.x, p_place.y, p_place.z]


func _forget(p_person: int) -> void:
	if _walkers.has(p_person):
		_bodies.remove_mover(_walkers[p_person].mover)
		_walkers.erase(p_person)

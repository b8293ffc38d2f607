class_name ClientWalker
extends ClientPart
## Lets this client's user walk by keys, mouse or gamepad where [code]--source=walker[/code] says
## so: sends what is wished, takes the server's corrections, and looks where the eyes do. Legs that
## carry another source's motion ([WalkedLegs]) get their wishes, and where the body is.

## Margin with which inputs arrive before their tick, ticks: the variation of the network.
const MARGIN_TICKS: float = 2.5

var _controls: WalkerControls = WalkerControls.new()
var _bodies: WalkerBodies = WalkerBodies.new()
var _source: WalkerSource = null
var _legs: WalkedLegs = null
var _actor: int = -1
var _worn: HeadsetWalk = null
var _own_set: OwnMotionSet = OwnMotionSet.new()


func _unhandled_input(p_event: InputEvent) -> void:
	if not _walks() or context.is_menu_open() or _controls.list != null:
		return
	var click: InputEventMouseButton = p_event as InputEventMouseButton
	if click != null and click.pressed and click.button_index == MOUSE_BUTTON_LEFT:
		Input.mouse_mode = Input.MOUSE_MODE_CAPTURED
		get_viewport().set_input_as_handled()


func open(p_context: ClientContext) -> String:
	super(p_context)
	add_child(_controls)
	if context.options.text("walk") != "":
		_controls.list = WalkScript.parse(context.options.text("walk"))
		if _controls.list.error != "":
			return _controls.list.error
	var fault: String = _own_set.open(context.link, context.options.file("motion-set"))
	if fault != "":
		return fault
	context.link.handle(Protocol.Message.WALK, MessageHandlers.Path.RELIABLE, _on_walk)
	context.link.joined.connect(_restart)
	var level: ClientLevel = context.scene.get_level()
	level.changed.connect(func(fresh: Level, _differs: bool) -> void: _bodies.set_level(fresh))
	level.entity_added.connect(_bodies.add_entity)
	return ""


func begin_frame() -> void:
	_meet_source()
	_own_set.advance(get_process_delta_time(), _source != null)
	if not _walks():
		return
	_controls.hands_off = context.is_menu_open() or context.is_seated
	_wear()
	# The arrow keys turn who walks.
	context.scene.view.camera.takes_keys = _controls.hands_off
	if _controls.hands_off and Input.mouse_mode == Input.MOUSE_MODE_CAPTURED:
		Input.mouse_mode = Input.MOUSE_MODE_VISIBLE
	if _source != null:
		_meet_actor()
	else:
		_legs.raises_seated = not context.is_seated
		_place_legs()
		_legs.listen(get_process_delta_time())


## The eyes of who walks look where the mouse points, without waiting for the body.
func advance(_delta_s: float) -> void:
	if _source != null and _actor >= 0 and not _controls.hands_off:
		context.scene.view.look(_controls.heading, _controls.look)
	elif _source != null:
		context.scene.view.look(NAN, 0.0)


func report() -> Dictionary:
	if _legs != null:
		var feet: Vector3 = _legs.ground.mover.get_position()
		var facts: Dictionary = {"share": _legs.share(), "position": [feet.x, feet.y, feet.z]}
		if _own_set.own != null:
			# The server knows of no walker here.
			facts["motion_set"] = _own_set.own.id
		return {"legs": facts}
	if _source == null:
		return {}
	var prediction: WalkerPrediction = _source.prediction
	var place: Vector3 = prediction.mover.get_position()
	var rows: Dictionary = {
		"tick": prediction.tick,
		"corrections": prediction.corrections,
		"pull_m_p99": prediction.pulls.percentile(0.99),
		"position": [place.x, place.y, place.z],
		"heading": _controls.heading,
		"stance": prediction.mover.get_stance(),
		"mode": prediction.mover.get_mode(),
	}
	if _own_set.own != null:
		rows["motion_set"] = _own_set.report()
	return {"walking": rows}


func close() -> void:
	_leave_source()


## Lets the wearer of a headset walk.
func _wear() -> void:
	if not context.is_headset_worn():
		if _worn != null:
			_worn.end(_controls)
			_worn = null
		return
	if _worn == null:
		var by_hand: bool = context.options.text("walk-by") == "hand"
		_worn = HeadsetWalk.new(context.headset, by_hand)
		_worn.begin(_controls.heading)
		context.headset.display.recentred.connect(_recentre)
	_worn.read(_controls, _legs)


func _recentre() -> void:
	if _worn != null:
		_worn.recentre(_controls.heading)


## Puts the room of a headset where its wearer walks, or sits.
func _find_room(r_place: WearerTransform) -> void:
	var views: Dictionary[int, ActorView] = context.scene.people()
	if _worn == null or _source == null or _source.prediction.tick < 0:
		return
	if context.is_seated and views.has(_actor):
		_worn.find_seat(r_place, views[_actor].head(), views[_actor].heading())
	else:
		_worn.find_room(r_place, _source.prediction)


func _walks() -> bool:
	return _source != null or _legs != null


## Gives who walks, who may be somebody else by a choice at the panel, what walking needs.
func _meet_source() -> void:
	var found: MotionSource = context.people.source_of(0) if context.people != null else null
	if _walks() and found != _source and found != _legs:
		_leave_source()
		context.scene.view.look(NAN, 0.0)
		context.scene.view.camera.takes_keys = true
	if _walks() or not (found is WalkerSource or found is WalkedLegs):
		return
	_source = found as WalkerSource
	_legs = found as WalkedLegs
	_actor = -1
	var world: World3D = context.scene.get_world_3d()
	if _legs != null:
		_legs.ground.enter(world, _bodies)
		_legs.read_input = _controls.read
	else:
		_bodies.add_mover(_source.prediction.mover, world)
		_source.read_input = _controls.read
		_source.due_tick = _due_tick
		_source.send = _send
		_source.find_room = _find_room
	_own_set.give_to(found)
	ClientPhysics.hold()


func _leave_source() -> void:
	if not _walks():
		return
	if _legs != null:
		_legs.ground.leave()
	else:
		_bodies.remove_mover(_source.prediction.mover)
	ClientPhysics.release()
	Input.mouse_mode = Input.MOUSE_MODE_VISIBLE
	_source = null
	_legs = null


## Says where the body is whose motion the legs carry.
func _place_legs() -> void:
	var place: WearerTransform = context.people.find_wearer(
		context.scene.replica, context.own_bodies
	)
	_legs.has_frame = place != null
	if place != null:
		_legs.frame = place.frame


## Finds the person's own entity, whose command an input is.
func _meet_actor() -> void:
	var actor: int = context.people.first_actor
	if actor == _actor:
		if actor >= 0:
			var heading: float = context.scene.replica.ground_heading(actor)
			_source.frame_heading = 0.0 if is_nan(heading) else heading
		return
	var node: Entity = context.scene.entities.find(actor) if actor >= 0 else null
	_source.restart()
	_source.schema = null
	_actor = -1
	if node != null:
		var index: int = node.type.find_command(WalkerInput.COMMAND)
		_actor = actor
		if index >= 0:
			_source.schema = node.type.commands[index]


func _restart() -> void:
	_actor = -1
	if _source != null:
		_source.restart()
	if _legs != null:
		_legs.restart()


## The server's tick that a command reaches which leaves now, with its fraction.
func _due_tick() -> float:
	var replica: WorldReplica = context.scene.replica
	if replica.tick_rate() <= 0.0 or replica.newest_tick < 0:
		return -1.0
	_source.tick_s = 1.0 / replica.tick_rate()
	var trip_usec: int = context.link.clock.round_trip_usec
	return CommandTick.reached(replica, context.now_s(), trip_usec) + MARGIN_TICKS


func _send(p_input: WalkerInput, p_tick: int) -> void:
	var node: Entity = context.scene.entities.find(_actor)
	if node != null:
		node.send_command(WalkerInput.COMMAND, p_input.to_values(), p_tick)


func _on_walk(p_bytes: PackedByteArray, _arrival_usec: int) -> bool:
	var message: WalkMessage = WalkMessage.decode(p_bytes)
	if message == null:
		return false
	if _source == null or message.person != _actor:
		return true
	var begins: bool = _source.prediction.tick < 0
	if not _source.correct(message.tick, message.number, message.state):
		return false
	if begins:
		_controls.heading = _source.prediction.mover.get_heading()
		if _worn != null:
			_worn.begin(_controls.heading)
		if _controls.list != null:
			_controls.list.begin(_controls.heading)
	return true

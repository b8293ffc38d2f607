class_name PeoplePart
extends ServerPart
## The people of all sessions: gives each client the bodies of those whom it lists, and takes its
## motion for them. [MotionPart] moves the bodies.

var _names: Dictionary[int, String] = {}
var _lists: PeopleLists = PeopleLists.new()


func open(p_context: ServerContext) -> String:
	super(p_context)
	var options: Options = context.options
	context.people.root_mode = RootModes.BY_NAME[options.text("root")]
	context.people.setup(context.level.table, options.number("max-people"))
	context.level.leaving.connect(context.people.leave)
	context.level.changed.connect(_on_level_changed)
	context.link.client_joined.connect(_on_joined)
	context.link.client_left.connect(_on_left)
	context.link.people_declared.connect(_lists.take)
	context.link.pose_received.connect(_on_pose)
	return ""


func begin() -> String:
	context.people.changes.prepare()
	return ""


## Who comes comes in the tick that begins.
func receive(_now_usec: int) -> void:
	context.people.tick = context.tick + 1


func advance(p_now_usec: int, _delta_s: float) -> void:
	_take_lists(p_now_usec / 1e6)
	if not context.level.is_between:
		context.people.advance()


func idle() -> void:
	context.people.changes.restock()


func take_options() -> void:
	context.people.changes.max_people = context.options.number("max-people")


func report() -> Dictionary:
	var changes: PeopleChanges = context.people.changes
	return {
		"people": context.people.stats(),
		"max_people": changes.max_people,
		"changes": changes.stats(),
	}


## The bodies are out of the tree already: nobody needs to know who leaves now.
func close() -> void:
	if context.link.client_left.is_connected(_on_left):
		context.link.client_left.disconnect(_on_left)


func _on_level_changed() -> void:
	var level: Level = context.level.level
	var points: Array[Transform3D] = []
	var avatars: PackedStringArray = []
	for point: SpawnPoint in level.get_spawn_points():
		points.append(point.get_start())
		avatars.append(point.avatar)
	context.people.default_avatar = level.default_avatar
	context.people.enter(points, avatars)


func _on_joined(p_session: int, p_hello: Dictionary) -> void:
	_names[p_session] = p_hello["name"]


func _on_left(p_session: int) -> void:
	_names.erase(p_session)
	_lists.forget(p_session)
	context.people.remove(p_session)


## Applies what sessions have said of their people, as far as it counts yet.
func _take_lists(p_now_s: float) -> void:
	var due: Dictionary[int, Array] = _lists.take_due(p_now_s)
	for session: int in due:
		var cards: Array[PersonCard] = []
		cards.assign(due[session])
		if context.people.set_people(session, cards, _names.get(session, "")) > 0:
			var text: String = "the server has room for %d people: not all of yours have a body"
			text = text % context.people.changes.max_people
			context.link.send_reliably([session], NoticeMessage.tell(text))


func _on_pose(p_session: int, p_sample: PoseSample, p_arrival_usec: int) -> void:
	p_sample.arrival_usec = p_arrival_usec
	# What the motors do with it is no work of the network.
	context.network_usec += ThreadClock.get_usec()
	context.people.push_sample(p_session, p_sample, p_arrival_usec / 1e6)
	context.network_usec -= ThreadClock.get_usec()

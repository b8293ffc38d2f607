extends TestCase
## Whose motion clients send, and calibrations that instructors ask for, over a real link.

const LinkPair: GDScript = preload("link_pair.gd")
const NetSamples: GDScript = preload("net_samples.gd")
const TRAINEE: Roles.Role = Roles.Role.TRAINEE
const OBSERVER: Roles.Role = Roles.Role.OBSERVER
const INSTRUCTOR: Roles.Role = Roles.Role.INSTRUCTOR

var _pair: LinkPair = null
## What the server was told: session to names, each time.
var _told: Dictionary[int, Array] = {}
var _answers: Array[String] = []
var _asked: Array[Vector2i] = []


func before_each() -> void:
	_pair = LinkPair.new()
	_told.clear()
	_answers.clear()
	_asked.clear()
	_pair.server.people_declared.connect(_on_people)
	_pair.listen()


func after_each() -> void:
	_pair.close()


func test_a_trainee_tells_whom_it_brings() -> void:
	var ada: LinkPair.End = _pair.join(TRAINEE)
	ada.link.declare_people(_cards(["Ada", "Bob"]))
	is_true(_pair.until(func() -> bool: return _told.has(ada.link.session)))
	equal(_told[ada.link.session], [["Ada", "Bob"]])
	ada.link.declare_people(_cards([]))
	is_true(_pair.until(func() -> bool: return _told[ada.link.session].size() == 2))
	equal(_told[ada.link.session][1], [])


func test_nobody_else_brings_anybody() -> void:
	for role: Roles.Role in [OBSERVER, INSTRUCTOR]:
		var end: LinkPair.End = _pair.join(role)
		end.link.declare_people(_cards(["Eve"]))
		_pair.run(0.2)
		is_false(_told.has(end.link.session))
		is_true(end.link.is_joined(), "and the connection stands")


func test_a_list_that_is_none_changes_nothing() -> void:
	var ada: LinkPair.End = _pair.join(TRAINEE)
	var bad: PersonCard = PersonCard.of("giant", 7.0)
	ada.link.declare_people([bad] as Array[PersonCard])
	var twice: Array[PersonCard] = [PersonCard.of("A", 1.0, 2), PersonCard.of("B", 1.0, 2)]
	ada.link.declare_people(twice)
	_pair.run(0.2)
	is_false(_told.has(ada.link.session))
	ada.link.declare_people(_cards(["Ada"]))
	is_true(_pair.until(func() -> bool: return _told.has(ada.link.session)))


func test_who_is_back_tells_again_and_has_the_same_session() -> void:
	var ada: LinkPair.End = _pair.join(TRAINEE)
	var session: int = ada.link.session
	ada.link.declare_people(_cards(["Ada"]))
	is_true(_pair.until(func() -> bool: return _told.has(session)))
	ada.link._peer.close_with(DisconnectReason.LOST)
	is_true(_pair.until(func() -> bool: return _pair.lost.size() == 1 and ada.loss != ""))
	# What is declared meanwhile goes nowhere, and harms nothing.
	ada.link.declare_people(_cards(["Ada"]))
	ada.link.open("127.0.0.1", _pair.port, ada.request)
	is_true(_pair.until(func() -> bool: return _pair.returned.size() == 1 and ada.joined == 2))
	ada.link.declare_people(_cards(["Ada", "Bob"]))
	is_true(_pair.until(func() -> bool: return _told[session].size() == 2))
	equal(_told[session][1], ["Ada", "Bob"])
	equal(_pair.left.size(), 0, "nobody's body was taken away")


func test_an_instructor_has_somebody_calibrated() -> void:
	var control: SessionControl = _instructor()
	var ada: LinkPair.End = _trainee("Ada")
	var bob: LinkPair.End = _trainee("Bob")
	control.calibrate(ada.link.session, 1, 4)
	is_true(_pair.until(func() -> bool: return not _asked.is_empty()))
	equal(_asked, [Vector2i(1, 4)] as Array[Vector2i], "only one of the two was asked")
	is_true(_pair.until(func() -> bool: return _answers.size() == 1))
	equal(_answers, ["session %d was asked to calibrate" % ada.link.session] as Array[String])
	is_true(bob.link.is_joined())


func test_what_cannot_be_calibrated_is_said() -> void:
	var control: SessionControl = _instructor()
	var ada: LinkPair.End = _trainee("Ada")
	var eve: LinkPair.End = _pair.join(OBSERVER, "Eve")
	var session: int = ada.link.session
	var wrong: Array[Array] = [
		[eve.link.session, 0, 0, "no trainee"],
		[999, 0, 0, "no trainee"],
		[-1, 0, 0, "no trainee"],
		[session, PersonCard.MAX_PEOPLE, 0, "no person"],
		[session, -1, 0, "no person"],
		[session, 0, 256, "no pose"],
		[session, 1 << 40, 1 << 40, "no person"],
	]
	for row: Array in wrong:
		_answers.clear()
		control.calibrate(row[0], row[1], row[2])
		is_true(_pair.until(func() -> bool: return not _answers.is_empty()), str(row))
		contains(_answers[0], row[3])
	equal(_asked, [] as Array[Vector2i])


func test_arguments_that_are_none_are_ignored() -> void:
	var control: SessionControl = _instructor()
	var ada: LinkPair.End = _trainee("Ada")
	for arguments: Array in [[], ["1", 0, 0], [ada.link.session, 0.0, 0], [null, null, null]]:
		control.rpc_id.callv([1, &"_calibrate"] + arguments)
	_pair.run(0.3)
	equal([_asked, _answers], [[] as Array[Vector2i], [] as Array[String]])
	control.calibrate(ada.link.session, 0, 0)
	is_true(_pair.until(func() -> bool: return _asked.size() == 1), "and calls go on")


func test_nobody_else_lets_anybody_be_calibrated() -> void:
	SessionControl.serve(_node(), _pair.server)
	var ada: LinkPair.End = _trainee("Ada")
	for role: Roles.Role in [TRAINEE, OBSERVER]:
		var rogue: LinkPair.End = _pair.join(role, "rogue")
		var control: SessionControl = SessionControl.follow(_node(), rogue.link)
		control.calibrate(ada.link.session, 0, 0)
		_pair.run(0.3)
	equal(_asked, [] as Array[Vector2i])


func _on_people(p_session: int, p_people: Array[PersonCard]) -> void:
	var names: Array = p_people.map(func(card: PersonCard) -> String: return card.name)
	_told.get_or_add(p_session, []).append(names)


func _trainee(p_name: String) -> LinkPair.End:
	var end: LinkPair.End = _pair.join(TRAINEE, p_name)
	end.link.calibration_asked.connect(
		func(index: int, kind: int) -> void: _asked.append(Vector2i(index, kind))
	)
	return end


func _instructor() -> SessionControl:
	SessionControl.serve(_node(), _pair.server)
	var end: LinkPair.End = _pair.add(INSTRUCTOR, "Ida")
	var control: SessionControl = SessionControl.follow(_node(), end.link)
	control.answered.connect(_answers.append)
	is_true(_pair.until(func() -> bool: return end.joined == 1 and not control.roster.is_empty()))
	return control


func _cards(p_names: Array) -> Array[PersonCard]:
	var cards: Array[PersonCard] = []
	for name: String in p_names:
		cards.append(PersonCard.of(name, 0.95, cards.size()))
	return cards


func _node() -> Node:
	var node: Node = Node.new()
	add_child(node)
	return node

extends TestCase
## Whose motion clients send, over a real link.

const LinkPair: GDScript = preload("link_pair.gd")
const NetSamples: GDScript = preload("net_samples.gd")
const TRAINEE: Roles.Role = Roles.Role.TRAINEE
const OBSERVER: Roles.Role = Roles.Role.OBSERVER
const INSTRUCTOR: Roles.Role = Roles.Role.INSTRUCTOR

var _pair: LinkPair = null
## What the server was told: session to names, each time.
var _told: Dictionary[int, Array] = {}


func before_each() -> void:
	_pair = LinkPair.new()
	_told.clear()
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
	ada.cut()
	is_true(_pair.until(func() -> bool: return _pair.lost.size() == 1 and ada.loss != ""))
	# What is declared meanwhile goes nowhere, and harms nothing.
	ada.link.declare_people(_cards(["Ada"]))
	ada.link.open("127.0.0.1", _pair.port, ada.request)
	is_true(_pair.until(func() -> bool: return _pair.returned.size() == 1 and ada.joined == 2))
	ada.link.declare_people(_cards(["Ada", "Bob"]))
	is_true(_pair.until(func() -> bool: return _told[session].size() == 2))
	equal(_told[session][1], ["Ada", "Bob"])
	equal(_pair.left.size(), 0, "nobody's body was taken away")


func _on_people(p_session: int, p_people: Array[PersonCard]) -> void:
	var names: Array = p_people.map(func(card: PersonCard) -> String: return card.name)
	_told.get_or_add(p_session, []).append(names)


func _cards(p_names: Array) -> Array[PersonCard]:
	var cards: Array[PersonCard] = []
	for name: String in p_names:
		cards.append(PersonCard.of(name, 0.95, cards.size()))
	return cards

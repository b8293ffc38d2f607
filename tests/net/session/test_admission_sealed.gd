extends TestCase
## Who may come in over a sealed connection.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")
const TRAINEE: Roles.Role = Roles.Role.TRAINEE
const OBSERVER: Roles.Role = Roles.Role.OBSERVER
const INSTRUCTOR: Roles.Role = Roles.Role.INSTRUCTOR
const V: int = Protocol.VERSION

var _pair: LinkPair = null


func before_each() -> void:
	_pair = LinkPair.new()


func after_each() -> void:
	_pair.close()


func test_a_sealed_server_that_does_not_know_the_password_is_left() -> void:
	var impostor: LinkPair = LinkPair.new()
	impostor.rules.password = "guess"
	impostor.listen()
	var end: LinkPair.End = impostor.add(TRAINEE, "Ada", V, "sesame")
	is_true(impostor.until(func() -> bool: return end.refusal != ""))
	equal([end.refusal, impostor.joined.size()], ["the password is wrong", 0])
	impostor.close()


func test_a_sealed_connection_is_for_its_role_alone() -> void:
	_pair.rules.password = "all"
	_pair.rules.instructor_password = "few"
	_pair.listen()
	var end: LinkPair.End = _pair.add(OBSERVER, "Eve", V, "all")
	# Asks for more than the handshake was made for.
	end.request.role = INSTRUCTOR
	is_true(_pair.until(func() -> bool: return end.refusal != ""))
	contains(end.refusal, "another role")
	equal(_pair.server.session_ids().size(), 0)


func test_both_ends_seal_or_neither_does() -> void:
	for server_seals: bool in [true, false]:
		var pair: LinkPair = LinkPair.new()
		pair.rules.seals = server_seals
		pair.listen()
		var end: LinkPair.End = LinkPair.End.new()
		end.link.seals = not server_seals
		pair.ends.append(end)
		end.link.open("127.0.0.1", pair.port, end.request)
		is_true(pair.until(func() -> bool: return end.refusal != ""))
		contains(end.refusal, "wants sealed" if server_seals else "does not seal")
		pair.close()

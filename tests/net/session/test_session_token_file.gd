extends TestCase
## Who crashed comes back, and nobody takes over the session of another.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")
const TRAINEE: Roles.Role = Roles.Role.TRAINEE
const OBSERVER: Roles.Role = Roles.Role.OBSERVER

var _pair: LinkPair = null


func before_each() -> void:
	_pair = LinkPair.new()


func after_each() -> void:
	_pair.close()


func test_a_killed_client_that_is_started_anew_has_its_session_again() -> void:
	_pair.listen(1)
	var where: String = "127.0.0.1:%d" % _pair.port
	var end: LinkPair.End = _add_with_file(where, "Ada")
	is_true(_pair.until(func() -> bool: return end.joined == 1))
	var session: int = end.link.session
	# Another of the same name runs meanwhile: it must not take the session over.
	var twin: SessionTokenFile = SessionTokenFile.claim(where, TRAINEE, "Ada")
	equal(twin.token().size(), 0)
	# A killed program says nothing, and the system unlocks its file.
	end.link.token_file = null
	_pair.ends.erase(end)
	var again: LinkPair.End = _add_with_file(where, "Ada")
	is_true(_pair.until(func() -> bool: return again.joined == 1), again.refusal + again.loss)
	equal(again.link.session, session)
	is_true(_pair.until(func() -> bool: return _pair.returned.has(session)))
	again.link.leave()
	equal(SessionTokenFile.claim(where, TRAINEE, "Ada").token().size(), 0, "nothing is left")
	end.link.close()


func test_the_token_of_another_name_role_or_server_is_not_used() -> void:
	var kept: SessionTokenFile = SessionTokenFile.claim("there:1", TRAINEE, "Ada")
	kept.keep(Crypto.new().generate_random_bytes(JoinRequest.TOKEN_SIZE))
	var token: PackedByteArray = kept.token()
	equal(token.size(), JoinRequest.TOKEN_SIZE)
	equal(SessionTokenFile.claim("there:2", TRAINEE, "Ada").token().size(), 0)
	equal(SessionTokenFile.claim("there:1", OBSERVER, "Ada").token().size(), 0)
	equal(SessionTokenFile.claim("there:1", TRAINEE, "Bob").token().size(), 0)
	kept = null
	kept = SessionTokenFile.claim("there:1", TRAINEE, "Ada")
	equal(kept.token(), token)
	kept.forget()


func _add_with_file(p_where: String, p_name: String) -> LinkPair.End:
	var end: LinkPair.End = LinkPair.End.new()
	end.request.role = TRAINEE
	end.request.name = p_name
	end.link.token_file = SessionTokenFile.claim(p_where, TRAINEE, p_name)
	_pair.ends.append(end)
	end.link.open("127.0.0.1", _pair.port, end.request)
	return end

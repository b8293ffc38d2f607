extends TestCase
## What is said at the door: challenge, join request, answer, and what each proves.

## Of "dismount:secret", salt 0 to 15, 1000 rounds, by Python's hashlib.
const PBKDF2: String = "94ac395a81efc7218dd58e25107df9bc193996263888f17db1330cd75fc52f79"

var _challenge: PackedByteArray = ServerRules.new().challenge().encode()
var _key: PackedByteArray = PasswordKey.derive("secret", _challenge.slice(13, 29), 100)


func test_greeting_round_trip() -> void:
	for name: String in ["Ada", "Größe 東京 😀", "x".repeat(32)]:
		for role: Roles.Role in Roles.Role.values():
			var request: JoinRequest = JoinRequest.decode(_encode(name, role))
			equal(request.error, "")
			equal([request.name, request.role, request.rate], [name, role, 30])
			equal(request.version, Protocol.VERSION)
			equal(request.token, PackedByteArray())


func test_a_token_is_carried() -> void:
	var sent: JoinRequest = JoinRequest.new()
	sent.token = Crypto.new().generate_random_bytes(16)
	equal(JoinRequest.decode(sent.encode(_challenge, _key)).token, sent.token)


func test_names_are_made_decent() -> void:
	var cases: Dictionary[String, String] = {
		"": "nobody",
		"   ": "nobody",
		"a\nb\tc": "abc",
		"\u001b[2J\u009b": "[2J",
		"\u202egnp": "gnp",
		"x".repeat(1000): "x".repeat(32),
		"😀".repeat(40): "😀".repeat(32),
	}
	for name: String in cases:
		equal(JoinRequest.decode(_encode(name)).name, cases[name], name.left(40))


func test_other_versions_are_named() -> void:
	for version: int in [0, 1, 65537, 0xFFFFFFFF]:
		var sent: JoinRequest = JoinRequest.new()
		sent.version = version
		var versions: Array = [version, Protocol.VERSION]
		var text: String = "the client speaks protocol version %d, the server %d" % versions
		equal(JoinRequest.decode(sent.encode(_challenge, _key)).error, text)


func test_other_versions_of_another_form_are_named() -> void:
	var bytes: PackedByteArray = "DSMT".to_ascii_buffer() + PackedByteArray([1, 0, 0, 0, 1, 2, 3])
	contains(JoinRequest.decode(bytes).error, "version 1, the server %d" % Protocol.VERSION)
	contains(Challenge.decode(bytes).error, "version 1, this client %d" % Protocol.VERSION)


func test_unknown_role() -> void:
	var bytes: PackedByteArray = _encode("Ada")
	bytes[8] = 4
	contains(JoinRequest.decode(bytes).error, "role")


func test_foreign_bytes() -> void:
	var variant: PackedByteArray = var_to_bytes({"version": 1, "role": 0, "name": "Ada"})
	contains(JoinRequest.decode(variant).error, "not in Dismount's form")
	contains(JoinRequest.decode(PackedByteArray()).error, "0 bytes")
	var large: PackedByteArray = _encode("Ada")
	large.resize(10000)
	contains(JoinRequest.decode(large).error, "10000 bytes")


func test_only_the_right_password_is_proven() -> void:
	var request: JoinRequest = JoinRequest.decode(_encode("Ada"))
	is_true(request.is_proven(_challenge, _key))
	var other: PackedByteArray = PasswordKey.derive("Secret", _challenge.slice(13, 29), 100)
	is_false(request.is_proven(_challenge, other), "another password")
	is_false(request.is_proven(ServerRules.new().challenge().encode(), _key), "replayed")


func test_a_proof_covers_the_whole_greeting() -> void:
	var good: PackedByteArray = _encode("Ada")
	for at: int in range(8, good.size(), 3):
		var bad: PackedByteArray = good.duplicate()
		bad[at] = bad[at] ^ 1
		var request: JoinRequest = JoinRequest.decode(bad)
		is_false(request.error == "" and request.is_proven(_challenge, _key), "byte %d" % at)


func test_key_derivation_is_pbkdf2() -> void:
	var salt: PackedByteArray = PackedByteArray(range(16))
	equal(PasswordKey.derive("secret", salt, 1000).hex_encode(), PBKDF2)


func test_answers() -> void:
	for why: String in ["the server is full (8 clients)", "zu groß 😀"]:
		equal(JoinReply.decode(JoinReply.refusal(why, false)).why, why)
		equal(JoinReply.decode(JoinReply.refusal(why, false)).kind, JoinReply.Kind.REFUSED)
		equal(JoinReply.decode(JoinReply.refusal(why, true)).kind, JoinReply.Kind.LATER)
	equal(JoinReply.decode(JoinReply.wait(7)).position, 7)
	var session: Session = Session.new()
	session.id = 9
	session.token = Crypto.new().generate_random_bytes(16)
	var rules: ServerRules = ServerRules.new()
	rules.level_name = "yard"
	rules.level_fingerprint = PackedByteArray(range(8))
	var said: Array[PackedByteArray] = [_challenge]
	var bytes: PackedByteArray = JoinReply.welcome(session, rules, _key, said)
	var welcome: JoinReply = JoinReply.decode(bytes)
	equal([welcome.kind, welcome.session], [JoinReply.Kind.WELCOME, 9])
	equal(welcome.token, session.token)
	equal([welcome.level_name, welcome.level_fingerprint], ["yard", rules.level_fingerprint])
	is_true(welcome.is_proven(_key, said))
	bytes[2] = 1
	is_false(JoinReply.decode(bytes).is_proven(_key, said), "another session")


func test_a_broken_answer_is_no_welcome() -> void:
	var broken: Array[PackedByteArray] = [[], [0], [1], [1, 0, 0], [0, 1, 0, 65], [2], [3], [9, 9]]
	for bytes: PackedByteArray in broken:
		var answer: JoinReply = JoinReply.decode(bytes)
		equal(answer.kind, JoinReply.Kind.REFUSED, str(bytes))
		not_equal(answer.why, "", str(bytes))


func _encode(p_name: String, p_role: Roles.Role = Roles.Role.TRAINEE) -> PackedByteArray:
	var request: JoinRequest = JoinRequest.new()
	request.name = p_name
	request.role = p_role
	request.rate = 30
	return request.encode(_challenge, _key)

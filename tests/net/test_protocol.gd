extends TestCase
## The greeting and its answer.


func test_hello_round_trip() -> void:
	for name: String in ["Ada", "Größe 東京 😀", "x".repeat(32)]:
		for role: Protocol.Role in [Protocol.Role.OBSERVER, Protocol.Role.TRAINEE]:
			var hello: Dictionary = Protocol.decode_hello(Protocol.encode_hello(role, name, 0.97))
			is_false(hello.has("error"), str(hello))
			equal(hello.get("name"), name)
			equal(hello.get("role"), int(role))
			equal(hello.get("hip_height"), 0.97)
			equal(hello.get("version"), Protocol.VERSION)


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
		var bytes: PackedByteArray = Protocol.encode_hello(Protocol.Role.OBSERVER, name, 0.97)
		equal(Protocol.decode_hello(bytes).get("name"), cases[name], name.left(40))


func test_other_versions_are_named() -> void:
	for version: int in [0, 2, 65537, 0xFFFFFFFF]:
		var bytes: PackedByteArray = Protocol.encode_hello(
			Protocol.Role.OBSERVER, "Ada", 0.97, version
		)
		var text: String = "the client speaks protocol version %d, the server 1" % version
		equal(Protocol.decode_hello(bytes), {"error": text})


func test_a_later_version_with_another_form_is_named() -> void:
	var bytes: PackedByteArray = "DSMT".to_ascii_buffer() + PackedByteArray([7, 0, 0, 0, 1, 2, 3])
	contains(Protocol.decode_hello(bytes)["error"], "version 7")


func test_heights_of_nobody() -> void:
	for height: float in [0.0, -1.0, 0.2, 2.0, INF, -INF, NAN]:
		var bytes: PackedByteArray = Protocol.encode_hello(Protocol.Role.TRAINEE, "Ada", height)
		var hello: Dictionary = Protocol.decode_hello(bytes)
		equal(hello.keys(), ["error"], "height %f" % height)


func test_unknown_role() -> void:
	var bytes: PackedByteArray = Protocol.encode_hello(Protocol.Role.TRAINEE, "Ada", 0.97)
	bytes[8] = 2
	contains(Protocol.decode_hello(bytes).get("error"), "role")


func test_foreign_bytes() -> void:
	var variant: PackedByteArray = var_to_bytes({"version": 1, "role": 0, "name": "Ada"})
	contains(Protocol.decode_hello(variant)["error"], "not in Dismount's form")
	contains(Protocol.decode_hello(PackedByteArray())["error"], "0 bytes")
	var large: PackedByteArray = Protocol.encode_hello(Protocol.Role.TRAINEE, "Ada", 0.97)
	large.resize(10000)
	contains(Protocol.decode_hello(large)["error"], "10000 bytes")


func test_answer_round_trip() -> void:
	for refusal: String in ["", "the server is full (8 clients)", "zu groß 😀"]:
		equal(Protocol.decode_answer(Protocol.encode_answer(refusal)), refusal)


func test_a_broken_answer_is_no_welcome() -> void:
	var broken: Array[PackedByteArray] = [[], [0], [1], [1, 0, 0], [0, 1, 0, 65], [1, 1, 0, 0xFF]]
	for bytes: PackedByteArray in broken:
		not_equal(Protocol.decode_answer(bytes), "", str(bytes))

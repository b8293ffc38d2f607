extends TestCase
## Addresses as people type them.


func test_addresses_and_names() -> void:
	for row: Array in [
		["server", "server", 7777],
		["  Server.Example.ORG. ", "server.example.org", 7777],
		["server:7000", "server", 7000],
		["127.0.0.1", "127.0.0.1", 7777],
		["127.0.0.1:1", "127.0.0.1", 1],
		["::1", "::1", 7777],
		["[::1]", "::1", 7777],
		["[::1]:65535", "::1", 65535],
		["2001:db8::7", "2001:db8::7", 7777],
		["[fe80::1%eth0]:7778", "fe80::1%eth0", 7778],
		["fe80::1%wlP2", "fe80::1%wlP2", 7777],
		["my_pc-2.local", "my_pc-2.local", 7777],
	]:
		var read: ServerAddress = ServerAddress.parse(row[0])
		equal(read.error, "", row[0])
		equal(read.host, row[1], row[0])
		equal(read.port, row[2], row[0])
		var again: ServerAddress = ServerAddress.parse(read.describe())
		equal([again.host, again.port], [read.host, read.port], "as it is shown: " + row[0])


func test_what_is_none_is_explained() -> void:
	var letters: String = "x".repeat(10000)
	for text: String in [
		"",
		" ",
		":",
		"server:",
		"server:0",
		"server:65536",
		"server:-1",
		"server:7777777",
		"a b",
		"[::1",
		"[::1]7777",
		"[::1]:",
		"[server]:7",
		"1.2.3",
		"1.2.3.4.5",
		"256.1.1.1",
		"::g",
		"fe80::1%",
		"fe80::1%a/b",
		"a..b",
		"-a",
		"a-",
		"höst",
		"\u202eabc",
		"a\nb",
		"a%b",
		letters,
		"[" + letters,
		"x:y:z",
		"http://server",
		"server:7e3",
		"server:+7",
	]:
		var read: ServerAddress = ServerAddress.parse(text)
		is_true(read.error != "" and read.error.ends_with("."), "no address: '%s'" % text.left(40))


func test_any_text_is_survived() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 7
	var alphabet: String = "ab1.:[]%-_/ \u200f\u0001é"
	var read: int = 0
	for _i: int in 20000:
		var text: String = ""
		for _letter: int in random.randi() % 12:
			text += alphabet[random.randi() % alphabet.length()]
		var address: ServerAddress = ServerAddress.parse(text)
		if address.error == "":
			read += 1
			var again: ServerAddress = ServerAddress.parse(address.describe())
			equal([again.error, again.port], ["", address.port], text)
	is_true(read > 100, "some are addresses")

extends TestCase
## How a platform's address is written.


func test_addresses_are_read() -> void:
	var address: PlatformAddress = PlatformAddress.parse("127.0.0.1:4123")
	equal([address.error, address.host, address.port], ["", "127.0.0.1", 4123])
	equal(address.format, PlatformSender.FORMAT_OWN)
	address = PlatformAddress.parse("localhost:20:outsim")
	equal([address.error, address.host, address.port], ["", "localhost", 20])
	equal(address.format, PlatformSender.FORMAT_OUTSIM)
	address = PlatformAddress.parse("[::1]:65535:outsim-12")
	equal([address.error, address.host, address.port], ["", "::1", 65535])
	equal([address.format, address.outsim_id], [PlatformSender.FORMAT_OUTSIM_WITH_ID, 12])


func test_what_is_no_address_is_named() -> void:
	for text: String in ["", "127.0.0.1", ":4123", "a:1:outsim:2", "[::1]4123", "[::1"]:
		contains(PlatformAddress.parse(text).error, "HOST:PORT", text)
	for text: String in ["a:0", "a:70000", "a:x", "a:-1"]:
		contains(PlatformAddress.parse(text).error, "1 to 65535", text)
	for text: String in ["a:1:moog", "a:1:outsim-", "a:1:outsim-0", "a:1:outsim-x"]:
		contains(PlatformAddress.parse(text).error, "outsim", text)

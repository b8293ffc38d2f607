extends TestCase
## Texts from strangers.


func test_what_cannot_be_seen_is_in_no_text() -> void:
	for code: int in [
		0x00,
		0x1B,
		0x7F,
		0x85,
		0xA0,
		0xAD,
		0x61C,
		0x115F,
		0x180E,
		0x2003,
		0x200B,
		0x200D,
		0x200F,
		0x2028,
		0x202E,
		0x2060,
		0x2066,
		0x2067,
		0x2068,
		0x2069,
		0x206F,
		0x2800,
		0x3000,
		0x3164,
		0xE123,
		0xFE0F,
		0xFEFF,
		0xFFFE,
		0x1FFFF,
		0xE0041,
		0xF0000,
	]:
		var text: String = "Ad" + String.chr(code) + "a" if code != 0 else "Ada"
		equal(ByteReader.clean(text), "Ada", "U+%04X is left out" % code)
		if code == 0:
			continue
		var bytes: PackedByteArray = text.to_utf8_buffer()
		var sized: PackedByteArray = [bytes.size(), 0]
		var reader: ByteReader = ByteReader.new(sized + bytes)
		equal(reader.read_text(64), "")
		is_true(reader.failed, "U+%04X is refused" % code)


func test_names_of_people_are_kept() -> void:
	for name: String in ["Zoë", "Владимир", "李小龍", "محمد", "אבי", "Ω≈ç", "José-María O'Neil", "🙂"]:
		equal(ByteReader.clean(name), name)
		var reader: ByteReader = ByteReader.new(ByteReader.text_bytes(name))
		equal(reader.read_text(128), name)
		is_true(reader.is_complete())

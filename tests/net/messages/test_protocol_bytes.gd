extends TestCase
## The worked bytes of docs/protocol-bytes.md are what the program sends, byte for byte.

const Samples: GDScript = preload("protocol_samples.gd")
const SnapshotStream: GDScript = preload("res://tests/wire/snapshot_stream.gd")
const PAGE: String = "res://docs/protocol-bytes.md"


func test_the_page_has_what_the_program_sends() -> void:
	var page: Dictionary[String, PackedByteArray] = _read_page()
	var made: Dictionary[String, PackedByteArray] = Samples.all()
	equal(page.keys(), made.keys(), "the messages of the page")
	for name: String in made:
		equal(page.get(name, PackedByteArray()).hex_encode(), made[name].hex_encode(), name)


func test_the_page_is_of_this_version() -> void:
	var text: String = FileAccess.get_file_as_string(PAGE)
	contains(text.get_slice("\n", 0), "version %d" % Protocol.VERSION)


func test_the_snapshots_of_the_page_say_what_it_says() -> void:
	var page: Dictionary[String, PackedByteArray] = _read_page()
	var decoder: SnapshotDecoder = SnapshotStream.decoder()
	equal(decoder.decode(page["key"]), SnapshotDecoder.OK)
	equal([decoder.get_tick(), decoder.get_tick_rate()], [1000, 60])
	equal(Array(decoder.get_bodies()), [1024])
	equal(decoder.decode(page["snapshot"]), SnapshotDecoder.OK)
	equal(decoder.get_tick(), 1001)


## The blocks of bytes under the headings of the page.
func _read_page() -> Dictionary[String, PackedByteArray]:
	var found: Dictionary[String, PackedByteArray] = {}
	var name: String = ""
	var is_block: bool = false
	for line: String in FileAccess.get_file_as_string(PAGE).split("\n"):
		if line.begins_with("## "):
			name = line.substr(3)
		elif line.begins_with("```"):
			is_block = not is_block
		elif is_block:
			var bytes: PackedByteArray = found.get_or_add(name, PackedByteArray())
			bytes.append_array(line.get_slice("#", 0).replace(" ", "").hex_decode())
			found[name] = bytes
	return found

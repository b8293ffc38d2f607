class_name PeopleMessage
extends RefCounted
## Whose motion a trainee's client sends, as bytes: reliably, at joining and whenever it changes.
##
## Little-endian: u8 message, u8 number of people, for each u8 index, f32 hip height (m), u8 number
## of lengths (0 or all limbs), that many f32 (m, 0 unknown), name and name
## of the avatar, each as u16 length and UTF-8.

## What is wrong with the packet that was decoded last, or an empty text.
static var error: String = ""


## The bytes of the cards of some people.
static func encode(p_people: Array[PersonCard]) -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.PEOPLE, p_people.size()]
	for card: PersonCard in p_people:
		bytes.append(card.index)
		bytes.append_array(PackedFloat32Array([card.hip_height]).to_byte_array())
		bytes.append(card.lengths.size())
		bytes.append_array(card.lengths.to_byte_array())
		bytes.append_array(ByteReader.text_bytes(card.name.left(Protocol.MAX_NAME)))
		bytes.append_array(ByteReader.text_bytes(card.avatar))
	return bytes


## The people in a packet; [member error] says what is wrong with it, and nobody is returned then.
static func decode(p_bytes: PackedByteArray) -> Array[PersonCard]:
	var people: Array[PersonCard] = []
	error = _read(p_bytes, people)
	if error != "":
		error = "a list of people that is none: " + error
		people.clear()
	return people


static func _read(p_bytes: PackedByteArray, p_people: Array[PersonCard]) -> String:
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	var count: int = reader.read_u8()
	if count > PersonCard.MAX_PEOPLE:
		return "%d people, %d are the most" % [count, PersonCard.MAX_PEOPLE]
	var taken: Dictionary[int, bool] = {}
	for _person: int in count:
		var card: PersonCard = PersonCard.new()
		card.index = reader.read_u8()
		card.hip_height = reader.read_float()
		card.lengths = reader.read_floats(mini(reader.read_u8(), Limbs.COUNT + 1))
		card.name = reader.read_text(4 * Protocol.MAX_NAME).left(Protocol.MAX_NAME)
		card.name = card.name.strip_edges()
		card.avatar = reader.read_text(PersonCard.MAX_AVATAR)
		if reader.failed:
			break
		if taken.has(card.index):
			return "number %d appears twice" % card.index
		taken[card.index] = true
		if card.find_fault() != "":
			return card.find_fault()
		p_people.append(card)
	return "" if reader.is_complete() else "%d bytes are not all of it" % p_bytes.size()

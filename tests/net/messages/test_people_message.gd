extends TestCase
## Whose motion a client says that it sends.

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 3


func test_round_trip() -> void:
	for count: int in PersonCard.MAX_PEOPLE + 1:
		var sent: Array[PersonCard] = []
		for index: int in count:
			sent.append(_card(PersonCard.MAX_PEOPLE - 1 - index))
		var got: Array[PersonCard] = PeopleMessage.decode(PeopleMessage.encode(sent))
		equal(PeopleMessage.error, "")
		equal(got.size(), count)
		for place: int in got.size():
			equal(got[place].index, sent[place].index)
			equal(got[place].name, sent[place].name)
			almost_equal(got[place].hip_height, sent[place].hip_height, 1e-6)
			equal(got[place].lengths, sent[place].lengths)
			equal(got[place].avatar, sent[place].avatar)


func test_nobody_is_taken_for_a_person() -> void:
	for height: float in [0.0, -1.0, 0.19, 2.0, INF, -INF, NAN]:
		var card: PersonCard = _card(0)
		card.hip_height = height
		_refuses([card], "hip height" if is_finite(height) else "")
	for length: float in [-0.1, 0.01, 1.3, INF, NAN]:
		var card: PersonCard = _card(0)
		card.lengths[4] = length
		_refuses([card], "LeftUpperArm" if is_finite(length) else "")
	_refuses([_card(0), _card(3), _card(0)], "twice")
	_refuses([_card(PersonCard.MAX_PEOPLE)], "at most")


## Any short text is carried: what it means is for who shows it to decide.
func test_names_of_avatars() -> void:
	for name: String in ["", "soldier", "../../user/x", "Ünïcode", "x".repeat(32)]:
		var card: PersonCard = _card(0)
		card.avatar = name
		var got: Array[PersonCard] = PeopleMessage.decode(PeopleMessage.encode([card]))
		equal(got.size(), 1, name)
		equal(got[0].avatar, name)
	var long: PersonCard = _card(0)
	long.avatar = "x".repeat(PersonCard.MAX_AVATAR + 1)
	_refuses([long], "")


func test_a_packet_cut_anywhere_is_refused() -> void:
	var bytes: PackedByteArray = PeopleMessage.encode([_card(0), _card(1)])
	for size: int in range(1, bytes.size()):
		equal(PeopleMessage.decode(bytes.slice(0, size)), [], "%d bytes" % size)
		not_equal(PeopleMessage.error, "", "%d bytes" % size)


func test_hostile_bytes() -> void:
	var good: PackedByteArray = PeopleMessage.encode([_card(0), _card(1)])
	for _round: int in 3000:
		var bytes: PackedByteArray = good.duplicate()
		for _change: int in _random.randi_range(1, 4):
			bytes[_random.randi_range(1, bytes.size() - 1)] = _random.randi_range(0, 255)
		for card: PersonCard in PeopleMessage.decode(bytes):
			equal(card.find_fault(), "")


func _refuses(p_people: Array[PersonCard], p_why: String) -> void:
	equal(PeopleMessage.decode(PeopleMessage.encode(p_people)), [])
	not_equal(PeopleMessage.error, "")
	if p_why != "":
		contains(PeopleMessage.error, p_why)


func _card(p_index: int) -> PersonCard:
	var card: PersonCard = PersonCard.new()
	card.index = p_index
	card.name = "Adä %d" % p_index
	card.avatar = ["", "show", "nobody knows it"][p_index % 3]
	card.hip_height = _random.randf_range(0.5, 1.2)
	if p_index % 2 == 0:
		for _limb: int in Limbs.COUNT:
			card.lengths.append(_random.randf_range(0.1, 0.6))
	return card

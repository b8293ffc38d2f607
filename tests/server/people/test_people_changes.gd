extends TestCase
## Bodies are made and removed a little in each tick, and no more than there is room for.

const SOLDIER: PackedScene = preload("res://scenes/actor/soldier.tscn")
const ROOM: int = 5

var _parent: Node3D = null
var _changes: PeopleChanges = null
var _bodies: Dictionary[int, Ragdoll] = {}
var _made: Array[int] = []


func before_each() -> void:
	_parent = Node3D.new()
	add_child(_parent)
	_bodies.clear()
	_made.clear()
	_changes = PeopleChanges.new(
		SOLDIER,
		_parent,
		func(key: int, _avatar: String) -> Transform3D:
			return Transform3D(Basis.IDENTITY, Vector3(2.5 * key, 0.0, 0.0))
	)
	_changes.max_people = ROOM
	_changes.made.connect(_on_made)
	_changes.left.connect(_on_left)


func after_each() -> void:
	_changes.close()
	_parent.free()


func test_a_body_takes_several_ticks() -> void:
	equal(_changes.take_list(7, [_card(0, 0.9), _card(1, 0.8)], "who"), 0)
	var ticks: int = _run()
	is_true(ticks > 4, "%d ticks for two bodies of their own sizes" % ticks)
	equal(_made, [PeopleChanges.key_of(7, 0), PeopleChanges.key_of(7, 1)], "in their order")
	equal(_parent.get_child_count(), 2)


func test_what_did_not_change_is_left_alone() -> void:
	_changes.take_list(7, [_card(0, 0.9), _card(1, 0.8)], "who")
	_run()
	var first: Ragdoll = _bodies[PeopleChanges.key_of(7, 0)]
	_made.clear()
	_changes.take_list(7, [_card(0, 0.9), _card(1, 0.8)], "who")
	equal(_run(), 0, "the same list is no work")
	_changes.take_list(7, [_card(0, 0.9), _card(1, 0.85)], "who")
	_run()
	equal(_made, [PeopleChanges.key_of(7, 1)])
	is_true(_bodies[PeopleChanges.key_of(7, 0)] == first)


func test_who_leaves_half_made_leaves_nothing_behind() -> void:
	for ticks: int in 12:
		_changes.take_list(7, [_card(0, 0.9)], "who")
		for _tick: int in ticks:
			_changes.advance()
		_changes.take_list(7, [], "who")
		_run()
		equal(_parent.get_child_count(), 0, "after %d ticks" % ticks)
		equal(_bodies.size(), 0)
		equal(_changes.count(), 0)


func test_the_size_may_change_while_the_body_is_made() -> void:
	for ticks: int in 8:
		_changes.take_list(7, [_card(0, 0.9)], "who")
		for _tick: int in ticks:
			_changes.advance()
		_changes.take_list(7, [_card(0, 0.7)], "who")
		_run()
		equal(_parent.get_child_count(), 1)
		var height: float = _bodies[PeopleChanges.key_of(7, 0)].get_hip_height()
		is_true(height < 0.78, "%.3f m after %d ticks" % [height, ticks])
		_changes.take_list(7, [], "who")
		_run()


func test_there_is_room_for_so_many_and_for_others_when_somebody_leaves() -> void:
	equal(_changes.take_list(7, [_card(0), _card(1), _card(2), _card(3)], ""), 0)
	equal(_changes.take_list(8, [_card(0), _card(1), _card(2)], ""), 2)
	equal(_changes.take_list(8, [_card(0), _card(1)], ""), 1, "asked again")
	_run()
	equal(_bodies.size(), ROOM)
	_changes.take_list(7, [_card(1)], "")
	equal(_changes.take_list(8, [_card(0), _card(1), _card(2)], ""), 0)
	_run()
	equal(_bodies.size(), 4)


func test_changing_for_ever_keeps_the_number_of_nodes() -> void:
	_changes.prepare()
	var nodes: int = 0
	for round_number: int in 12:
		for session: int in 3:
			_changes.take_list(session, [_card(0, 0.8 + 0.01 * round_number)], "")
		_run()
		if round_number == 2:
			nodes = _nodes()
	equal(_nodes(), nodes, "nodes")


func test_everybody_gets_the_body_of_the_own_avatar() -> void:
	_changes.prepare()
	var cards: Array[PersonCard] = [_card(0), _card(1), _card(2), _card(3)]
	cards[1].avatar = "civilian_woman"
	cards[2].avatar = "../person"
	cards[3].avatar = "show"
	_changes.take_list(7, cards, "")
	_run()
	var shown: Array[String] = []
	for index: int in cards.size():
		var figure: Node = _bodies[PeopleChanges.key_of(7, index)].get_node(^"Avatar")
		shown.append(figure.scene_file_path.get_file().get_basename())
	equal(shown, ["soldier", "civilian_woman", "soldier", "show"])
	cards[1] = _card(1)
	cards[1].avatar = "raider"
	_changes.take_list(7, cards, "")
	_run()
	equal(_made[-1], PeopleChanges.key_of(7, 1), "another avatar is another body")


## Ticks until all is done and tidied up.
func _run() -> int:
	var ticks: int = 0
	while not _changes.is_settled() or _changes.stats()["waste"] > 0:
		_changes.advance()
		ticks += 1
		if ticks > 5000:
			fail("it does not come to an end")
			break
	return ticks


static func _nodes() -> int:
	return int(Performance.get_monitor(Performance.OBJECT_NODE_COUNT))


static func _card(p_index: int, p_hip_height: float = 0.95) -> PersonCard:
	var card: PersonCard = PersonCard.of("n%d" % p_index, p_hip_height, p_index)
	card.lengths.resize(Limbs.COUNT)
	card.lengths[Limbs.LEFT_UPPER_LEG] = 0.45 * p_hip_height
	card.lengths[Limbs.LEFT_UPPER_LEG + 1] = 0.45 * p_hip_height
	return card


func _on_made(
	p_key: int, _p_wanted: PeopleChanges.Wanted, p_ragdoll: Ragdoll, p_joints: PersonSkeleton
) -> void:
	is_true(p_joints.is_sound())
	_made.append(p_key)
	_bodies[p_key] = p_ragdoll


func _on_left(p_key: int) -> void:
	_changes.discard(_bodies[p_key])
	_bodies.erase(p_key)

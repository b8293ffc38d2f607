extends TestCase
## Parts of large messages go a few in each tick, in order, and nobody waits for another's.

var _paced: PacedParts = PacedParts.new()
var _sent: Array = []


func before_each() -> void:
	_paced = PacedParts.new()
	_sent.clear()


func test_parts_go_in_their_order_a_few_in_a_tick() -> void:
	_paced.add(7, _parts(100, 1))
	_paced.add(7, _parts(10, 2))
	var ticks: int = 0
	while _paced.has(7):
		_paced.advance(_send)
		ticks += 1
		is_true(_sent.size() <= ticks * PacedParts.PER_TICK)
	equal(ticks, ceili(110.0 / PacedParts.PER_TICK))
	equal(_sent.map(_number_of), range(100) + range(10))


func test_sessions_take_turns() -> void:
	for session: int in 4:
		_paced.add(session, _parts(50, session))
	_paced.advance(_send)
	for session: int in 4:
		var mine: Array = _sent.filter(func(row: Array) -> bool: return row[0] == session)
		equal(mine.size(), PacedParts.PER_TICK / 4)


func test_who_leaves_gets_no_more() -> void:
	_paced.add(1, _parts(50, 1))
	_paced.add(2, _parts(2, 2))
	_paced.forget(1)
	_paced.advance(_send)
	equal(_sent.map(func(row: Array) -> int: return row[0]), [2, 2])
	is_false(_paced.has(2))


func _send(p_session: int, p_part: PackedByteArray) -> void:
	_sent.append([p_session, p_part])


static func _number_of(p_row: Array) -> int:
	return p_row[1][1]


static func _parts(p_count: int, p_message: int) -> Array[PackedByteArray]:
	var parts: Array[PackedByteArray] = []
	for number: int in p_count:
		parts.append(PackedByteArray([p_message, number]))
	return parts

extends TestCase
## How often lists of people count.

var _lists: PeopleLists = PeopleLists.new()


func before_each() -> void:
	_lists = PeopleLists.new()


func test_the_first_list_counts_at_once() -> void:
	_lists.take(7, [PersonCard.of("Ada", 0.95)])
	equal(_heights(_lists.take_due(10.0)), {7: [0.95]})
	equal(_lists.take_due(100.0), {}, "once")


func test_of_many_lists_the_last_counts_after_a_while() -> void:
	var applied: Array = []
	for step: int in 480:
		var now_s: float = 10.0 + step / 60.0
		_lists.take(7, [PersonCard.of("Ada", 0.9 + 0.001 * (step % 7))])
		applied.append_array(_lists.take_due(now_s).keys())
	equal(applied.size(), 4, "in 8 s")
	_lists.take(7, [PersonCard.of("Ada", 0.5)])
	equal(_lists.take_due(18.0 - 0.01).size(), 0)
	equal(_heights(_lists.take_due(18.1)), {7: [0.5]})


func test_sessions_do_not_wait_for_each_other() -> void:
	_lists.take(7, [PersonCard.of("Ada", 0.95)])
	equal(_lists.take_due(10.0).keys(), [7])
	_lists.take(7, [PersonCard.of("Ada", 0.9)])
	_lists.take(8, [PersonCard.of("Bob", 0.95)])
	equal(_lists.take_due(10.5).keys(), [8])
	_lists.forget(7)
	equal(_lists.take_due(100.0), {}, "who has left has no list")
	_lists.take(7, [])
	equal(_lists.take_due(100.0), {7: []}, "another session of that number begins anew")


static func _heights(p_lists: Dictionary[int, Array]) -> Dictionary:
	var heights: Dictionary = {}
	for session: int in p_lists:
		heights[session] = p_lists[session].map(
			func(card: PersonCard) -> float: return card.hip_height
		)
	return heights

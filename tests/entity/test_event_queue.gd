extends TestCase
## Events wait until their tick is shown, and come once.

var _queue: EventQueue = null


func before_each() -> void:
	_queue = EventQueue.new()


func test_events_come_at_the_shown_tick_in_order() -> void:
	for pair: Array in [[3, 30], [1, 10], [2, 20]]:
		_queue.push(_event(pair[0], pair[1]))
	equal([_numbers(9.9), _numbers(10.0), _numbers(25.5), _numbers(40.0)], [[], [1], [2], [3]])


func test_repeats_come_once() -> void:
	is_true(_queue.push(_event(7, 10)))
	is_false(_queue.push(_event(7, 10)))
	equal(_numbers(11.0), [7])
	is_false(_queue.push(_event(7, 10)))
	is_true(_queue.push(_event(7, 5000)), "the number is used again long after")


func test_events_of_another_time_are_dropped_and_the_queue_is_bounded() -> void:
	_queue.push(_event(1, 1000000))
	equal(_numbers(10.0), [])
	for number: int in 5000:
		_queue.push(_event(number, 100))
	var early: int = _numbers(10.0).size()
	equal(early, EventQueue.MAX_WAITING, "what is too much is played at once, or not taken")
	equal(_numbers(100.0).size(), EventQueue.MAX_WAITING)


func _numbers(p_shown: float) -> Array:
	return _queue.take(p_shown).map(func(each: EntityEvent) -> int: return each.number)


static func _event(p_number: int, p_tick: int) -> EntityEvent:
	var event: EntityEvent = EntityEvent.new()
	event.number = p_number
	event.tick = p_tick
	return event

extends TestCase
## Commands of a session: each once, in order, at their tick, and not too many.

var _queue: CommandQueue = null


func before_each() -> void:
	_queue = CommandQueue.new()


func test_repeats_and_late_ones_are_applied_once_and_in_order() -> void:
	for number: int in [0, 0, 1, 0, 1, 2]:
		_queue.push(_command(number, 10), 9)
	equal(_numbers(10), [0, 1, 2])
	equal(_queue.applied, 2)
	is_false(_queue.push(_command(1, 10), 11))
	equal(_numbers(11), [])


func test_a_command_waits_for_its_tick_but_not_for_long() -> void:
	_queue.push(_command(0, 12), 10)
	equal([_numbers(10), _numbers(11), _numbers(12)], [[], [], [0]])
	_queue.push(_command(1, 100000), 20)
	equal(_numbers(20 + CommandQueue.MAX_WAIT_TICKS - 1), [])
	equal(_numbers(20 + CommandQueue.MAX_WAIT_TICKS), [1])


func test_numbers_wrap() -> void:
	_queue.push(_command(65535, 0), 0)
	is_true(_queue.push(_command(0, 0), 0))
	equal(_numbers(1), [65535, 0])


func test_who_is_too_eager_is_refused() -> void:
	var taken: int = 0
	for number: int in 1000:
		taken += 1 if _queue.push(_command(number, 0), 0) else 0
	is_true(taken <= CommandQueue.MAX_WAITING)
	equal(_queue.refused, 1000 - taken)
	var later: int = 0
	for tick: int in 60:
		_queue.take(tick, 60)
		for each: int in 10:
			later += 1 if _queue.push(_command(1000 + tick * 10 + each, 0), tick) else 0
	is_true(later <= CommandQueue.MAX_PER_SECOND + CommandQueue.MAX_BURST)
	is_true(later >= CommandQueue.MAX_PER_SECOND - 10)


func _numbers(p_tick: int) -> Array:
	return _queue.take(p_tick, 60).map(func(each: EntityCommand) -> int: return each.number)


static func _command(p_number: int, p_tick: int) -> EntityCommand:
	var command: EntityCommand = EntityCommand.new()
	command.number = p_number
	command.tick = p_tick
	return command

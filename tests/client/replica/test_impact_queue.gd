extends TestCase
## Impacts are heard when their tick is shown.

var _queue: ImpactQueue = ImpactQueue.new()


func test_each_waits_for_its_tick() -> void:
	_queue.push(_at([12, 10, 11]))
	equal(_ticks(_queue.take(9.9)), [])
	equal(_ticks(_queue.take(11.2)), [10, 11])
	equal(_ticks(_queue.take(12.0)), [12])
	equal(_ticks(_queue.take(100.0)), [])


func test_what_is_late_or_far_ahead_is_dropped() -> void:
	_queue.push(_at([10, 99, 5000]))
	equal(_ticks(_queue.take(100.0)), [99])
	equal(_ticks(_queue.take(6000.0)), [])


func test_a_flood_costs_no_memory() -> void:
	for tick: int in 5000:
		_queue.push(_at([tick + 50]))
	equal(_ticks(_queue.take(4100.0)).size(), 0)
	is_true(_queue.take(5100.0).size() <= ImpactQueue.MAX_WAITING)


func test_another_world_begins_with_none() -> void:
	_queue.push(_at([10]))
	_queue.clear()
	equal(_ticks(_queue.take(11.0)), [])


func _at(p_ticks: Array[int]) -> Array[Impact]:
	var impacts: Array[Impact] = []
	for tick: int in p_ticks:
		var impact: Impact = Impact.new()
		impact.tick = tick
		impacts.append(impact)
	return impacts


func _ticks(p_impacts: Array[Impact]) -> Array[int]:
	var found: Array[int] = []
	for impact: Impact in p_impacts:
		found.append(impact.tick)
	return found

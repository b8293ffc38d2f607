extends TestCase
## The assignment with the least cost, against all permutations.

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 12


func test_it_is_the_best_of_all() -> void:
	for attempt: int in 60:
		var rows: int = 1 + attempt % 5
		var columns: int = rows + attempt % 3
		var costs: PackedFloat64Array = []
		for _cell: int in rows * columns:
			costs.append(roundf(_random.randf_range(-5.0, 5.0)) if attempt % 2 else _random.randf())
		var found: PackedInt32Array = BestAssignment.find(costs, rows, columns)
		var sum: float = 0.0
		for row: int in rows:
			equal(found.count(found[row]), 1)
			sum += costs[row * columns + found[row]]
		almost_equal(sum, _best(costs, columns, 0, rows, []), 1e-9)


func test_nothing_to_assign() -> void:
	equal(BestAssignment.find(PackedFloat64Array(), 0, 3), PackedInt32Array())


func _best(
	p_costs: PackedFloat64Array, p_columns: int, p_row: int, p_rows: int, p_taken: Array
) -> float:
	if p_row == p_rows:
		return 0.0
	var best: float = INF
	for column: int in p_columns:
		if not p_taken.has(column):
			var rest: float = _best(p_costs, p_columns, p_row + 1, p_rows, p_taken + [column])
			best = minf(best, p_costs[p_row * p_columns + column] + rest)
	return best

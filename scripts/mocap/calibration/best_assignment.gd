class_name BestAssignment
extends RefCounted
## The assignment of rows to columns with the least total cost: the Hungarian method with shortest
## augmenting paths, O(rows² columns) (Jonker and Volgenant, 1987).


## The column of each row. [param p_costs] is row by row; there are at least as many columns as
## rows.
static func find(p_costs: PackedFloat64Array, p_rows: int, p_columns: int) -> PackedInt32Array:
	# Counted from 1; 0 stands for none.
	var row_price: PackedFloat64Array = _filled(p_rows + 1, 0.0)
	var price: PackedFloat64Array = _filled(p_columns + 1, 0.0)
	var row_of: PackedInt32Array = PackedInt32Array()
	row_of.resize(p_columns + 1)
	for row: int in range(1, p_rows + 1):
		row_of[0] = row
		var before: PackedInt32Array = PackedInt32Array()
		before.resize(p_columns + 1)
		var least: PackedFloat64Array = _filled(p_columns + 1, INF)
		var visited: PackedByteArray = PackedByteArray()
		visited.resize(p_columns + 1)
		var column: int = 0
		while row_of[column] != 0:
			visited[column] = 1
			var from: int = row_of[column]
			var next: int = 0
			var step: float = INF
			for to: int in range(1, p_columns + 1):
				if visited[to] != 0:
					continue
				var cost: float = p_costs[(from - 1) * p_columns + to - 1]
				cost -= row_price[from] + price[to]
				if cost < least[to]:
					least[to] = cost
					before[to] = column
				if least[to] < step:
					step = least[to]
					next = to
			for to: int in p_columns + 1:
				if visited[to] != 0:
					row_price[row_of[to]] += step
					price[to] -= step
				else:
					least[to] -= step
			column = next
		while column != 0:
			row_of[column] = row_of[before[column]]
			column = before[column]
	var found: PackedInt32Array = PackedInt32Array()
	found.resize(p_rows)
	for column: int in range(1, p_columns + 1):
		if row_of[column] != 0:
			found[row_of[column] - 1] = column - 1
	return found


static func _filled(p_size: int, p_value: float) -> PackedFloat64Array:
	var found: PackedFloat64Array = PackedFloat64Array()
	found.resize(p_size)
	found.fill(p_value)
	return found

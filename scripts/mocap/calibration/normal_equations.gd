class_name NormalEquations
extends RefCounted
## Weighted linear least squares in few unknowns: equations are added one by one, each with the
## variance of its error.

var _size: int = 0
var _matrix: PackedFloat64Array = PackedFloat64Array()
var _right: PackedFloat64Array = PackedFloat64Array()


func _init(p_unknowns: int) -> void:
	_size = p_unknowns
	_matrix.resize(p_unknowns * p_unknowns)
	_right.resize(p_unknowns)


## Adds: the unknowns, times their coefficients, are a value, with an error of a variance.
func add(p_row: PackedFloat64Array, p_value: float, p_variance: float) -> void:
	var weight: float = 1.0 / p_variance
	for row: int in _size:
		var part: float = p_row[row] * weight
		if part == 0.0:
			continue
		_right[row] += part * p_value
		for column: int in _size:
			_matrix[row * _size + column] += part * p_row[column]


## The covariance of the unknowns, row by row: the inverse of the matrix (Gauss and Jordan). What no
## equation tells has a variance of [constant INF].
func covariance() -> PackedFloat64Array:
	var left: PackedFloat64Array = _matrix.duplicate()
	var found: PackedFloat64Array = PackedFloat64Array()
	found.resize(_size * _size)
	for at: int in _size:
		found[at * _size + at] = 1.0
	for pivot: int in _size:
		# The matrix is symmetric and not negative: its diagonal is pivot enough.
		var scale: float = left[pivot * _size + pivot]
		if scale < 1e-12:
			found.fill(0.0)
			for at: int in _size:
				found[at * _size + at] = INF
			return found
		for column: int in _size:
			left[pivot * _size + column] /= scale
			found[pivot * _size + column] /= scale
		for row: int in _size:
			var part: float = left[row * _size + pivot]
			if row == pivot or part == 0.0:
				continue
			for column: int in _size:
				left[row * _size + column] -= part * left[pivot * _size + column]
				found[row * _size + column] -= part * found[pivot * _size + column]
	return found


## The unknowns, with the covariance that [method covariance] gave.
func solution(p_covariance: PackedFloat64Array) -> PackedFloat64Array:
	var found: PackedFloat64Array = PackedFloat64Array()
	found.resize(_size)
	for row: int in _size:
		for column: int in _size:
			found[row] += p_covariance[row * _size + column] * _right[column]
	return found

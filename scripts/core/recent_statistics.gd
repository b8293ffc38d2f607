class_name RecentStatistics
extends RefCounted
## Mean and percentiles of the last values of a stream that never ends.

## Values that count.
const KEPT: int = 3600

var _values: PackedFloat64Array = PackedFloat64Array()
var _next: int = 0


## Adds a value; beyond [constant KEPT] it takes the place of the oldest.
func add(p_value: float) -> void:
	if _values.size() < KEPT:
		_values.append(p_value)
	else:
		_values[_next] = p_value
		_next = (_next + 1) % KEPT


## Number of values that count.
func count() -> int:
	return _values.size()


## The value that a fraction of the values does not exceed, or 0 without values. Of the last so many
## only, if [param p_last] is not 0.
func percentile(p_fraction: float, p_last: int = 0) -> float:
	if _values.is_empty():
		return 0.0
	var sorted: PackedFloat64Array = _values.duplicate()
	if p_last > 0 and p_last < _values.size():
		# The newest is before _next, or at the end.
		var end: int = _next if _next > 0 else _values.size()
		sorted = _values.slice(maxi(end - p_last, 0), end)
		if end < p_last:
			sorted.append_array(_values.slice(_values.size() - (p_last - end)))
	sorted.sort()
	return sorted[clampi(ceili(p_fraction * sorted.size()) - 1, 0, sorted.size() - 1)]

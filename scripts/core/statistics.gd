class_name Statistics
extends RefCounted
## Mean and percentiles of values: of all, or of the last ones of a stream that never ends.

## Values that [method recent] keeps.
const RECENT: int = 3600

var _values: PackedFloat64Array = PackedFloat64Array()
# Values that are kept, 0 for all.
var _kept: int = 0
var _next: int = 0


## For a stream that never ends: a value beyond [constant RECENT] replaces the oldest.
static func recent() -> Statistics:
	var statistics: Statistics = Statistics.new()
	statistics._kept = RECENT
	return statistics


## Adds a value.
func add(p_value: float) -> void:
	if _kept == 0 or _values.size() < _kept:
		_values.append(p_value)
	else:
		_values[_next] = p_value
		_next = (_next + 1) % _kept


## Number of values that count.
func count() -> int:
	return _values.size()


## The mean, or 0 without values.
func mean() -> float:
	var sum: float = 0.0
	for value: float in _values:
		sum += value
	return sum / _values.size() if not _values.is_empty() else 0.0


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

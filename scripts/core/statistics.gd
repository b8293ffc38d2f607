class_name Statistics
extends RefCounted
## Collects values and tells their mean, percentiles and number.

var _values: PackedFloat64Array = PackedFloat64Array()


## Adds a value.
func add(p_value: float) -> void:
	_values.append(p_value)


## Number of values.
func count() -> int:
	return _values.size()


## The mean, or 0 without values.
func mean() -> float:
	var sum: float = 0.0
	for value: float in _values:
		sum += value
	return sum / _values.size() if not _values.is_empty() else 0.0


## The value that a fraction of the values does not exceed, or 0 without values.
func percentile(p_fraction: float) -> float:
	if _values.is_empty():
		return 0.0
	var sorted: PackedFloat64Array = _values.duplicate()
	sorted.sort()
	return sorted[clampi(ceili(p_fraction * sorted.size()) - 1, 0, sorted.size() - 1)]

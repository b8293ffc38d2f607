class_name LatencyHistogram
extends RefCounted
## Counts delays in narrow bins: mean, deviation and percentiles of any number of them in a fixed
## amount of memory. Up to half a second the bins are equally wide; beyond they grow with the delay,
## so that percentiles are of the same delays as the mean on the slowest machine too.

## Width of a bin, ms.
const BIN_MS: float = 0.25
## Where the bins begin, ms: estimates of clocks may make a delay seem negative.
const MIN_MS: float = -25.0
## Number of bins of that width.
const EVEN_BINS: int = 2100
## How much wider each bin beyond them is.
const GROWTH: float = 1.01
## Number of all bins: the last ends at 75 s. What is beyond the first or the last is counted in it.
const BINS: int = EVEN_BINS + 500

## Where the even bins end, ms.
const _EVEN_END_MS: float = MIN_MS + EVEN_BINS * BIN_MS

var _bins: PackedInt32Array = PackedInt32Array()
var _count: int = 0
var _mean: float = 0.0
# Sum of the squares of the differences from the mean (Welford 1962).
var _squares: float = 0.0


func _init() -> void:
	_bins.resize(BINS)


## Counts a delay, ms. What is no number is left out.
func add(p_ms: float) -> void:
	if not is_finite(p_ms):
		return
	_bins[_bin_of(p_ms)] += 1
	_count += 1
	var off: float = p_ms - _mean
	_mean += off / _count
	_squares += off * (p_ms - _mean)


## Counts all that another has counted.
func merge(p_other: LatencyHistogram) -> void:
	if p_other._count == 0:
		return
	for bin: int in BINS:
		_bins[bin] += p_other._bins[bin]
	var both: int = _count + p_other._count
	var off: float = p_other._mean - _mean
	_squares += p_other._squares + off * off * _count * p_other._count / both
	_mean += off * p_other._count / both
	_count = both


## How many there are.
func count() -> int:
	return _count


## Their mean, ms; 0 without any.
func mean() -> float:
	return _mean


## Their standard deviation, ms.
func deviation() -> float:
	return sqrt(_squares / _count) if _count > 0 else 0.0


## What a fraction of them does not exceed, ms, as exact as the bins are; 0 without any.
func percentile(p_fraction: float) -> float:
	var rank: int = clampi(ceili(p_fraction * _count), 1, _count)
	var sum: int = 0
	for bin: int in BINS if _count > 0 else 0:
		sum += _bins[bin]
		if sum >= rank:
			return _middle_of(bin)
	return 0.0


## How many lie between two delays, ms, for each of so many equal steps between them.
func coarse(p_from_ms: float, p_to_ms: float, p_steps: int) -> PackedInt32Array:
	var result: PackedInt32Array = PackedInt32Array()
	result.resize(p_steps)
	for bin: int in BINS:
		var middle: float = _middle_of(bin)
		if _bins[bin] > 0 and middle >= p_from_ms and middle < p_to_ms:
			var step: int = int((middle - p_from_ms) / (p_to_ms - p_from_ms) * p_steps)
			result[mini(step, p_steps - 1)] += _bins[bin]
	return result


## The stats for a report.
func stats() -> Dictionary:
	return {
		"count": _count,
		"mean_ms": mean(),
		"sd_ms": deviation(),
		"p50_ms": percentile(0.5),
		"p95_ms": percentile(0.95),
		"p99_ms": percentile(0.99),
	}


static func _bin_of(p_ms: float) -> int:
	if p_ms < _EVEN_END_MS:
		return maxi(floori((p_ms - MIN_MS) / BIN_MS), 0)
	return mini(EVEN_BINS + floori(log(p_ms / _EVEN_END_MS) / log(GROWTH)), BINS - 1)


## The middle of a bin, ms.
static func _middle_of(p_bin: int) -> float:
	if p_bin < EVEN_BINS:
		return MIN_MS + (p_bin + 0.5) * BIN_MS
	return _EVEN_END_MS * pow(GROWTH, p_bin - EVEN_BINS + 0.5)

class_name Allowance
extends RefCounted
## Limits how often something may happen, by key: a token bucket for each.

## Greatest number of keys; beyond it those with full buckets are forgotten, then the oldest.
const MAX_KEYS: int = 4096

var _burst: float = 1.0
var _per_second: float = 1.0
var _left: Dictionary[Variant, float] = {}
var _seen_s: Dictionary[Variant, float] = {}


func _init(p_burst: float, p_per_second: float) -> void:
	_burst = p_burst
	_per_second = p_per_second


## Whether a key has one left, at a time, s.
func has(p_key: Variant, p_now_s: float) -> bool:
	return _left_at(p_key, p_now_s) >= 1.0


## Takes one, if it is left.
func take(p_key: Variant, p_now_s: float) -> bool:
	var left: float = _left_at(p_key, p_now_s)
	if left < 1.0:
		return false
	if not _left.has(p_key) and _left.size() >= MAX_KEYS:
		_make_room(p_now_s)
	_left[p_key] = left - 1.0
	_seen_s[p_key] = p_now_s
	return true


## The last one was none.
func give_back(p_key: Variant) -> void:
	if _left.has(p_key):
		_left[p_key] = minf(_left[p_key] + 1.0, _burst)


## Seconds until a key has one left.
func wait_s(p_key: Variant, p_now_s: float) -> float:
	return maxf(1.0 - _left_at(p_key, p_now_s), 0.0) / _per_second


## Forgets a key.
func forget(p_key: Variant) -> void:
	_left.erase(p_key)
	_seen_s.erase(p_key)


func _left_at(p_key: Variant, p_now_s: float) -> float:
	if not _left.has(p_key):
		return _burst
	return minf(_left[p_key] + (p_now_s - _seen_s[p_key]) * _per_second, _burst)


func _make_room(p_now_s: float) -> void:
	for key: Variant in _left.keys():
		if _left_at(key, p_now_s) >= _burst:
			forget(key)
	if _left.size() >= MAX_KEYS:
		forget(_left.keys()[0])

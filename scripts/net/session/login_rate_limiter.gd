class_name LoginRateLimiter
extends RefCounted
## Limits wrong passwords from an address: a few at once, then one at a time, rarely.

## Maximum of wrong passwords at once.
const BURST: int = 5
## Seconds after which one more is allowed.
const PER_GUESS_S: float = 2.0
## Addresses that are remembered; the oldest go.
const MAX_ADDRESSES: int = 4096

var _left: Dictionary[String, float] = {}
var _seen_usec: Dictionary[String, int] = {}


## Whether an address may guess at a time, µs.
func may_guess(p_address: String, p_now_usec: int) -> bool:
	return _refresh(p_address, p_now_usec) >= 1.0


## Takes note of a wrong password.
func note_wrong(p_address: String, p_now_usec: int) -> void:
	_left[p_address] = maxf(_refresh(p_address, p_now_usec) - 1.0, 0.0)
	_seen_usec[p_address] = p_now_usec
	if _left.size() > MAX_ADDRESSES:
		var oldest: String = _left.keys()[0]
		_left.erase(oldest)
		_seen_usec.erase(oldest)


func _refresh(p_address: String, p_now_usec: int) -> float:
	if not _left.has(p_address):
		return BURST
	var since_s: float = (p_now_usec - _seen_usec[p_address]) / 1e6
	return minf(_left[p_address] + since_s / PER_GUESS_S, BURST)

class_name LateStart
extends RefCounted
## How long a frame can wait before work on it begins, where the screen paces the frames: input that
## is read later is newer when it is seen.
##
## The engine begins a frame as soon as the one before is handed over, works, and then waits for the
## screen. This class moves the wait before the work. The expected work is the longest of the last
## frames; after a frame that comes too late the wait is shorter for some time.

## Margin before the screen's refresh, µs: refreshes are not quite even.
const SPARE_USEC: int = 2500
## Number of frames whose work is considered.
const FRAMES: int = 90
## Periods after which a frame counts as missed.
const MISSED: float = 1.5
## What a miss adds to the margin, µs, and how quickly that decays, µs a frame.
const PENALTY_USEC: int = 2000
const FORGIVES_USEC: int = 4

var _work: PackedInt64Array = []
var _next: int = 0
var _penalty_usec: int = 0
var _last_usec: int = -1


## Takes what work on a frame took, without waiting, µs.
func worked(p_usec: int) -> void:
	if _work.size() < FRAMES:
		_work.append(p_usec)
		return
	_work[_next] = p_usec
	_next = (_next + 1) % FRAMES


## How long the frame that could begin now (µs) should wait, µs, at a period of the screen, µs; 0
## where nothing is known of the screen or of the work.
func wait_usec(p_now_usec: int, p_period_usec: int) -> int:
	var since: int = p_now_usec - _last_usec if _last_usec >= 0 else 0
	_last_usec = p_now_usec
	if p_period_usec <= 0 or _work.size() < FRAMES:
		return 0
	_penalty_usec = maxi(_penalty_usec - FORGIVES_USEC, 0)
	if since > roundi(MISSED * p_period_usec):
		_penalty_usec = mini(_penalty_usec + PENALTY_USEC, p_period_usec)
	var most: int = 0
	for work: int in _work:
		most = maxi(most, work)
	return maxi(p_period_usec - most - SPARE_USEC - _penalty_usec, 0)

extends RefCounted
## Compares where a body is with where the person really was, tick by tick.

## Sole points that move slower than this in truth (m/s) stand.
const STANDS_BELOW: float = 0.1
## And are not higher above the lowest one, m.
const STANDS_WITHIN: float = 0.03
## Whoever moves so far (m) from one tick to the next has been put elsewhere by the file.
const _TELEPORT: float = 0.5

## Greatest horizontal distance to the truth, m.
var worst: float = 0.0
## The way that the person really went, m.
var way: float = 0.0
## Deviation of the root's height from the truth.
var height: Statistics = Statistics.new()
## Speed of points that truly stand still, m/s.
var skate: Statistics = Statistics.new()
## Flights of the truth, flights that were found, and flights that were not there.
var flights: int = 0
var found: int = 0
var invented: int = 0
## Where the body and the person were last, m.
var last: Vector3 = Vector3.ZERO
var last_true: Vector3 = Vector3.ZERO

var _offset: Vector3 = Vector3.INF
var _was_flying: bool = false
var _flew: bool = false
var _seen: bool = false
var _overlaps: bool = false


## Takes the root's place and the truth, m. The first pair is taken for the same place.
func add_root(p_root: Vector3, p_true: Vector3) -> void:
	if not _offset.is_finite():
		_offset = p_root - p_true
		_offset.y = 0.0
		last_true = p_true
	var jump: Vector3 = p_true - last_true
	if jump.length() > _TELEPORT:
		_offset -= Vector3(jump.x, 0.0, jump.z)
		last_true += Vector3(jump.x, 0.0, jump.z)
	var off: Vector3 = p_root - p_true - _offset
	height.add(absf(off.y))
	worst = maxf(worst, Vector2(off.x, off.z).length())
	way += Vector2(p_true.x - last_true.x, p_true.z - last_true.z).length()
	last = p_root - _offset
	last_true = p_true


## Takes whether the person flies in truth, and whether that was noticed.
func add_flight(p_true: bool, p_noticed: bool) -> void:
	if p_true and not _was_flying:
		flights += 1
		_seen = false
	if p_true and p_noticed and not _seen:
		_seen = true
		found += 1
	if p_noticed and not _flew:
		_overlaps = false
	_overlaps = _overlaps or (p_noticed and (p_true or _was_flying))
	if _flew and not p_noticed and not _overlaps:
		invented += 1
	_was_flying = p_true
	_flew = p_noticed


## Greatest travel error as a share of the way, percent.
func travel_percent() -> float:
	return 100.0 * worst / maxf(way, 0.01)


## Whether the body ends on the tread on which the person does.
func is_on_tread(p_rise: float, p_tread: float) -> bool:
	var off: Vector3 = last - last_true
	return absf(off.y) < absf(p_rise) / 2.0 and absf(off.z) < p_tread / 2.0

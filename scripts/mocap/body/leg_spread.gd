class_name LegSpread
extends RefCounted
## How much legs turn in their joints other than by bending: little between true neighbours,
## since knees are hinges and ankles nearly so; much if a thigh is taken for the other leg's.
##
## Offsets do not count, only how far the turns spread about their mean.

## The mounts of both legs, see [BodyMounts].
const MOUNTS: PackedInt32Array = [
	BodyMounts.LEFT_THIGH,
	BodyMounts.LEFT_SHANK,
	BodyMounts.LEFT_FOOT,
	BodyMounts.RIGHT_THIGH,
	BodyMounts.RIGHT_SHANK,
	BodyMounts.RIGHT_FOOT
]
## The joints: mounts that are neighbours.
const JOINTS: Array[Vector2i] = [
	Vector2i(11, 12), Vector2i(12, 13), Vector2i(14, 15), Vector2i(15, 16)
]
## Exchanges that are judged.
const PAIRS: Array[Vector2i] = [
	Vector2i(12, 13), Vector2i(15, 16), Vector2i(11, 14), Vector2i(12, 15), Vector2i(13, 16)
]
## An exchange must reduce the sum of the joints' spreads by this much, degrees, and to less than
## this share.
const GAIN_DEG: float = 5.0
const EXPLAINS: float = 0.7

var _most: int = 100
# For each pair of mounts, by smaller * 32 + larger: turns about the two axes that are no hinge.
var _turns: Dictionary[int, Turns] = {}


## The turns of a pair of mounts.
class Turns:
	## The newest ones, rad, in a ring.
	var ring: PackedVector2Array = PackedVector2Array()
	## Where the next one goes.
	var next: int = 0
	## Their sum, and that of their squared lengths.
	var sum: Vector2 = Vector2.ZERO
	var squares: float = 0.0

	## Adds one; beyond a number the oldest goes.
	func add(p_turn: Vector2, p_most: int) -> void:
		if ring.size() < p_most:
			ring.append(p_turn)
		else:
			sum -= ring[next]
			squares -= ring[next].length_squared()
			ring[next] = p_turn
			next = (next + 1) % p_most
		sum += p_turn
		squares += p_turn.length_squared()

	## How far they are from their mean, rad.
	func spread() -> float:
		var mean: Vector2 = sum / ring.size()
		return sqrt(maxf(squares / ring.size() - mean.length_squared(), 0.0))


func _init(p_most: int) -> void:
	_most = p_most


## Forgets everything.
func clear() -> void:
	_turns.clear()


## Takes a pose: for each mount of [BodyMounts] a rotation from the reset pose, or null.
func add(p_pose: Array) -> void:
	for first: int in MOUNTS:
		for second: int in MOUNTS:
			if first >= second or p_pose[first] == null or p_pose[second] == null:
				continue
			var above: Quaternion = p_pose[first]
			var turn: Vector3 = Rotations.vector(above.inverse() * p_pose[second])
			var key: int = first * 32 + second
			if not _turns.has(key):
				_turns[key] = Turns.new()
			_turns[key].add(Vector2(turn.y, turn.z), _most)


## Sum of the spreads of the joints if two mounts are exchanged (zero: as they are), degrees; NaN
## if no joint is known.
func total_deg(p_exchange: Vector2i) -> float:
	var sum: float = NAN
	for joint: Vector2i in JOINTS:
		var first: int = _after(joint.x, p_exchange)
		var second: int = _after(joint.y, p_exchange)
		var spread: float = _spread_deg(mini(first, second) * 32 + maxi(first, second))
		if not is_nan(spread):
			sum = spread if is_nan(sum) else sum + spread
	return sum


## The exchange that makes knees and ankles the hinges that they should be; zero if there is none.
func find_swap() -> Vector2i:
	var now: float = total_deg(Vector2i.ZERO)
	var found: Vector2i = Vector2i.ZERO
	if is_nan(now):
		return found
	var best: float = minf(now - GAIN_DEG, now * EXPLAINS)
	for pair: Vector2i in PAIRS:
		# With only some of the mounts worn an exchange could hide a joint instead of correcting it.
		if _joints_known(pair) < _joints_known(Vector2i.ZERO):
			continue
		var then: float = total_deg(pair)
		if then < best - 0.01:
			best = then
			found = pair
	return found


func _joints_known(p_exchange: Vector2i) -> int:
	var known: int = 0
	for joint: Vector2i in JOINTS:
		var first: int = _after(joint.x, p_exchange)
		var second: int = _after(joint.y, p_exchange)
		known += 1 if _turns.has(mini(first, second) * 32 + maxi(first, second)) else 0
	return known


static func _after(p_mount: int, p_exchange: Vector2i) -> int:
	if p_mount == p_exchange.x:
		return p_exchange.y
	return p_exchange.x if p_mount == p_exchange.y else p_mount


func _spread_deg(p_key: int) -> float:
	return rad_to_deg(_turns[p_key].spread()) if _turns.has(p_key) else NAN

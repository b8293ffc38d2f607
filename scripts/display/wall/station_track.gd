class_name StationTrack
extends RefCounted
## Where the first client of a station has it in the world, and its viewer's eyes, by the tick that
## is shown there: pure, of its last messages.
##
## Another client shows a tick of which no message can have come yet: one more frame of the first
## client and what the network delays. So it goes on from the last messages as the station moves:
## straight on, or round a curve. What moves faster than anything does is a cut, such as to another
## view: nothing lies between.

## Messages that are kept.
const _KEPT: int = 16
## Time for which the station's motion is extrapolated, s: two frames of a slow client and 20 ms of
## jitter.
const _ONWARD_S: float = 0.1
## Least time over which its motion is measured, s, where that much is known.
const _MEASURED_S: float = 0.012
## Speed that counts as a cut, m/s and rad/s.
const _FASTEST_MPS: float = 300.0
const _FASTEST_RADPS: float = 20.0

var _messages: Array[StationMessage] = []


## Takes what the first client says; older than the newest it counts for nothing.
func take(p_message: StationMessage) -> void:
	if not _messages.is_empty():
		var last: StationMessage = _messages[-1]
		if p_message.sender != last.sender or p_message.tick < last.tick:
			_messages.clear()
		elif p_message.tick == last.tick:
			_messages.pop_back()
	if not _messages.is_empty() and _is_cut(_messages[-1], p_message):
		_messages.clear()
	_messages.append(p_message)
	if _messages.size() > _KEPT:
		_messages.pop_front()


## Forgets all.
func clear() -> void:
	_messages.clear()


## The station and the eyes at a tick: mount, eye and right of the message are those; null: nothing
## is known.
func at(p_tick: float) -> StationMessage:
	if _messages.is_empty():
		return null
	var after: int = 0
	while after < _messages.size() and _messages[after].tick < p_tick:
		after += 1
	if after == 0:
		return _messages[0]
	if after < _messages.size():
		return _between(_messages[after - 1], _messages[after], p_tick)
	var last: StationMessage = _messages[-1]
	var tick: float = minf(p_tick, last.tick + _ONWARD_S * last.rate)
	for before: int in range(_messages.size() - 2, -1, -1):
		var is_long: bool = last.tick - _messages[before].tick >= _MEASURED_S * last.rate
		if is_long or before == 0:
			return _between(_messages[before], last, tick)
	return last


## The movement from one to the other at a tick between them, or after both.
static func _between(p_from: StationMessage, p_to: StationMessage, p_tick: float) -> StationMessage:
	var part: float = (p_tick - p_from.tick) / (p_to.tick - p_from.tick)
	var found: StationMessage = StationMessage.new()
	found.sender = p_to.sender
	found.tick = p_tick
	found.rate = p_to.rate
	found.eye = p_from.eye.lerp(p_to.eye, part)
	var right: Vector3 = p_from.right.lerp(p_to.right, part)
	found.right = right.normalized() if right.length() > 0.1 else p_to.right
	var offset: Transform3D = p_from.mount.affine_inverse() * p_to.mount
	var turn: Quaternion = offset.basis.get_rotation_quaternion()
	var axis: Vector3 = turn.get_axis()
	var angle: float = wrapf(turn.get_angle(), -PI, PI)
	var by: Basis = Basis.IDENTITY
	var half: Basis = Basis.IDENTITY
	if absf(angle) > 1e-5 and axis.is_normalized():
		by = Basis(axis, angle * part)
		# The chord of a longer or shorter arc points elsewhere by half of what the turn differs.
		half = Basis(axis, angle * (part - 1.0) * 0.5)
	found.mount = p_from.mount * Transform3D(by, half * offset.origin * part)
	return found


static func _is_cut(p_from: StationMessage, p_to: StationMessage) -> bool:
	var seconds: float = maxf((p_to.tick - p_from.tick) / p_to.rate, 1e-3)
	var metres: float = p_from.mount.origin.distance_to(p_to.mount.origin)
	var one: Quaternion = p_from.mount.basis.get_rotation_quaternion()
	var angle: float = one.angle_to(p_to.mount.basis.get_rotation_quaternion())
	return metres > _FASTEST_MPS * seconds or angle > _FASTEST_RADPS * seconds

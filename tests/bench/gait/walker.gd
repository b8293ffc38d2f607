extends RefCounted
## A made-up person who walks: poses of whole-body motion whose true travel is known.
##
## Feet strike with the heel, roll, and push off with the ball, so that points that stand do not
## move at all. Legs follow by two-bone inverse kinematics in the sagittal plane. The person walks
## along +Z from standing, and stands again at the end. Frame: Godot's, metres, seconds.


## One foot on the ground.
class Footfall:
	## -1 for the left foot, 1 for the right one.
	var side: int = 0
	## Where the sole's ball is, m along the way.
	var place: float = 0.0
	## Height of the ground there, m.
	var height: float = 0.0
	## When it comes down and goes up again, s.
	var down_s: float = -INF
	var up_s: float = INF


## How long the person stands at first and at last, s.
const STAND_S: float = 1.0
const _STRIKE: float = 0.3  # Pitch of the foot at heel strike, rad.
const _PUSH: float = -0.6  # At push-off.
const _STRIKE_S: float = 0.1
const _PUSH_S: float = 0.2
const _BEHIND: float = 0.235  # Of a tread behind the ball of a foot on it.

## Duration of the whole, s.
var duration: float = 0.0
## Length of the way, m.
var way: float = 0.0
## Height that the person ends at, m.
var end_height: float = 0.0

var _falls: Array[Footfall] = []
var _steps: Array[Vector3] = []  # Time, place, height of the hips.
var _swing_s: float = 0.0
var _lift: float = 0.06
var _tread: float = 0.0
var _rise: float = 0.0
var _treads: int = 0
var _rolls: bool = true
var _thigh: float = 0.4
var _shin: float = 0.4
var _hip: Vector3 = Vector3.ZERO  # The left hip joint from the root's.
var _ankle: Vector2 = Vector2.ZERO  # From the ball: behind, above.
var _heel: float = 0.1  # Of the heel behind the ball.
var _stand: float = 0.9  # Height of the root over the ground.


## Takes the measures of a body.
func _init(p_profile: RagdollProfile) -> void:
	var root: RagdollLimb = p_profile.find(&"Hips")
	var thigh: RagdollLimb = p_profile.find(&"LeftUpperLeg")
	var shin: RagdollLimb = p_profile.find(&"LeftLowerLeg")
	var foot: RagdollLimb = p_profile.find(&"LeftFoot")
	_thigh = thigh.anchor.distance_to(shin.anchor)
	_shin = shin.anchor.distance_to(foot.anchor)
	_hip = thigh.anchor - root.anchor
	var heel: Vector3 = foot.contact_points[0]
	var ball: Vector3 = (foot.contact_points[1] + foot.contact_points[2]) / 2.0
	_ankle = Vector2(foot.anchor.z - ball.z, foot.anchor.y - ball.y)
	_heel = ball.z - heel.z


## Walks on level ground.
func walk(p_steps: int, p_length: float, p_step_s: float) -> void:
	_stand = _root_height(p_length)
	_plan(p_steps, p_length, 0.0, p_step_s)


## Walks up stairs, or down where the rise is negative; a flat stretch comes before and after.
func climb(p_steps: int, p_rise: float, p_tread: float, p_step_s: float) -> void:
	_rolls = false
	_lift = absf(p_rise) + 0.07
	_tread = p_tread
	_rise = p_rise
	_treads = p_steps
	_stand = _root_height(p_tread) - 0.02
	_plan(p_steps, p_tread, p_rise, p_step_s)


## The pose at a time.
func pose_at(p_time_s: float) -> PoseSample:
	var sample: PoseSample = PoseSample.new()
	var turns: Dictionary[int, float] = {}
	var root: Vector2 = _root_at(p_time_s)
	sample.root = Vector3(0.0, root.y, root.x)
	for side: int in [-1, 1]:
		_add_leg(side, p_time_s, root, turns)
		_add_arm(side, p_time_s, turns)
	for limb: int in Limbs.COUNT:
		# A positive angle swings a hanging limb ahead.
		sample.set_orientation(limb, Quaternion(Vector3.RIGHT, -turns.get(limb, 0.0)))
	for limb: int in [4, 5, 6, 7, 8, 9]:
		var down: float = -1.4 if limb < 7 else 1.4
		var hang: Quaternion = Quaternion(Vector3.BACK, down)
		sample.set_orientation(limb, sample.orientation(limb) * hang)
	return sample


## Height of the ground at a place along the way, m.
func ground_at(p_place: float) -> float:
	var tread: int = floori((p_place + _BEHIND) / _tread) if _tread > 0.0 else 0
	return clampi(tread, 0, _treads) * _rise


## Whether a foot's ball stands still at a time: from when the foot is flat until it lifts off.
func is_standing(p_side: int, p_time_s: float) -> bool:
	for fall: Footfall in _falls:
		if fall.side == p_side and p_time_s > fall.down_s + _STRIKE_S and p_time_s < fall.up_s:
			return true
	return false


## Puts what there is to walk on below a node.
func build_ground(p_parent: Node) -> void:
	var first: float = _tread - _BEHIND if _treads > 0 else 100.0
	_add_block(p_parent, -100.0, first, 0.0)
	for i: int in range(1, _treads):
		_add_block(p_parent, i * _tread - _BEHIND, (i + 1) * _tread - _BEHIND, i * _rise)
	if _treads > 0:
		_add_block(p_parent, _treads * _tread - _BEHIND, 100.0, end_height)


func _add_block(p_parent: Node, p_from: float, p_to: float, p_height: float) -> void:
	var block: Block = Block.new()
	block.size = Vector3(20.0, 4.0, p_to - p_from)
	block.position = Vector3(0.0, p_height - 2.0, (p_from + p_to) / 2.0)
	p_parent.add_child(block)


## Height of the root at which the leg reaches the ground at heel strike, when the heel lifts off,
## and at push-off, m.
func _root_height(p_length: float) -> float:
	var reach: float = (_thigh + _shin) * 0.985
	var pushing: Vector2 = _ankle.rotated(_PUSH) if _rolls else _ankle
	# The hips are half a step behind the foot at first, and seven tenths ahead of it at last.
	var striking: float = absf(0.5 * p_length + _ankle.x)
	var across: float = 0.7 * p_length - pushing.x
	var at_strike: float = sqrt(maxf(reach * reach - striking * striking, 0.01)) + _ankle.y
	var at_push: float = sqrt(maxf(reach * reach - across * across, 0.01)) + pushing.y
	# Until the other foot comes down this one is flat.
	var flat: float = 0.5 * p_length - _ankle.x
	var at_flat: float = sqrt(maxf(reach * reach - flat * flat, 0.01)) + _ankle.y
	return minf(minf(at_strike, at_push), at_flat) - _hip.y


func _plan(p_steps: int, p_length: float, p_rise: float, p_step_s: float) -> void:
	_swing_s = p_step_s * 0.8
	var begin: float = STAND_S
	for i: int in p_steps + 3:
		var fall: Footfall = Footfall.new()
		fall.side = -1 if i % 2 == 0 else 1
		# Two feet stand side by side at first; the last step closes up.
		fall.place = clampf(i - 1.0, 0.0, p_steps) * p_length
		fall.height = clampf(i - 1.0, 0.0, p_steps) * p_rise
		if i > 1:
			fall.down_s = begin + (i - 1) * p_step_s
			_falls[i - 2].up_s = fall.down_s - _swing_s
		_falls.append(fall)
	duration = begin + (p_steps + 1) * p_step_s + STAND_S
	way = p_steps * p_length
	end_height = p_steps * p_rise
	_steps = [Vector3(-1.0, 0.0, 0.0), Vector3(begin, 0.0, 0.0)]
	for i: int in range(2, _falls.size()):
		var here: Footfall = _falls[i]
		var before: Footfall = _falls[i - 1]
		var middle: float = (here.place + before.place) / 2.0
		_steps.append(Vector3(here.down_s, middle, minf(here.height, before.height)))
	_steps.append(Vector3(_falls[-1].down_s + 0.3, way, end_height))
	_steps.append(Vector3(duration + 1.0, way, end_height))


## Where the root's joint is: along the way, up.
func _root_at(p_time_s: float) -> Vector2:
	var sum: Vector2 = Vector2.ZERO
	# A moving mean makes a smooth path of the straight pieces.
	for part: int in range(-6, 7):
		sum += _piece_at(p_time_s + part * 0.025)
	return sum / 13.0 + Vector2(0.0, _stand)


func _piece_at(p_time_s: float) -> Vector2:
	for i: int in range(1, _steps.size()):
		if p_time_s < _steps[i].x:
			var from: Vector3 = _steps[i - 1]
			var part: float = clampf((p_time_s - from.x) / (_steps[i].x - from.x), 0.0, 1.0)
			return Vector2(lerpf(from.y, _steps[i].y, part), lerpf(from.z, _steps[i].z, part))
	return Vector2(_steps[-1].y, _steps[-1].z)


func _add_leg(
	p_side: int, p_time_s: float, p_root: Vector2, r_turns: Dictionary[int, float]
) -> void:
	var foot: Vector3 = _foot_at(p_side, p_time_s)
	var hip: Vector2 = p_root + Vector2(_hip.z, _hip.y)
	var to: Vector2 = Vector2(foot.x, foot.y) - hip
	var reach: float = clampf(to.length(), absf(_thigh - _shin) + 0.01, (_thigh + _shin) * 0.999)
	# The law of cosines; the knee bends ahead.
	var at_hip: float = acos(
		(_thigh * _thigh + reach * reach - _shin * _shin) / (2.0 * _thigh * reach)
	)
	var at_knee: float = acos(
		(_thigh * _thigh + _shin * _shin - reach * reach) / (2.0 * _thigh * _shin)
	)
	var swing: float = atan2(to.x, -to.y) + at_hip
	var first: int = 10 if p_side < 0 else 13
	r_turns[first] = swing
	r_turns[first + 1] = swing - (PI - at_knee)
	r_turns[first + 2] = foot.z


## Where an ankle is, along the way and up, and the pitch of the foot (toes up), rad.
func _foot_at(p_side: int, p_time_s: float) -> Vector3:
	var before: Footfall = null
	var after: Footfall = null
	for fall: Footfall in _falls:
		if fall.side != p_side:
			continue
		if p_time_s >= fall.down_s:
			before = fall
		elif after == null:
			after = fall
	if after == null or p_time_s < before.up_s:
		return _stance(before, p_time_s)
	var from: Vector3 = _stance(before, before.up_s)
	var to: Vector3 = _stance(after, after.down_s)
	var part: float = (p_time_s - before.up_s) / (after.down_s - before.up_s)
	var eased: float = part * part * part * (10.0 - 15.0 * part + 6.0 * part * part)
	var lift: float = _lift * 16.0 * part * part * (1.0 - part) * (1.0 - part)
	# Up early where the ground rises, down late where it falls.
	var rising: float = clampf(eased * 2.0 if to.y > from.y else eased * 2.0 - 1.0, 0.0, 1.0)
	var height: float = lerpf(from.y, to.y, rising if not _rolls else eased)
	return Vector3(lerpf(from.x, to.x, eased), height + lift, lerpf(from.z, to.z, eased))


func _stance(p_fall: Footfall, p_time_s: float) -> Vector3:
	var ball: Vector2 = Vector2(p_fall.place, p_fall.height)
	if not _rolls:
		return Vector3(ball.x + _ankle.x, ball.y + _ankle.y, 0.0)
	var struck: float = clampf((p_time_s - p_fall.down_s) / _STRIKE_S, 0.0, 1.0)
	var pushed: float = clampf((p_time_s - p_fall.up_s) / _PUSH_S + 1.0, 0.0, 1.0)
	var pitch: float = _STRIKE * (1.0 - smoothstep(0.0, 1.0, struck))
	var pivot: Vector2 = Vector2(-_heel, 0.0)
	if pushed > 0.0:
		pitch = _PUSH * smoothstep(0.0, 1.0, pushed)
		pivot = Vector2.ZERO
	# The ankle turns with the foot about the heel or about the ball.
	var arm: Vector2 = (_ankle - pivot).rotated(pitch)
	return Vector3(ball.x + pivot.x + arm.x, ball.y + arm.y, pitch)


func _add_arm(p_side: int, p_time_s: float, r_turns: Dictionary[int, float]) -> void:
	var walking: bool = p_time_s > STAND_S and p_time_s < duration - STAND_S
	var phase: float = (p_time_s - STAND_S) / (_swing_s / 0.8) * PI
	var swing: float = p_side * 0.35 * sin(phase) if walking else 0.0
	var first: int = 4 if p_side < 0 else 7
	r_turns[first] = swing
	r_turns[first + 1] = swing + 0.25
	r_turns[first + 2] = swing + 0.25

class_name HatchRoom
extends RefCounted
## Keeps the upper body of a person who stands in a hatch out of the steel around it.
##
## An arm that the wearer holds below the rim is raised above the roof; a person who ducks folds the
## arms and bends no further than the hatch is wide. Without this class joints would press limbs
## into the roof with full strength, and swinging arms would be caught.

## How high elbows, wrists and fingers stay above the roof, m.
const CLEARANCE_M: float = 0.08
## Distance from the hatch's edge inwards, m: at the first one arms have room, at the second one
## none.
const _FREE_MARGIN_M: float = 0.15
const _BLOCKED_MARGIN_M: float = 0.04
## From the wrist to the finger tips, m.
const _HAND_M: float = 0.18
## Half the depth of a trunk at the rim, and of shoulders below it, m.
const _TRUNK_M: float = 0.18
const _SHOULDERS_M: float = 0.29
## Greatest elevation of an arm, as a sine.
const _MAX_SINE: float = 0.95
## Elevation of lower arms that are folded, rad.
const _FOLDED_ELEVATION: float = 1.35
const _SIDES: Array[int] = [Limbs.LEFT_UPPER_ARM, Limbs.RIGHT_UPPER_ARM]
## Trunk and head.
const _TRUNK: Array[int] = [Limbs.HIPS, Limbs.SPINE, Limbs.CHEST, Limbs.HEAD]

## From the joint of each limb's parent to its own, in the reset pose, m.
var _offsets: PackedVector3Array = PackedVector3Array()


func _init(p_profile: RagdollProfile) -> void:
	_offsets.resize(Limbs.COUNT)
	for limb: int in Limbs.COUNT:
		var index: int = p_profile.find_index(Limbs.BONES[limb])
		var parent: int = p_profile.get_parent_index(index) if index >= 0 else -1
		if parent < 0:
			continue
		var own: RagdollLimb = p_profile.limbs[index]
		var above: RagdollLimb = p_profile.limbs[parent]
		var turn: Quaternion = above.reset_orientation * above.rest_orientation.inverse()
		_offsets[limb] = turn * (own.anchor - above.anchor)


## Changes a sample of a person who stands on the seat: [param p_hips] is the height of the hips
## above its middle, m; [param p_folded] says how far the arms are folded, 0 to 1.
func fit(p_sample: PoseSample, p_hips: Vector3, p_hold: SeatHold, p_folded: float) -> void:
	_straighten(p_sample, p_hips, p_hold.rim, p_hold.hatch_radius, p_folded)
	var height: float = p_hold.rim + p_hold.cupola + CLEARANCE_M
	var roof: Vector3 = Vector3(height, p_hold.hatch_radius, 1.0)
	var chest: Vector3 = _chest(p_sample, p_hips)
	for upper: int in _SIDES:
		var shoulder: Vector3 = chest + p_sample.orientation(Limbs.CHEST) * _offsets[upper]
		if p_folded < 1.0:
			_lift(p_sample, upper, shoulder, roof)
		if p_folded > 0.0:
			_fold(p_sample, upper, smoothstep(0.0, 1.0, p_folded))


func _chest(p_sample: PoseSample, p_hips: Vector3) -> Vector3:
	var spine: Vector3 = p_hips + p_sample.orientation(Limbs.HIPS) * _offsets[Limbs.SPINE]
	return spine + p_sample.orientation(Limbs.SPINE) * _offsets[Limbs.CHEST]


## Hips below the rim leave the trunk as much room to lean as there is beside it at the rim; a
## person who ducks takes the shoulders through it.
func _straighten(
	p_sample: PoseSample, p_hips: Vector3, p_rim: float, p_radius: float, p_folded: float
) -> void:
	var head: Vector3 = _chest(p_sample, p_hips)
	head += p_sample.orientation(Limbs.CHEST) * _offsets[Limbs.HEAD]
	var trunk: Vector3 = head - p_hips
	var below: float = p_rim - p_hips.y
	if trunk.length() < 0.1 or (below <= 0.0 and p_folded <= 0.0):
		return
	var most: float = atan2(maxf(p_radius - _TRUNK_M, 0.05), maxf(below, 0.0))
	var inside: float = maxf(p_radius - _SHOULDERS_M, 0.02)
	most = lerpf(most, asin(minf(inside / trunk.length(), 1.0)), p_folded)
	var leans: float = trunk.angle_to(Vector3.UP)
	var axis: Vector3 = trunk.cross(Vector3.UP)
	if leans <= most or axis.length() < 0.001:
		return
	var turn: Quaternion = Quaternion(axis.normalized(), leans - most)
	for limb: int in _TRUNK:
		p_sample.set_orientation(limb, turn * p_sample.orientation(limb))
	for limb: int in range(Limbs.LEFT_UPPER_ARM, Limbs.LEFT_UPPER_LEG):
		p_sample.set_orientation(limb, turn * p_sample.orientation(limb))


## Turns an arm, by a share, to the pose that needs no room: it hangs, with the lower arm in front.
func _fold(p_sample: PoseSample, p_upper: int, p_share: float) -> void:
	var along: Vector3 = Limbs.RESET_DIRECTIONS[p_upper]
	var facing: Quaternion = SeatedPose.facing_of(p_sample.orientation(Limbs.CHEST))
	var down: Vector3 = Vector3(0.05 * along.x, -1.0, 0.0).normalized()
	var hangs: Quaternion = facing * Quaternion(along, down)
	var ahead: Vector3 = Vector3(
		-0.3 * along.x * cos(_FOLDED_ELEVATION), sin(_FOLDED_ELEVATION), cos(_FOLDED_ELEVATION)
	)
	var bent: Quaternion = facing * Quaternion(along, ahead.normalized())
	p_sample.set_orientation(p_upper, p_sample.orientation(p_upper).slerp(hangs, p_share))
	for limb: int in [p_upper + 1, p_upper + 2]:
		p_sample.set_orientation(limb, p_sample.orientation(limb).slerp(bent, p_share))


## [param p_roof]: height to reach, radius of the hatch, share of the whole correction.
func _lift(p_sample: PoseSample, p_upper: int, p_shoulder: Vector3, p_roof: Vector3) -> void:
	var lower: int = p_upper + 1
	var hand: int = p_upper + 2
	var elbow_way: Vector3 = p_sample.orientation(p_upper) * _offsets[lower]
	var wrist_way: Vector3 = p_sample.orientation(lower) * _offsets[hand]
	var tip_way: Vector3 = p_sample.orientation(hand) * Limbs.RESET_DIRECTIONS[p_upper] * _HAND_M
	var wrist: Vector3 = p_shoulder + elbow_way + wrist_way
	# Whatever is outside of the hatch takes the elbow along: the arm leads over the rim.
	var outside: float = maxf(_share(wrist, p_roof), _share(wrist + tip_way, p_roof))
	var elbow: Vector3 = p_shoulder + elbow_way
	var share: float = maxf(outside, _share(elbow, p_roof))
	var turn: Quaternion = _raise(elbow_way, elbow, share, p_roof.x)
	p_sample.set_orientation(p_upper, turn * p_sample.orientation(p_upper))
	elbow = p_shoulder + turn * elbow_way
	wrist = elbow + wrist_way
	turn = _raise(wrist_way, wrist, maxf(outside, _share(wrist, p_roof)), p_roof.x)
	p_sample.set_orientation(lower, turn * p_sample.orientation(lower))
	tip_way = turn * tip_way
	var tip: Vector3 = elbow + turn * wrist_way + tip_way
	turn = _raise(tip_way, tip, _share(tip, p_roof), p_roof.x) * turn
	p_sample.set_orientation(hand, turn * p_sample.orientation(hand))


## How far a point is over the roof, 0 to 1.
static func _share(p_point: Vector3, p_roof: Vector3) -> float:
	var across: float = Vector2(p_point.x, p_point.z).length()
	return p_roof.z * smoothstep(p_roof.y - _FREE_MARGIN_M, p_roof.y - _BLOCKED_MARGIN_M, across)


## The turn that raises the end of a limb to a height, by a share.
static func _raise(p_way: Vector3, p_end: Vector3, p_share: float, p_height: float) -> Quaternion:
	var lift: float = (p_height - p_end.y) * p_share
	var length: float = p_way.length()
	if lift <= 0.0 or length < 0.01:
		return Quaternion.IDENTITY
	var from: Vector3 = p_way / length
	var up: float = minf(from.y + lift / length, maxf(_MAX_SINE, from.y))
	var across: Vector3 = Vector3(from.x, 0.0, from.z)
	if across.length() < 0.01:
		return Quaternion.IDENTITY
	var to: Vector3 = across.normalized() * sqrt(1.0 - up * up)
	to.y = up
	return Quaternion(from, to.normalized())

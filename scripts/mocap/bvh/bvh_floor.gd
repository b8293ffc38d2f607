class_name BvhFloor
extends RefCounted
## Finds the height of the ground that a clip was made on, from where the body's surface is lowest.
##
## Joints are inside the body: ankles stand above soles, the joints of somebody who lies are a hand
## above the ground. Feet have the soles that the rest pose stands on: a heel below the ankle, and
## as much below the toes as they are above the ground there. Elsewhere the body is a ball about
## each joint, as thick as a person is there.

## How thick the body is about the joint at which each limb begins, m, by index in [Limbs], at a
## height of the hips of [constant HIPS]: the pill's radius or half the box's depth in
## [code]assets/avatar/shapes/soldier.json[/code]. Feet have soles instead.
const RADII: PackedFloat32Array = [
	0.124,
	0.131,
	0.170,
	0.101,
	0.075,
	0.057,
	0.032,
	0.075,
	0.057,
	0.032,
	0.097,
	0.078,
	0.0,
	0.097,
	0.078,
	0.0,
]
## Height of the hips of the body with these radii, m.
const HIPS: float = 1.0115
## Standing feet are on the ground most of the time, and below it only where the motion is unsteady.
const SHARE: float = 0.1

## Thickest heel and toes, m: a rest pose may stand on its toes.
const MAX_HEEL: float = 0.11
const MAX_TOES: float = 0.04

## Maximum of frames that are looked at.
const _MAX_FRAMES: int = 200

var _rig: BvhRig = null
# For each foot the joints in front of the ankle, and for all of them the flesh below them, m.
var _toes: Array[PackedInt32Array] = []
var _below: Array[PackedFloat32Array] = []


## Height of the ground in a clip, m, by its frames from one up to another; below 0: to the end.
static func find(p_rig: BvhRig, p_first: int = 0, p_end: int = -1) -> float:
	var ground: BvhFloor = BvhFloor.new(p_rig)
	var heights: PackedFloat32Array = []
	var end: int = p_end if p_end > p_first else p_rig.clip.frame_count
	for frame: int in range(p_first, end, maxi((end - p_first) / _MAX_FRAMES, 1)):
		heights.append(ground.lowest(frame))
	heights.sort()
	return heights[int(heights.size() * SHARE)]


## Measures the feet of a rig.
func _init(p_rig: BvhRig) -> void:
	_rig = p_rig
	for foot: int in Limbs.FEET:
		var ankle: int = p_rig.map.bases[foot]
		var toes: PackedInt32Array = p_rig.map.joints_below(ankle)
		var below: PackedFloat32Array = []
		for joint: int in toes:
			below.append(clampf(p_rig.rest_height(joint), 0.0, MAX_TOES))
		_toes.append(toes)
		_below.append(below)


## Height of the lowest point of the body in a frame, m.
func lowest(p_frame: int) -> float:
	var positions: PackedVector3Array = _rig.clip.sample_global(p_frame).positions
	var size: float = _rig.hip_height / HIPS
	var found: float = INF
	for limb: int in Limbs.COUNT:
		if not limb in Limbs.FEET:
			found = minf(found, positions[_rig.map.bases[limb]].y - RADII[limb] * size)
	# Fingertips and the crown, of which the flesh is thin.
	for limb: int in [Limbs.HEAD, Limbs.LEFT_HAND, Limbs.RIGHT_HAND]:
		if _rig.map.tails[limb] >= 0:
			found = minf(found, positions[_rig.map.tails[limb]].y)
	for side: int in Limbs.FEET.size():
		var foot: int = Limbs.FEET[side]
		var ankle: int = _rig.map.bases[foot]
		var heel: float = clampf(_rig.rest_height(ankle), 0.0, MAX_HEEL)
		var turn: Quaternion = _rig.limb_rotation(foot, p_frame * _rig.clip.frame_time)
		found = minf(found, positions[ankle].y + (turn * Vector3(0.0, -heel, 0.0)).y)
		for i: int in _toes[side].size():
			found = minf(found, positions[_toes[side][i]].y - _below[side][i])
	return found

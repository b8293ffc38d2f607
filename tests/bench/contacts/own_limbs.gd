class_name OwnLimbs
extends RefCounted
## How deep a person's arms and legs lie in the other limbs.
##
## The axis of a limb, thick by its radius (of boxes: by half of the least size), against the boxes
## and pills of the others. Limbs of the same arm or leg, neighbours and feet are left out, and so
## are upper arms against the trunk and thighs near the hips, which meet by build.

const _POINTS: int = 9
const _MOVERS: Array[String] = ["LowerArm", "Hand", "UpperLeg", "LowerLeg"]

var _person: ContactPerson = null
## Pairs of limbs: which lies in which, and the first point of its axis that counts.
var _pairs: Array[Vector3i] = []


func _init(p_person: ContactPerson) -> void:
	_person = p_person
	for i: int in p_person.count:
		for j: int in p_person.count:
			_add(i, j)


## The deepest overlap of any two limbs for a set of bodies, m.
func depth(p_bodies: Array[Transform3D]) -> float:
	var deepest: float = 0.0
	for pair: Vector3i in _pairs:
		deepest = maxf(deepest, _depth(pair, p_bodies))
	return deepest


## Names of the two limbs that lie deepest in each other.
func worst_pair(p_bodies: Array[Transform3D]) -> String:
	var worst: Vector3i = _pairs[0]
	for pair: Vector3i in _pairs:
		if _depth(pair, p_bodies) > _depth(worst, p_bodies):
			worst = pair
	return "%s in %s" % [_person.shape_of(worst.x).bone, _person.shape_of(worst.y).bone]


func _add(p_mover: int, p_other: int) -> void:
	var mover: String = _person.shape_of(p_mover).bone
	var other: String = _person.shape_of(p_other).bone
	var part: String = mover.trim_prefix("Left").trim_prefix("Right")
	var is_leg: bool = part.ends_with("Leg")
	if not part in _MOVERS or other.ends_with("Foot"):
		return
	var side: String = mover.substr(0, mover.length() - part.length())
	if is_leg and (not other.ends_with("Leg") or other.begins_with(side)):
		return
	if not is_leg and other.begins_with(side) and not other.ends_with("Leg"):
		return
	var is_thigh: bool = part == "UpperLeg"
	_pairs.append(Vector3i(p_mover, p_other, _POINTS / 2 if is_thigh else 0))


func _depth(p_pair: Vector3i, p_bodies: Array[Transform3D]) -> float:
	var limb: RagdollLimb = _person.shape_of(p_pair.x)
	var other: RagdollLimb = _person.shape_of(p_pair.y)
	var is_box: bool = limb.type == RagdollLimb.BOX
	var half: float = limb.size.y / 2.0 if is_box else limb.length / 2.0
	var radius: float = limb.radius
	if is_box:
		radius = limb.size[limb.size.min_axis_index()] / 2.0
	var shape: Transform3D = _shape(p_pair.x, p_bodies)
	var joint: Vector3 = _person.joint(p_pair.x, p_bodies)
	# From the joint on, whichever end of the shape that is.
	if (
		(shape * Vector3(0.0, half, 0.0)).distance_to(joint)
		< (shape * Vector3(0.0, -half, 0.0)).distance_to(joint)
	):
		half = -half
	var into: Transform3D = _shape(p_pair.y, p_bodies).affine_inverse() * shape
	var deepest: float = 0.0
	for point: int in range(p_pair.z, _POINTS):
		var at: Vector3 = into * Vector3(0.0, lerpf(-half, half, point / (_POINTS - 1.0)), 0.0)
		deepest = maxf(deepest, radius - _to_surface(other, at))
	return deepest


func _shape(p_limb: int, p_bodies: Array[Transform3D]) -> Transform3D:
	var limb: RagdollLimb = _person.shape_of(p_limb)
	var turn: Quaternion = limb.rest_orientation.inverse() * limb.orientation
	return p_bodies[p_limb] * Transform3D(Basis(turn), Vector3.ZERO)


## Distance of a point in a limb's shape's own axes from its surface, m; below zero inside.
static func _to_surface(p_limb: RagdollLimb, p_point: Vector3) -> float:
	if p_limb.type == RagdollLimb.BOX:
		var beyond: Vector3 = p_point.abs() - p_limb.size / 2.0
		var inside: float = minf(beyond[beyond.max_axis_index()], 0.0)
		return beyond.max(Vector3.ZERO).length() + inside
	var along: float = clampf(p_point.y, -p_limb.length / 2.0, p_limb.length / 2.0)
	return (p_point - Vector3(0.0, along, 0.0)).length() - p_limb.radius

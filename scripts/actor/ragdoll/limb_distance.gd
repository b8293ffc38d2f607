@tool
class_name LimbDistance
extends RefCounted
## How far the limbs of a [RagdollProfile] are apart in its reset pose, and which are too near.

## Least distance of limbs that no joint connects, m.
const GAP: float = 0.005
## Minimum thickness of a limb that is made thinner, as a share of what it was.
const THINNEST: float = 0.6


## Where the limbs' shapes are in the reset pose: a transform from the rest pose for each.
static func rest_to_reset(p_profile: RagdollProfile) -> Array[Transform3D]:
	var moves: Array[Transform3D] = []
	for i: int in p_profile.limbs.size():
		var limb: RagdollLimb = p_profile.limbs[i]
		var turn: Basis = Basis(limb.reset_orientation * limb.rest_orientation.inverse())
		var parent: int = p_profile.get_parent_index(i)
		var joint: Vector3 = limb.anchor if parent < 0 else moves[parent] * limb.anchor
		moves.append(Transform3D(turn, joint - turn * limb.anchor))
	return moves


## Pairs of bones that are too near each other, without those that a joint connects.
static func overlaps(p_profile: RagdollProfile) -> Array[Array]:
	var pairs: Array[Array] = []
	if p_profile.find_fault() != "":
		return pairs
	var moves: Array[Transform3D] = rest_to_reset(p_profile)
	for i: int in p_profile.limbs.size():
		for j: int in i:
			if p_profile.get_parent_index(i) != j and _are_near(p_profile, moves, i, j):
				pairs.append([p_profile.limbs[j].bone, p_profile.limbs[i].bone])
	return pairs


## Makes limbs thinner, 2 % at a time, until none is too near one that it is not joined to, but
## none thinner than [constant THINNEST]. Returns the remaining share of each limb's thickness.
static func keep_apart(p_profile: RagdollProfile) -> Dictionary[StringName, float]:
	var left: Dictionary[StringName, float] = {}
	for limb: RagdollLimb in p_profile.limbs:
		left[limb.bone] = 1.0
	var is_changed: bool = true
	while is_changed:
		is_changed = false
		var near: Dictionary[StringName, bool] = {}
		for pair: Array in overlaps(p_profile):
			near[pair[0]] = true
			near[pair[1]] = true
		for bone: StringName in near:
			if left[bone] * 0.98 >= THINNEST:
				left[bone] *= 0.98
				_thin(p_profile.find(bone))
				is_changed = true
	return left


## The gap between two shapes, m; below zero they overlap. Between boxes it is a lower bound.
static func separation(
	p_a: RagdollLimb, p_at: Transform3D, p_b: RagdollLimb, p_bt: Transform3D
) -> float:
	var a: Transform3D = p_at * Transform3D(Basis(p_a.orientation), p_a.position)
	var b: Transform3D = p_bt * Transform3D(Basis(p_b.orientation), p_b.position)
	if p_a.type == RagdollLimb.PILL and p_b.type == RagdollLimb.PILL:
		var ends: PackedVector3Array = _ends(p_a, a)
		var others: PackedVector3Array = _ends(p_b, b)
		var nearest: PackedVector3Array = Geometry3D.get_closest_points_between_segments(
			ends[0], ends[1], others[0], others[1]
		)
		return nearest[0].distance_to(nearest[1]) - p_a.radius - p_b.radius
	if p_a.type == RagdollLimb.BOX and p_b.type == RagdollLimb.BOX:
		return _between_boxes(p_a, a, p_b, b)
	if p_a.type == RagdollLimb.BOX:
		return _pill_to_box(p_b, b, p_a, a)
	return _pill_to_box(p_a, a, p_b, b)


## Signed distance of a point in model space (rest pose) from a limb's surface, m; inside negative.
static func to_surface(p_limb: RagdollLimb, p_point: Vector3) -> float:
	var local: Vector3 = p_limb.orientation.inverse() * (p_point - p_limb.position)
	if p_limb.type == RagdollLimb.BOX:
		return _to_box(local, p_limb.size / 2.0)
	local.y -= clampf(local.y, -p_limb.length / 2.0, p_limb.length / 2.0)
	return local.length() - p_limb.radius


static func _are_near(
	p_profile: RagdollProfile, p_moves: Array[Transform3D], p_i: int, p_j: int
) -> bool:
	var a: RagdollLimb = p_profile.limbs[p_i]
	var b: RagdollLimb = p_profile.limbs[p_j]
	var apart: float = (p_moves[p_i] * a.position).distance_to(p_moves[p_j] * b.position)
	if apart > _reach(a) + _reach(b) + GAP:
		return false
	return separation(a, p_moves[p_i], b, p_moves[p_j]) < GAP


static func _reach(p_limb: RagdollLimb) -> float:
	if p_limb.type == RagdollLimb.BOX:
		return p_limb.size.length() / 2.0
	return p_limb.length / 2.0 + p_limb.radius


static func _thin(p_limb: RagdollLimb) -> void:
	if p_limb.type == RagdollLimb.BOX:
		# Its length stays, and a foot stays on its sole.
		var is_flat: bool = p_limb.is_foot
		p_limb.size *= Vector3(0.98, 1.0, 1.0 if is_flat else 0.98)
		return
	p_limb.radius *= 0.98


static func _ends(p_limb: RagdollLimb, p_transform: Transform3D) -> PackedVector3Array:
	var half: Vector3 = Vector3(0.0, p_limb.length / 2.0, 0.0)
	return [p_transform * -half, p_transform * half]


## The distance of a convex body along a line is convex: thirds find the least.
static func _pill_to_box(
	p_pill: RagdollLimb, p_at: Transform3D, p_box: RagdollLimb, p_bt: Transform3D
) -> float:
	var ends: PackedVector3Array = p_bt.affine_inverse() * _ends(p_pill, p_at)
	var half: Vector3 = p_box.size / 2.0
	var low: float = 0.0
	var high: float = 1.0
	for _step: int in 24:
		var third: float = (high - low) / 3.0
		var nearer: float = _to_box(ends[0].lerp(ends[1], low + third), half)
		if nearer < _to_box(ends[0].lerp(ends[1], high - third), half):
			high -= third
		else:
			low += third
	return _to_box(ends[0].lerp(ends[1], (low + high) / 2.0), half) - p_pill.radius


static func _to_box(p_local: Vector3, p_half: Vector3) -> float:
	var beyond: Vector3 = p_local.abs() - p_half
	var inside: float = minf(beyond[beyond.max_axis_index()], 0.0)
	return beyond.max(Vector3.ZERO).length() + inside


## The widest gap along a separating axis.
static func _between_boxes(
	p_a: RagdollLimb, p_at: Transform3D, p_b: RagdollLimb, p_bt: Transform3D
) -> float:
	var own: Array[Vector3] = [p_at.basis.x, p_at.basis.y, p_at.basis.z]
	var others: Array[Vector3] = [p_bt.basis.x, p_bt.basis.y, p_bt.basis.z]
	var axes: Array[Vector3] = own + others
	for u: Vector3 in own:
		for v: Vector3 in others:
			if u.cross(v).length() > 1e-3:
				axes.append(u.cross(v).normalized())
	var widest: float = -INF
	for axis: Vector3 in axes:
		var reach: float = 0.0
		for i: int in 3:
			reach += absf(axis.dot(own[i])) * p_a.size[i] / 2.0
			reach += absf(axis.dot(others[i])) * p_b.size[i] / 2.0
		widest = maxf(widest, absf(axis.dot(p_bt.origin - p_at.origin)) - reach)
	return widest

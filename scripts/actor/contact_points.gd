@tool
class_name ContactPoints
extends RefCounted
## Where the limbs of people touch the ground: the sample points of thesis section 8.4.1, and those
## of other limbs, so that kneeling, lying and crawling work too.
##
## Points are in the figure's rest pose in model space, m.

## How far ahead on the sole the ball of the foot is, from heel to toes.
const _BALL: float = 0.72
## And the points at the toes: not at the tip of the shoe, because toes bend (thesis 8.4.1).
const _TOES: float = 0.82
## Limbs that touch with their far end.
const _ENDS: Array[StringName] = [
	&"Head",
	&"LeftUpperArm",
	&"RightUpperArm",
	&"LeftHand",
	&"RightHand",
	&"LeftUpperLeg",
	&"RightUpperLeg",
]
## Limbs that touch with both sides.
const _SIDES: Array[StringName] = [&"Hips", &"Chest"]


## Gives a limb its contact points. Its shape and orientations must be there.
static func add(p_limb: RagdollLimb) -> void:
	p_limb.is_foot = String(p_limb.bone).ends_with("Foot")
	if p_limb.is_foot:
		p_limb.contact_points = _sole(p_limb)
		p_limb.contact_radius = 0.0
	elif _ENDS.has(p_limb.bone):
		p_limb.contact_radius = _thickness(p_limb)
		p_limb.contact_points = [_far_end(p_limb)]
	elif _SIDES.has(p_limb.bone):
		var box: Basis = Basis(p_limb.orientation)
		p_limb.contact_radius = p_limb.size.z / 2.0
		var across: Vector3 = box.x * maxf(p_limb.size.x / 2.0 - p_limb.contact_radius, 0.0)
		p_limb.contact_points = [p_limb.position - across, p_limb.position + across]


## Heel, two points at the ball, two at the toes, on the lower side of the foot's shape.
static func _sole(p_limb: RagdollLimb) -> PackedVector3Array:
	var corners: Array[Vector3] = _corners(p_limb)
	corners.sort_custom(func(a: Vector3, b: Vector3) -> bool: return a.y < b.y)
	var sole: Array[Vector3] = corners.slice(0, 4)
	sole.sort_custom(func(a: Vector3, b: Vector3) -> bool: return a.z < b.z)
	var behind: Array[Vector3] = sole.slice(0, 2)
	var ahead: Array[Vector3] = sole.slice(2, 4)
	var by_side: Callable = func(a: Vector3, b: Vector3) -> bool: return a.x < b.x
	behind.sort_custom(by_side)
	ahead.sort_custom(by_side)
	return [
		(behind[0] + behind[1]) / 2.0,
		behind[0].lerp(ahead[0], _BALL),
		behind[1].lerp(ahead[1], _BALL),
		behind[0].lerp(ahead[0], _TOES),
		behind[1].lerp(ahead[1], _TOES),
	]


## Corners of the shape, or of the box around a pill.
static func _corners(p_limb: RagdollLimb) -> Array[Vector3]:
	var half: Vector3 = p_limb.size / 2.0
	if p_limb.type == RagdollLimb.PILL:
		half = Vector3(p_limb.radius, p_limb.length / 2.0 + p_limb.radius, p_limb.radius)
	var corners: Array[Vector3] = []
	for x: float in [-1.0, 1.0]:
		for y: float in [-1.0, 1.0]:
			for z: float in [-1.0, 1.0]:
				var corner: Vector3 = half * Vector3(x, y, z)
				corners.append(p_limb.position + p_limb.orientation * corner)
	return corners


static func _thickness(p_limb: RagdollLimb) -> float:
	if p_limb.type == RagdollLimb.PILL:
		return p_limb.radius
	return minf(p_limb.size.x, minf(p_limb.size.y, p_limb.size.z)) / 2.0


## The middle of the round end away from the joint.
static func _far_end(p_limb: RagdollLimb) -> Vector3:
	var along: Vector3 = (p_limb.position - p_limb.anchor).normalized()
	var axes: Basis = Basis(p_limb.orientation)
	if p_limb.type == RagdollLimb.PILL:
		var up: Vector3 = axes.y * signf(axes.y.dot(along))
		return p_limb.position + up * (p_limb.length / 2.0)
	var reach: Vector3 = (
		axes.x * axes.x.dot(along) * p_limb.size.x
		+ axes.y * axes.y.dot(along) * p_limb.size.y
		+ axes.z * axes.z.dot(along) * p_limb.size.z
	)
	return (
		p_limb.position + reach.limit_length(maxf(reach.length() / 2.0 - _thickness(p_limb), 0.0))
	)

@tool
class_name LimbContacts
extends RefCounted
## The points by which the limbs of a [RagdollProfile] can stand on something.
##
## Feet have five on the sole (thesis section 8.4.1): heel, both sides of the ball, both sides of
## the toes. Other limbs have the middles of the balls that their shapes end in.

## Vertices within this distance of a point determine how low the sole is there, m.
const _AROUND: float = 0.03
## How far inside the box's edges the points lie where there is no surface, as a share of its size.
const _INSET: float = 0.12
## How far beyond the ball the body of a foot goes on, as a share of the whole foot.
const _BEYOND_BALL: float = 0.01


## Gives all limbs their contact points; the sole is taken from a surface, if it has one.
static func fill(
	p_profile: RagdollProfile, p_figure: RestSkeleton, p_surface: SkinnedSurface
) -> void:
	for limb: RagdollLimb in p_profile.limbs:
		if limb.is_foot:
			var number: int = Limbs.find(limb.bone)
			var toes: Vector3 = limb.anchor + p_figure.direction(number)
			limb.contact_radius = 0.0
			_end_behind_toes(limb, toes)
			limb.contact_points = _sole(limb, toes, p_surface.points[number])
		elif limb.type == RagdollLimb.PILL:
			var half: Vector3 = limb.orientation * Vector3(0.0, limb.length / 2.0, 0.0)
			limb.contact_radius = limb.radius
			limb.contact_points = [limb.position - half, limb.position + half]
		else:
			_fill_box(limb)


## Toes bend, bodies do not: a foot's ends a little beyond the ball, so that it can roll. The
## visible toes disappear a small amount into the ground then (thesis section 8.4.1).
static func _end_behind_toes(p_limb: RagdollLimb, p_toes: Vector3) -> void:
	var frame: Transform3D = Transform3D(Basis(p_limb.orientation), p_limb.position)
	var tip: float = (frame.affine_inverse() * p_toes).z + _BEYOND_BALL * p_limb.size.z
	var shorter: float = p_limb.size.z / 2.0 - tip
	if shorter > 0.0 and tip > 0.0 and p_limb.type == RagdollLimb.BOX:
		p_limb.size.z -= shorter
		p_limb.position -= frame.basis.z * (shorter / 2.0)


## Balls as thick as the box, in its corners.
static func _fill_box(p_limb: RagdollLimb) -> void:
	var radius: float = p_limb.size[p_limb.size.min_axis_index()] / 2.0
	var inner: Vector3 = p_limb.size / 2.0 - Vector3.ONE * radius
	var points: PackedVector3Array = []
	for x: float in _ends(inner.x):
		for y: float in _ends(inner.y):
			for z: float in _ends(inner.z):
				points.append(p_limb.position + p_limb.orientation * Vector3(x, y, z))
	p_limb.contact_radius = radius
	p_limb.contact_points = points


static func _ends(p_half: float) -> PackedFloat32Array:
	if p_half < 0.005:
		return PackedFloat32Array([0.0])
	return PackedFloat32Array([-p_half, p_half])


static func _sole(
	p_limb: RagdollLimb, p_toes: Vector3, p_points: PackedVector3Array
) -> PackedVector3Array:
	var frame: Transform3D = Transform3D(Basis(p_limb.orientation), p_limb.position)
	var half: Vector3 = p_limb.size / 2.0
	var ball: float = clampf((frame.affine_inverse() * p_toes).z, -0.2 * half.z, 0.9 * half.z)
	var heel: float = -half.z * (1.0 - 2.0 * _INSET)
	var tip: float = half.z
	var local: PackedVector3Array = _lowest(frame.affine_inverse() * p_points, -half.y)
	var heights: Vector3 = Vector3.ONE * -half.y
	var sides: Array[Vector2] = []
	var points: PackedFloat32Array = [heel, ball, tip]
	for i: int in 3:
		var reach: Vector2 = Vector2(-half.x, half.x) * (1.0 - _INSET)
		var near: PackedVector3Array = _near(local, points[i])
		if near.size() >= 3:
			reach = Vector2(INF, -INF)
			heights[i] = INF
			for point: Vector3 in near:
				reach = Vector2(minf(reach.x, point.x), maxf(reach.y, point.x))
				heights[i] = minf(heights[i], point.y)
		sides.append(reach)
	return (
		frame
		* PackedVector3Array(
			[
				Vector3((sides[0].x + sides[0].y) / 2.0, heights[0], heel),
				Vector3(sides[1].x, heights[1], ball),
				Vector3(sides[1].y, heights[1], ball),
				Vector3(sides[2].x, heights[2], tip),
				Vector3(sides[2].y, heights[2], tip),
			]
		)
	)


## Points that belong to the sole: at most 2.5 cm above the lowest.
static func _lowest(p_points: PackedVector3Array, p_sole: float) -> PackedVector3Array:
	var found: PackedVector3Array = []
	for point: Vector3 in p_points:
		if point.y < p_sole + 0.025:
			found.append(point)
	return found


static func _near(p_points: PackedVector3Array, p_ahead: float) -> PackedVector3Array:
	var found: PackedVector3Array = []
	for point: Vector3 in p_points:
		if absf(point.z - p_ahead) < _AROUND:
			found.append(point)
	return found

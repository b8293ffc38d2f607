@tool
class_name MeshShapes
extends RefCounted
## Fits the shapes of a [RagdollProfile] to a figure's skin.
##
## The same rules as tools/assets/avatar/limb_shapes.py: a limb keeps the direction of its bone, its
## sizes are percentiles by area, so that a pocket or a pouch does not fatten it. Where a figure's
## skeleton is symmetric, both sides are fitted together and become alike.

## Minimum of surface points for fitting a limb.
const _MIN_POINTS: int = 24
## Shares of the area cut off at each face of a box: sideways, along, deep.
const _TRIM_TRUNK: Vector3 = Vector3(0.05, 0.03, 0.10)
const _TRIM_HAND: Vector3 = Vector3(0.06, 0.02, 0.06)
const _TRIM_FOOT: Vector3 = Vector3(0.02, 0.05, 0.005)
## Thinnest shape, m.
const _THINNEST: float = 0.01

var _figure: RestSkeleton = null
var _surface: SkinnedSurface = null
var _is_symmetric: bool = false


func _init(p_figure: RestSkeleton, p_surface: SkinnedSurface) -> void:
	_figure = p_figure
	_surface = p_surface
	_is_symmetric = _find_symmetry()


## Fits all limbs that have enough points of the surface; the others stay as they are.
func fit(p_profile: RagdollProfile) -> void:
	for limb: int in Limbs.COUNT:
		var shape: RagdollLimb = p_profile.find(Limbs.BONES[limb])
		var other: int = mirrored(limb)
		if _is_symmetric and other != limb and other < limb:
			_copy_mirrored(p_profile.find(Limbs.BONES[other]), shape)
			continue
		var points: PackedVector3Array = _surface.points[limb].duplicate()
		var areas: PackedFloat32Array = _surface.areas[limb].duplicate()
		if _is_symmetric:
			for point: Vector3 in _surface.points[other]:
				points.append(point * Vector3(-1.0, 1.0, 1.0))
			areas.append_array(_surface.areas[other])
		if points.size() >= _MIN_POINTS:
			_fit_limb(shape, limb, points, areas)


## The limb on the other side, or the limb itself.
static func mirrored(p_limb: int) -> int:
	var bone: String = Limbs.BONES[p_limb]
	if bone.begins_with("Left"):
		return Limbs.find(StringName(bone.replace("Left", "Right")))
	return Limbs.find(StringName(bone.replace("Right", "Left")))


## The value below which a share of the area lies; of sorted pairs of value and area.
static func percentile(p_sorted: PackedVector2Array, p_share: float) -> float:
	var total: float = 0.0
	for pair: Vector2 in p_sorted:
		total += pair.y
	var reached: float = 0.0
	for pair: Vector2 in p_sorted:
		reached += pair.y
		if reached >= p_share * total:
			return pair.x
	return p_sorted[p_sorted.size() - 1].x


func _find_symmetry() -> bool:
	for limb: int in Limbs.COUNT:
		var here: Vector3 = _figure.rest(Limbs.BONES[limb]).origin
		var other: Vector3 = _figure.rest(Limbs.BONES[mirrored(limb)]).origin
		if here.distance_to(other * Vector3(-1.0, 1.0, 1.0)) > 0.01:
			return false
	return true


static func _copy_mirrored(p_from: RagdollLimb, p_to: RagdollLimb) -> void:
	var turn: Quaternion = p_from.orientation
	p_to.type = p_from.type
	p_to.position = p_from.position * Vector3(-1.0, 1.0, 1.0)
	p_to.orientation = Quaternion(turn.x, -turn.y, -turn.z, turn.w)
	p_to.radius = p_from.radius
	p_to.length = p_from.length
	p_to.size = p_from.size


func _fit_limb(
	p_shape: RagdollLimb, p_limb: int, p_points: PackedVector3Array, p_areas: PackedFloat32Array
) -> void:
	if p_shape.is_foot:
		_fit_foot(p_shape, p_limb, p_points, p_areas)
	elif p_shape.bone == &"Head":
		# The helmet is what hits things: the face, its inside and the neck lie within it.
		_fit_pill(p_shape, p_points, p_areas, -1.0, 0.75)
	elif p_shape.type == RagdollLimb.PILL:
		var length: float = _figure.direction(p_limb).length()
		_fit_pill(p_shape, p_points, p_areas, length, 0.5)
	elif p_limb <= 2:
		_fit_trunk(p_shape, p_limb, p_points, p_areas)
	else:
		_turn_flat(p_shape, p_points)
		_fit_box(p_shape, p_points, p_areas, _TRIM_HAND)


func _fit_pill(
	p_shape: RagdollLimb,
	p_points: PackedVector3Array,
	p_areas: PackedFloat32Array,
	p_bone_length: float,
	p_radius_share: float
) -> void:
	var local: PackedVector3Array = _to_local(p_points, p_shape)
	var middle: Vector3 = Vector3.ZERO
	for axis: int in [0, 2]:
		var sorted: PackedVector2Array = _sort(local, p_areas, axis)
		middle[axis] = (percentile(sorted, 0.1) + percentile(sorted, 0.9)) / 2.0
	var radii: PackedVector2Array = []
	for i: int in local.size():
		var away: Vector2 = Vector2(local[i].x - middle.x, local[i].z - middle.z)
		radii.append(Vector2(away.length(), p_areas[i]))
	radii.sort()
	var radius: float = maxf(percentile(radii, p_radius_share), _THINNEST)
	var along: PackedVector2Array = _sort(local, p_areas, 1)
	var bottom: float = percentile(along, 0.01) + radius
	var top: float = percentile(along, 0.99) - radius
	if p_bone_length > 0.0:
		# Towards the next joint a cap may reach 40 % of the radius past the limb's own surface.
		bottom = 0.0
		top = minf(p_bone_length, top + 0.4 * radius)
	if top < bottom:
		bottom = (bottom + top) / 2.0
		top = bottom
	middle.y = (bottom + top) / 2.0
	p_shape.position = p_shape.anchor + p_shape.orientation * middle
	p_shape.radius = radius
	p_shape.length = top - bottom


func _fit_box(
	p_shape: RagdollLimb, p_points: PackedVector3Array, p_areas: PackedFloat32Array, p_trim: Vector3
) -> void:
	var local: PackedVector3Array = _to_local(p_points, p_shape)
	var low: Vector3 = Vector3.ZERO
	var high: Vector3 = Vector3.ZERO
	for axis: int in 3:
		var sorted: PackedVector2Array = _sort(local, p_areas, axis)
		low[axis] = percentile(sorted, p_trim[axis])
		high[axis] = percentile(sorted, 1.0 - p_trim[axis])
	p_shape.position = p_shape.anchor + p_shape.orientation * ((low + high) / 2.0)
	p_shape.size = (high - low).max(Vector3.ONE * _THINNEST)


## The sole is the lowest part of the surface, however small.
func _fit_foot(
	p_shape: RagdollLimb, p_limb: int, p_points: PackedVector3Array, p_areas: PackedFloat32Array
) -> void:
	var ahead: Vector3 = _figure.forward(p_limb)
	var basis: Basis = Basis(Vector3.UP.cross(ahead), Vector3.UP, ahead)
	p_shape.orientation = basis.get_rotation_quaternion()
	_fit_box(p_shape, p_points, p_areas, _TRIM_FOOT)
	var sole: float = INF
	for point: Vector3 in p_points:
		sole = minf(sole, point.y)
	_stretch(p_shape, sole, p_shape.position.y + p_shape.size.y / 2.0)


## Three upright boxes, stacked at the joints of the spine.
func _fit_trunk(
	p_shape: RagdollLimb, p_limb: int, p_points: PackedVector3Array, p_areas: PackedFloat32Array
) -> void:
	p_shape.orientation = Quaternion.IDENTITY
	_fit_box(p_shape, p_points, p_areas, _TRIM_TRUNK)
	if _is_symmetric:
		p_shape.position.x = 0.0
	var low: float = p_shape.position.y - p_shape.size.y / 2.0
	var high: float = p_shape.position.y + p_shape.size.y / 2.0
	if p_limb > 0:
		low = p_shape.anchor.y
	if p_limb < 2:
		high = _figure.rest(Limbs.BONES[p_limb + 1]).origin.y
	if high - low > 0.03:
		_stretch(p_shape, low, high)


static func _stretch(p_shape: RagdollLimb, p_low: float, p_high: float) -> void:
	p_shape.position.y = (p_low + p_high) / 2.0
	p_shape.size = Vector3(p_shape.size.x, maxf(p_high - p_low, _THINNEST), p_shape.size.z)


## Turns a hand's box about its length, so that its faces lie along the palm: by the direction in
## which its points are spread most.
func _turn_flat(p_shape: RagdollLimb, p_points: PackedVector3Array) -> void:
	var local: PackedVector3Array = _to_local(p_points, p_shape)
	var mean: Vector3 = Vector3.ZERO
	for point: Vector3 in local:
		mean += point / local.size()
	var xx: float = 0.0
	var zz: float = 0.0
	var xz: float = 0.0
	for point: Vector3 in local:
		var off: Vector3 = point - mean
		xx += off.x * off.x
		zz += off.z * off.z
		xz += off.x * off.z
	var angle: float = 0.5 * atan2(2.0 * xz, xx - zz)
	p_shape.orientation = p_shape.orientation * Quaternion(Vector3.UP, -angle)


static func _to_local(p_points: PackedVector3Array, p_shape: RagdollLimb) -> PackedVector3Array:
	return Transform3D(Basis(p_shape.orientation), p_shape.anchor).affine_inverse() * p_points


static func _sort(
	p_points: PackedVector3Array, p_areas: PackedFloat32Array, p_axis: int
) -> PackedVector2Array:
	var values: PackedVector2Array = []
	for i: int in p_points.size():
		values.append(Vector2(p_points[i][p_axis], p_areas[i]))
	values.sort()
	return values

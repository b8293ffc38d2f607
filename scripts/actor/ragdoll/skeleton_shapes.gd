@tool
class_name SkeletonShapes
extends RefCounted
## Describes a ragdoll for any skeleton with humanoid bone names, whatever its axes and scale.
##
## Joints are exactly where the skeleton has them. Shapes are fitted to the skinned meshes below the
## skeleton ([MeshShapes]); without any, lengths come from the bones and thicknesses are those of
## an adult of average build, in shares of the body's height. Mass and torques go with the height
## ([BodyMass]). Shapes that would touch in the reset pose though no joint connects them are made
## thinner ([LimbDistance]).

## Half thickness of each limb across, as a share of the body's height. For boxes across and deep.
const _THICKNESS: Array[Vector2] = [
	Vector2(0.085, 0.055),
	Vector2(0.08, 0.05),
	Vector2(0.085, 0.062),
	Vector2(0.051, 0.051),
	Vector2(0.026, 0.026),
	Vector2(0.022, 0.022),
	Vector2(0.022, 0.012),
	Vector2(0.026, 0.026),
	Vector2(0.022, 0.022),
	Vector2(0.022, 0.012),
	Vector2(0.04, 0.04),
	Vector2(0.028, 0.028),
	Vector2(0.026, 0.02),
	Vector2(0.04, 0.04),
	Vector2(0.028, 0.028),
	Vector2(0.026, 0.02),
]
## Limbs that are boxes: trunk, hands, feet.
const _BOXES: Array[int] = [
	Limbs.HIPS,
	Limbs.SPINE,
	Limbs.CHEST,
	Limbs.LEFT_HAND,
	Limbs.RIGHT_HAND,
	Limbs.LEFT_FOOT,
	Limbs.RIGHT_FOOT
]
## Height of the hips' box as a share of the body's height.
const _HIPS_HEIGHT: float = 0.1
## Length of a foot, and how far the heel lies behind the ankle, as shares of the body's height.
const _FOOT: Vector2 = Vector2(0.152, 0.035)
## Shortest limb, m: where a skeleton has no end of it.
const _SHORTEST: float = 0.06


## The profile of a skeleton, or null (and an error that says what to do) where it is no figure.
static func describe(p_skeleton: Skeleton3D) -> RagdollProfile:
	var figure: RestSkeleton = RestSkeleton.new(p_skeleton)
	if figure.find_fault() != "":
		push_error(figure.find_fault() + ".")
		return null
	var profile: RagdollProfile = RagdollProfile.new()
	var height: float = figure.height()
	for limb: int in Limbs.COUNT:
		profile.limbs.append(_shape(figure, limb, height))
	figure.fill_pose(profile)
	var surface: SkinnedSurface = SkinnedSurface.new(figure)
	if not surface.is_empty():
		MeshShapes.new(figure, surface).fit(profile)
	BodyMass.fill(profile, figure)
	LimbDistance.keep_apart(profile)
	LimbContacts.fill(profile, figure, surface)
	return profile


## An orientation whose Y axis lies along a limb and whose Z axis (for a hand the X axis, as its
## thumb is there) is as near to the front as it can be.
static func orientation_along(p_along: Vector3, p_is_hand: bool = false) -> Quaternion:
	var y: Vector3 = p_along.normalized()
	var front: Vector3 = Vector3.BACK if absf(y.z) < 0.9 else Vector3.UP
	var side: Vector3 = y.cross(front).normalized()
	var ahead: Vector3 = side.cross(y)
	var basis: Basis = Basis(ahead, y, ahead.cross(y)) if p_is_hand else Basis(side, y, ahead)
	return basis.get_rotation_quaternion()


static func _shape(p_figure: RestSkeleton, p_limb: int, p_height: float) -> RagdollLimb:
	var bone: StringName = Limbs.BONES[p_limb]
	var shape: RagdollLimb = RagdollLimb.new()
	shape.bone = bone
	shape.parent_bone = &"" if p_limb == 0 else Limbs.BONES[Limbs.PARENTS[p_limb]]
	shape.anchor = p_figure.rest(bone).origin
	shape.mass_fraction = Limbs.MASS_FRACTIONS[p_limb]
	LimbAnatomy.fill(shape)
	if shape.is_foot:
		_shape_foot(shape, p_figure, p_limb, p_height)
		return shape
	var along: Vector3 = _along(p_figure, p_limb)
	shape.position = shape.anchor + along / 2.0
	if p_limb == Limbs.ROOT:
		# The hips lie around their joint, however near the skeleton has the next one.
		along = along.normalized() * p_height * _HIPS_HEIGHT
		shape.position = shape.anchor
	shape.orientation = orientation_along(along, String(bone).ends_with("Hand"))
	var thick: Vector2 = _THICKNESS[p_limb] * p_height
	if _BOXES.has(p_limb):
		shape.type = RagdollLimb.BOX
		shape.size = Vector3(thick.x * 2.0, along.length(), thick.y * 2.0)
	else:
		shape.radius = minf(thick.x, along.length() * 0.49)
		shape.length = maxf(along.length() - 2.0 * shape.radius, 0.0)
	return shape


## A level box from heel to toes that stands on the sole.
static func _shape_foot(
	p_shape: RagdollLimb, p_figure: RestSkeleton, p_limb: int, p_height: float
) -> void:
	var ahead: Vector3 = p_figure.forward(p_limb)
	var toes: Vector3 = p_shape.anchor + p_figure.direction(p_limb)
	var lowest: float = minf(toes.y, p_shape.anchor.y - 0.03)
	# The origin of a figure is between its soles.
	var sole: float = 0.0 if absf(lowest) < 0.06 * p_height else lowest
	var heel: float = -_FOOT.y * p_height
	var tip: float = maxf(heel + _FOOT.x * p_height, (toes - p_shape.anchor).dot(ahead))
	p_shape.type = RagdollLimb.BOX
	p_shape.size = Vector3(
		_THICKNESS[p_limb].x * p_height * 2.0,
		maxf(p_shape.anchor.y - sole, _THICKNESS[p_limb].y * p_height),
		tip - heel
	)
	p_shape.position = p_shape.anchor + ahead * (heel + tip) / 2.0
	p_shape.position.y = sole + p_shape.size.y / 2.0
	p_shape.orientation = (
		Basis(Vector3.UP.cross(ahead), Vector3.UP, ahead).get_rotation_quaternion()
	)


static func _along(p_figure: RestSkeleton, p_limb: int) -> Vector3:
	var along: Vector3 = p_figure.direction(p_limb)
	if along.length() >= _SHORTEST:
		return along
	# A hand goes on as its arm does, a head upwards.
	var parent: int = Limbs.PARENTS[p_limb]
	if String(Limbs.BONES[p_limb]).ends_with("Hand"):
		return p_figure.direction(parent).normalized() * maxf(0.05 * p_figure.height(), _SHORTEST)
	var is_head: bool = Limbs.BONES[p_limb] == &"Head"
	return Vector3.UP * (0.11 * p_figure.height() if is_head else _SHORTEST)

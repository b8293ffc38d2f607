@tool
class_name LimbShape
extends Resource
## One limb of a [RagdollDescription]: a pill or a box with a place, an orientation and sizes.
##
## This is the thesis's kind of description (section 6.2). Frame: the figure's rest pose in model
## space (right-handed, Y up, facing +Z, origin between the feet), metres.

## The two kinds of the thesis.
enum Type {
	## A capsule along its local Y axis.
	PILL,
	## A box with its edges along its local axes.
	BOX,
}

## Humanoid name of the bone that the limb moves.
@export var bone: StringName = &""
## Humanoid name of the limb that this one hangs on; empty for the root.
@export var parent_bone: StringName = &""
## What the limb collides as.
@export var type: Type = Type.PILL
## Centre of the shape, which is taken for the centre of mass.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var position: Vector3 = Vector3.ZERO
## Orientation of the shape.
@export var orientation: Quaternion = Quaternion.IDENTITY
## Radius of a pill.
@export_range(0.0, 1.0, 0.001, "suffix:m") var radius: float = 0.05
## Length of a pill's cylinder, without its caps (as in the thesis).
@export_range(0.0, 2.0, 0.001, "suffix:m") var length: float = 0.1
## Edge lengths of a box.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector3 = Vector3.ONE * 0.1
## Where the limb is joined to its parent.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var anchor: Vector3 = Vector3.ZERO
## Share of the body's mass.
@export_range(0.0, 1.0, 0.0001) var mass_fraction: float = 0.0


## The shape for the physics engine.
func make_shape() -> Shape3D:
	if type == Type.BOX:
		var box: BoxShape3D = BoxShape3D.new()
		box.size = size
		return box
	var capsule: CapsuleShape3D = CapsuleShape3D.new()
	capsule.radius = radius
	capsule.height = length + 2.0 * radius
	return capsule


## Principal moments of inertia about the centre, kg·m², in the shape's own axes, for a mass in kg.
func inertia(p_mass: float) -> Vector3:
	if type == Type.BOX:
		var square: Vector3 = size * size
		return (
			Vector3(square.y + square.z, square.x + square.z, square.x + square.y) * (p_mass / 12.0)
		)
	# A cylinder with two half balls, by volume.
	var cylinder: float = PI * radius * radius * length
	var ball: float = 4.0 / 3.0 * PI * radius ** 3
	var density: float = p_mass / (cylinder + ball)
	var half: float = length / 2.0
	var along: float = density * radius * radius * (cylinder / 2.0 + 0.4 * ball)
	var across: float = (
		density
		* (
			cylinder * (radius * radius / 4.0 + length * length / 12.0)
			+ ball * (0.4 * radius * radius + half * half + 0.75 * radius * half)
		)
	)
	return Vector3(across, along, across)


## Why this cannot be a limb, or an empty text if it can.
func find_fault() -> String:
	if bone == &"":
		return "it names no bone"
	if not position.is_finite() or not anchor.is_finite() or not orientation.is_finite():
		return "%s has a place or orientation that is not finite" % bone
	if absf(orientation.length() - 1.0) > 0.01:
		return "%s's orientation is not a rotation (norm %f)" % [bone, orientation.length()]
	if not (mass_fraction > 0.0 and mass_fraction <= 1.0):
		return "%s's mass_fraction is %f instead of above 0 and at most 1" % [bone, mass_fraction]
	if type == Type.PILL and not (radius > 0.0 and radius < 2.0 and length >= 0.0 and length < 4.0):
		return "%s's radius or length is no size of a limb" % bone
	var smallest: float = minf(size.x, minf(size.y, size.z))
	if type == Type.BOX and not (smallest > 0.0 and size.is_finite() and size.length() < 4.0):
		return "%s's sizes must be above 0 and those of a limb" % bone
	return ""

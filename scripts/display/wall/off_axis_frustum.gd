class_name OffAxisFrustum
extends RefCounted
## What an eye sees through a rectangle, such as a wall of a CAVE: Kooima, Generalized Perspective
## Projection, 2008. Pure geometry, in any frame, m.

## Axes of the rectangle: right, up, and towards the eye.
var basis: Basis = Basis.IDENTITY
## How far the eye is in front of it, m; 0 or less: it is on it or behind it.
var distance: float = 0.0
## Extent of the rectangle, m.
var extent: Vector2 = Vector2.ZERO
## From the point of its plane that is nearest to the eye to its middle, along its axes, m.
var shift: Vector2 = Vector2.ZERO


## For a rectangle by three of its corners, and an eye.
static func through(
	p_bottom_left: Vector3, p_bottom_right: Vector3, p_top_left: Vector3, p_eye: Vector3
) -> OffAxisFrustum:
	var found: OffAxisFrustum = OffAxisFrustum.new()
	var right: Vector3 = p_bottom_right - p_bottom_left
	var up: Vector3 = p_top_left - p_bottom_left
	found.extent = Vector2(right.length(), up.length())
	var out: Vector3 = right.cross(up).normalized()
	found.basis = Basis(right.normalized(), up.normalized(), out)
	var middle: Vector3 = p_bottom_left + 0.5 * (right + up) - p_eye
	found.distance = -out.dot(middle)
	found.shift = Vector2(right.normalized().dot(middle), up.normalized().dot(middle))
	return found


## Lets a camera see exactly what is behind the rectangle from here, from one distance to another,
## m. The picture's height is the rectangle's; a wider picture shows more at both sides.
func aim(p_camera: Camera3D, p_near_m: float, p_far_m: float) -> void:
	var scale: float = p_near_m / distance
	p_camera.keep_aspect = Camera3D.KEEP_HEIGHT
	p_camera.set_frustum(extent.y * scale, shift * scale, p_near_m, p_far_m)

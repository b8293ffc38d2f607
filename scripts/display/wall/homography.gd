class_name Homography
extends RefCounted
## The projective map between a unit square and four corners: Heckbert, Fundamentals of Texture
## Mapping and Image Warping, 1989, section 2.2.3.


## From the unit square to corners: those of (0, 0), (1, 0), (1, 1), (0, 1). As a matrix of columns
## that maps (x, y, 1). The zero matrix where three corners are in a line.
static func to_corners(p_corners: PackedVector2Array) -> Basis:
	var first: Vector2 = p_corners[1] - p_corners[2]
	var second: Vector2 = p_corners[3] - p_corners[2]
	var sum: Vector2 = p_corners[0] - p_corners[1] + p_corners[2] - p_corners[3]
	var cut: float = first.cross(second)
	if absf(cut) < 1e-12:
		return Basis(Vector3.ZERO, Vector3.ZERO, Vector3.ZERO)
	var g: float = sum.cross(second) / cut
	var h: float = first.cross(sum) / cut
	var right: Vector2 = p_corners[1] - p_corners[0] + g * p_corners[1]
	var down: Vector2 = p_corners[3] - p_corners[0] + h * p_corners[3]
	return Basis(
		Vector3(right.x, right.y, g),
		Vector3(down.x, down.y, h),
		Vector3(p_corners[0].x, p_corners[0].y, 1.0)
	)


## Whether four corners, in that order with y downwards, are a convex area that is not mirrored.
static func is_convex(p_corners: PackedVector2Array) -> bool:
	for at: int in 4:
		var here: Vector2 = p_corners[(at + 1) % 4] - p_corners[at]
		if here.cross(p_corners[(at + 2) % 4] - p_corners[(at + 1) % 4]) <= 1e-6:
			return false
	return true


## Where a map puts a point.
static func apply(p_map: Basis, p_point: Vector2) -> Vector2:
	var found: Vector3 = p_map * Vector3(p_point.x, p_point.y, 1.0)
	return Vector2(found.x, found.y) / found.z

class_name WallFrame
extends RefCounted
## A wall's own directions, to add bars and leaves to it: x along it, y up, z out of it, from its
## lower left corner as seen from outside.

var from: Vector3
var right: Vector3
var out: Vector3

var _mesh: BlockMesh


func _init(p_mesh: BlockMesh, p_from: Vector3, p_right: Vector3) -> void:
	_mesh = p_mesh
	from = p_from
	right = p_right
	out = p_right.cross(Vector3.UP)


## A point in the house's frame.
func point(p_x: float, p_y: float, p_z: float) -> Vector3:
	return from + right * p_x + Vector3.UP * p_y + out * p_z


## A box along the wall: x, y, width and height, and from where to where out of the wall.
func bar(
	p_rect: Rect2, p_near: float, p_far: float, p_layer: int, p_tint: int, p_is_solid: bool = false
) -> void:
	var a: Vector3 = point(p_rect.position.x, p_rect.position.y, p_near)
	var b: Vector3 = point(p_rect.end.x, p_rect.end.y, p_far)
	_mesh.box(a.min(b), a.max(b), p_layer, p_tint, 0, p_is_solid)


## A frame inside an opening, with a sill or without.
func border(
	p_rect: Rect2, p_wide: float, p_near: float, p_far: float, p_has_sill: bool, p_tint: int
) -> void:
	var wood: int = SurfaceLayers.Layer.PAINTED_WOOD
	var at: Vector2 = p_rect.position
	var size: Vector2 = p_rect.size
	bar(Rect2(at.x, at.y, p_wide, size.y), p_near, p_far, wood, p_tint)
	bar(Rect2(p_rect.end.x - p_wide, at.y, p_wide, size.y), p_near, p_far, wood, p_tint)
	var across: float = size.x - 2.0 * p_wide
	bar(Rect2(at.x + p_wide, p_rect.end.y - p_wide, across, p_wide), p_near, p_far, wood, p_tint)
	if p_has_sill:
		bar(Rect2(at.x + p_wide, at.y, across, p_wide), p_near, p_far, wood, p_tint)


## A leaf on a hinge that has been opened by an angle, rad; its hinge is at a point of the wall, it
## goes to the right when shut, inwards when open.
func leaf(p_hinge: Vector3, p_size: Vector2, p_angle: float, p_layer: int, p_tint: int) -> void:
	var way: Vector3 = right.rotated(Vector3.UP, p_angle)
	var base: Transform3D = _mesh.get_place()
	var basis: Basis = Basis(way, Vector3.UP, way.cross(Vector3.UP))
	_mesh.set_place(base * Transform3D(basis, point(p_hinge.x, p_hinge.y, p_hinge.z)))
	_mesh.box(
		Vector3(0.0, 0.0, -0.025), Vector3(p_size.x, p_size.y, 0.025), p_layer, p_tint, 0, true
	)
	for share: float in [0.1, 0.48, 0.84]:
		var y: float = p_size.y * share
		_mesh.box(
			Vector3(0.04, y, -0.045), Vector3(p_size.x - 0.04, y + 0.1, 0.045), p_layer, p_tint
		)
	_mesh.set_place(base)

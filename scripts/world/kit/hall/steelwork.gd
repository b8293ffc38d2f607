class_name Steelwork
extends RefCounted
## Beams, profiles and railings of painted steel between any two points of a block.

## What painted steel looks like.
const PAINT: SurfaceLayers.Layer = SurfaceLayers.Layer.PLASTER_PALE
const _POSTS_M: float = 1.25


## A beam of a width and a height (m) between the middles of its ends; its picture runs along it.
static func beam(
	p_mesh: BlockMesh,
	p_from: Vector3,
	p_to: Vector3,
	p_size: Vector2,
	p_layer: int,
	p_tint: int,
	p_is_solid: bool = false
) -> void:
	var length: float = p_from.distance_to(p_to)
	if length < 0.001:
		return
	var base: Transform3D = p_mesh.get_place()
	p_mesh.set_place(base * Transform3D(_basis_along(p_to - p_from), p_from))
	var half: Vector2 = p_size / 2.0
	p_mesh.box(
		Vector3(-half.x, 0.0, -half.y),
		Vector3(half.x, length, half.y),
		p_layer,
		p_tint,
		0,
		p_is_solid
	)
	p_mesh.set_place(base)


## A rolled profile: two flanges and a web between them, of a width and a height (m). It is one
## solid box where it is solid.
static func profile(
	p_mesh: BlockMesh,
	p_from: Vector3,
	p_to: Vector3,
	p_size: Vector2,
	p_tint: int,
	p_is_solid: bool = false
) -> void:
	const THICK: float = 0.025
	var base: Transform3D = p_mesh.get_place()
	p_mesh.set_place(base * Transform3D(_basis_along(p_to - p_from), p_from))
	var length: float = p_from.distance_to(p_to)
	var half: Vector2 = p_size / 2.0
	for side: float in [-half.y, half.y - THICK]:
		p_mesh.box(
			Vector3(-half.x, 0.0, side), Vector3(half.x, length, side + THICK), PAINT, p_tint
		)
	p_mesh.box(
		Vector3(-THICK / 2.0, 0.0, THICK - half.y),
		Vector3(THICK / 2.0, length, half.y - THICK),
		PAINT,
		p_tint
	)
	if p_is_solid:
		p_mesh.solid(Vector3(-half.x, 0.0, -half.y), Vector3(half.x, length, half.y))
	p_mesh.set_place(base)


## A railing that stands on the line between two points, of a height (m): posts, two rails and a
## board at the foot. Nobody gets through.
static func railing(
	p_mesh: BlockMesh, p_from: Vector3, p_to: Vector3, p_height: float, p_tint: int
) -> void:
	var count: int = maxi(1, ceili(p_from.distance_to(p_to) / _POSTS_M))
	for post: int in count + 1:
		var foot: Vector3 = p_from.lerp(p_to, float(post) / count)
		beam(p_mesh, foot, foot + Vector3.UP * p_height, Vector2(0.04, 0.04), PAINT, p_tint)
	for share: float in [0.52, 1.0]:
		var up: Vector3 = Vector3.UP * p_height * share
		p_mesh.rod(p_from + up, p_to + up, 0.024, 0.024, PAINT, p_tint, 6)
	var low: Vector3 = Vector3.UP * 0.07
	beam(p_mesh, p_from + low, p_to + low, Vector2(0.012, 0.12), PAINT, p_tint)
	guard(p_mesh, p_from, p_to, p_height)


## A solid sheet of a height (m) over the line between two points, which is not seen.
static func guard(p_mesh: BlockMesh, p_from: Vector3, p_to: Vector3, p_height: float) -> void:
	var base: Transform3D = p_mesh.get_place()
	var along: Vector3 = (p_to - p_from).normalized()
	var out: Vector3 = along.cross(Vector3.UP).normalized()
	p_mesh.set_place(base * Transform3D(Basis(along, out.cross(along), out), p_from))
	var length: float = p_from.distance_to(p_to)
	p_mesh.solid(Vector3(0.0, 0.0, -0.025), Vector3(length, p_height, 0.025))
	p_mesh.set_place(base)


## A basis with Y along a direction and X level.
static func _basis_along(p_way: Vector3) -> Basis:
	var along: Vector3 = p_way.normalized()
	if absf(along.y) > 0.999:
		return Basis(Vector3.RIGHT, Vector3.UP * signf(along.y), Vector3.BACK * signf(along.y))
	var level: Vector3 = along.cross(Vector3.UP).normalized()
	return Basis(level, along, level.cross(along))

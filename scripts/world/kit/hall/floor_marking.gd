@tool
@icon("res://scenes/world/icons/floor_marking.svg")
class_name FloorMarking
extends KitBlock
## Paint on a floor: a frame, a filled area or warning stripes, around its origin. It is only seen.

## What is painted.
enum Shape {
	## A line around the area.
	FRAME,
	## The whole area.
	AREA,
	## Slanting stripes over the area.
	STRIPES,
}

const _UP_M: float = 0.004

## Extent along X and Z.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector2 = Vector2(3.0, 2.0):
	set(p_value):
		size = p_value.clamp(Vector2(0.05, 0.05), Vector2(100.0, 100.0))
		queue_rebuild()
## What is painted.
@export var shape: Shape = Shape.FRAME:
	set(p_value):
		shape = p_value
		queue_rebuild()
## Width of lines and stripes.
@export_range(0.02, 1.0, 0.01, "suffix:m") var line: float = 0.1:
	set(p_value):
		line = clampf(p_value, 0.02, 1.0)
		queue_rebuild()
## Its colour.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.YELLOW:
	set(p_value):
		tint = p_value
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(
		FloorMarking, 1000, {"size": PropertyRule.vector2(0.05, 100.0)}
	)
	return entry


func contact_key() -> StringName:
	return &"concrete"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var half: Vector2 = size / 2.0
	match shape:
		Shape.AREA:
			_add(p_mesh, Rect2(-half, size))
		Shape.STRIPES:
			_add_stripes(p_mesh, half)
		_:
			var thick: float = minf(line, minf(half.x, half.y))
			var deep: float = size.y - 2.0 * thick
			_add(p_mesh, Rect2(-half.x, -half.y, size.x, thick))
			_add(p_mesh, Rect2(-half.x, half.y - thick, size.x, thick))
			_add(p_mesh, Rect2(-half.x, thick - half.y, thick, deep))
			_add(p_mesh, Rect2(half.x - thick, thick - half.y, thick, deep))


func _add(p_mesh: BlockMesh, p_rect: Rect2) -> void:
	var corner: Vector3 = Vector3(p_rect.position.x, _UP_M, p_rect.end.y)
	p_mesh.face(
		corner, Vector3.RIGHT, Vector3.FORWARD, p_rect.size, SurfaceLayers.Layer.PLASTER_PALE, tint
	)


func _add_stripes(p_mesh: BlockMesh, p_half: Vector2) -> void:
	var x: float = -p_half.x
	while x < p_half.x:
		var from: float = x
		var to: float = minf(x + line, p_half.x)
		var slant: float = minf(size.y, p_half.x - to)
		p_mesh.quad(
			Vector3(from + slant, _UP_M, -p_half.y),
			Vector3(to + slant, _UP_M, -p_half.y),
			Vector3(to, _UP_M, p_half.y),
			Vector3(from, _UP_M, p_half.y),
			SurfaceLayers.Layer.PLASTER_PALE,
			tint
		)
		x += line * 2.0

@tool
@icon("res://scenes/world/icons/sheet_fence.svg")
class_name SheetFence
extends KitBlock
## A fence of corrugated sheet between steel posts. It goes from its origin to +X.

const _POSTS_M: float = 2.5

## Length.
@export_range(0.5, 200.0, 0.1, "suffix:m") var length: float = 10.0:
	set(p_value):
		length = clampf(p_value, 0.5, 200.0)
		queue_rebuild()
## Height.
@export_range(0.5, 6.0, 0.1, "suffix:m") var height: float = 2.4:
	set(p_value):
		height = clampf(p_value, 0.5, 6.0)
		queue_rebuild()
## The sheet's colour.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.GREY_STONE:
	set(p_value):
		tint = p_value
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(SheetFence, 500)
	entry.offered("Sheet fence", "wall")
	return entry


func contact_key() -> StringName:
	return &"metal"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var iron: int = SurfaceTints.Tint.IRON
	p_mesh.set_dust(0.7, p_mesh.get_place().origin.y)
	p_mesh.box(
		Vector3(0.0, 0.06, -0.03),
		Vector3(length, height, 0.0),
		SurfaceLayers.Layer.CORRUGATED,
		tint
	)
	p_mesh.solid(Vector3(0.0, 0.0, -0.1), Vector3(length, height, 0.02))
	var count: int = maxi(1, roundi(length / _POSTS_M))
	for post: int in count + 1:
		var foot: Vector3 = Vector3(length * post / count, 0.0, -0.07)
		var top: Vector3 = foot + Vector3.UP * (height + 0.1)
		Steelwork.beam(p_mesh, foot, top, Vector2(0.08, 0.08), Steelwork.PAINT, iron)
	for y: float in [0.35, height - 0.3]:
		p_mesh.box(Vector3(0.0, y, -0.09), Vector3(length, y + 0.06, -0.03), Steelwork.PAINT, iron)
	p_mesh.set_dust(0.0, 0.0)

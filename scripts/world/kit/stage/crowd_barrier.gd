@tool
@icon("res://scenes/world/icons/crowd_barrier.svg")
class_name CrowdBarrier
extends KitBlock
## A barrier that keeps standing people from a stage: panels of bars from its origin along +X, with
## feet and struts towards -Z, where the stage is.

const _PANEL_M: float = 1.0
const _HIGH_M: float = 1.2

## Length.
@export_range(1.0, 60.0, 0.5, "suffix:m") var length: float = 6.0:
	set(p_value):
		length = clampf(p_value, 1.0, 60.0)
		queue_rebuild()
## Its colour.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.GREY_STONE:
	set(p_value):
		tint = p_value
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(CrowdBarrier, 200)
	entry.offered("Crowd barrier", "fence railing")
	return entry


func contact_key() -> StringName:
	return &"metal"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var panels: int = maxi(1, roundi(length / _PANEL_M))
	var wide: float = length / panels
	var paint: int = Steelwork.PAINT
	var thin: Vector2 = Vector2(0.04, 0.04)
	for post: int in panels + 1:
		var foot: Vector3 = Vector3.RIGHT * wide * post
		var top: Vector3 = foot + Vector3.UP * _HIGH_M
		Steelwork.beam(p_mesh, foot, top, thin, paint, tint)
		Steelwork.beam(
			p_mesh, foot + Vector3(0, 0.02, 0), foot + Vector3(0, 0.02, -1), thin, paint, tint
		)
		var strut: Vector3 = foot + Vector3(0.0, 0.02, -0.9)
		Steelwork.beam(p_mesh, strut, top + Vector3.DOWN * 0.1, Vector2(0.03, 0.03), paint, tint)
	for panel: int in panels:
		var from: float = wide * panel
		for bar: int in range(1, 8):
			var at: Vector3 = Vector3(from + wide * bar / 8.0, 0.06, 0.0)
			var high: Vector3 = at + Vector3.UP * (_HIGH_M - 0.1)
			p_mesh.rod(at, high, 0.01, 0.01, paint, tint, 5, false)
	p_mesh.rod(Vector3.UP * _HIGH_M, Vector3(length, _HIGH_M, 0.0), 0.035, 0.035, paint, tint, 10)
	p_mesh.box(
		Vector3(0.0, 0.0, -1.0),
		Vector3(length, 0.03, 0.0),
		SurfaceLayers.Layer.STEEL,
		SurfaceTints.Tint.PLAIN
	)
	Steelwork.guard(p_mesh, Vector3.ZERO, Vector3.RIGHT * length, _HIGH_M)

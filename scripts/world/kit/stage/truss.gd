@tool
@icon("res://scenes/world/icons/truss.svg")
class_name Truss
extends KitBlock
## A square truss of aluminium tubes that goes from the middle of its first end along +X. Turned
## upright it is a tower.

const _TUBE_M: float = 0.025
const _BRACE_M: float = 0.012

## Length.
@export_range(0.5, 60.0, 0.1, "suffix:m") var length: float = 6.0:
	set(p_value):
		length = clampf(p_value, 0.5, 60.0)
		queue_rebuild()
## Width and height.
@export_range(0.15, 1.5, 0.01, "suffix:m") var edge: float = 0.34:
	set(p_value):
		edge = clampf(p_value, 0.15, 1.5)
		queue_rebuild()
## Its colour.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.GREY_STONE:
	set(p_value):
		tint = p_value
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(Truss, 200)
	entry.offered("Truss", "beam tower", {}, 4.0)
	return entry


func contact_key() -> StringName:
	return &"metal"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var half: float = edge / 2.0
	var corners: Array[Vector3] = [
		Vector3(0.0, -half, -half),
		Vector3(0.0, -half, half),
		Vector3(0.0, half, half),
		Vector3(0.0, half, -half),
	]
	var paint: int = Steelwork.PAINT
	var bays: int = maxi(1, roundi(length / (edge * 1.4)))
	for side: int in 4:
		var here: Vector3 = corners[side]
		var next: Vector3 = corners[(side + 1) % 4]
		p_mesh.set_finest(2.5)
		p_mesh.rod(here, here + Vector3.RIGHT * length, _TUBE_M, _TUBE_M, paint, tint, 8)
		p_mesh.rod(here, next, _BRACE_M, _BRACE_M, paint, tint, 4, false)
		for bay: int in bays:
			var from: Vector3 = Vector3.RIGHT * (length * bay / bays)
			var to: Vector3 = Vector3.RIGHT * (length * (bay + 1) / bays)
			var low: Vector3 = here if bay % 2 == 0 else next
			var high: Vector3 = next if bay % 2 == 0 else here
			p_mesh.rod(low + from, high + to, _BRACE_M, _BRACE_M, paint, tint, 4, false)
			p_mesh.rod(here + to, next + to, _BRACE_M, _BRACE_M, paint, tint, 4, false)
		p_mesh.set_finest(1.25)
	p_mesh.solid(Vector3(0.0, -half, -half), Vector3(length, half, half))

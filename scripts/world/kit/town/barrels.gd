@tool
@icon("res://scenes/world/icons/barrel.svg")
class_name Barrels
extends KitBlock
## Steel barrels that stand together and do not move.

const _HIGH: float = 0.88
const _RADIUS: float = 0.29

## How many.
@export_range(1, 6) var count: int = 2:
	set(p_value):
		count = clampi(p_value, 1, 6)
		rebuild()
## Their colour.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.BLUE:
	set(p_value):
		tint = p_value
		rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(Barrels, 500)
	entry.offered("Barrels", "drum")
	return entry


func contact_key() -> StringName:
	return &"metal"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	for number: int in count:
		var z: float = -0.62 * (number / 3) - 0.05 * (number % 2)
		var at: Vector3 = Vector3(0.63 * (number % 3), 0.0, z)
		var metal: int = SurfaceLayers.Layer.METAL if number % 3 == 2 else SurfaceLayers.Layer.STEEL
		p_mesh.rod(at, at + Vector3.UP * _HIGH, _RADIUS, _RADIUS, metal, tint, 16)
		var wide: float = _RADIUS + 0.014
		for y: float in [0.02, 0.29, 0.57, 0.83]:
			var low: Vector3 = at + Vector3.UP * y
			p_mesh.rod(low, low + Vector3.UP * 0.03, wide, wide, metal, tint, 16)
		p_mesh.solid(at - Vector3(0.27, 0.0, 0.27), at + Vector3(0.27, _HIGH, 0.27))

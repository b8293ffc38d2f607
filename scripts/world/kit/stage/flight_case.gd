@tool
@icon("res://scenes/world/icons/flight_case.svg")
class_name FlightCase
extends KitBlock
## A case on wheels with edges of metal, as bands and crews use them; its origin is the middle of
## its foot. It is too heavy to push.

const _WHEEL_M: float = 0.12
const _EDGE_M: float = 0.03

## Width, height with the wheels, and depth.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector3 = Vector3(1.2, 0.8, 0.6):
	set(p_value):
		size = p_value.clamp(Vector3(0.3, 0.3, 0.3), Vector3(4.0, 3.0, 4.0))
		queue_rebuild()
## Its colour.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.GREY_STONE:
	set(p_value):
		tint = p_value
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(
		FlightCase, 500, {"size": PropertyRule.vector3(0.3, 4.0)}
	)
	entry.offered("Flight case", "box")
	return entry


func contact_key() -> StringName:
	return &"wood"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var half: Vector3 = size / 2.0
	var low: Vector3 = Vector3(-half.x, _WHEEL_M, -half.z)
	var high: Vector3 = Vector3(half.x, size.y, half.z)
	p_mesh.box(low, high, SurfaceLayers.Layer.ASPHALT, tint)
	p_mesh.solid(Vector3(-half.x, 0.0, -half.z), high)
	var paint: int = Steelwork.PAINT
	var metal: int = SurfaceTints.Tint.GREY_STONE
	var out: float = 0.004
	var span: Vector3 = (high - low) / 2.0
	var middle: Vector3 = (high + low) / 2.0
	for axis: int in 3:
		var one: int = (axis + 1) % 3
		var two: int = (axis + 2) % 3
		for corner: int in 4:
			var at: Vector3 = middle
			at[one] += (span[one] - _EDGE_M / 2.0 + out) * (1.0 if corner % 2 == 0 else -1.0)
			at[two] += (span[two] - _EDGE_M / 2.0 + out) * (1.0 if corner < 2 else -1.0)
			var reach: Vector3 = Vector3.ONE * _EDGE_M / 2.0
			reach[axis] = span[axis] + out
			p_mesh.box(at - reach, at + reach, paint, metal)
	var lid: float = size.y - (size.y - _WHEEL_M) * 0.3
	p_mesh.box(
		Vector3(-half.x - out, lid, -half.z - out),
		Vector3(half.x + out, lid + 0.03, half.z + out),
		paint,
		metal
	)
	for wheel: int in 4:
		var x: float = (half.x - 0.1) * (1.0 if wheel % 2 == 0 else -1.0)
		var z: float = (half.z - 0.1) * (1.0 if wheel < 2 else -1.0)
		var hub: Vector3 = Vector3(x - 0.02, 0.055, z)
		p_mesh.rod(
			hub, hub + Vector3.RIGHT * 0.04, 0.055, 0.055, paint, SurfaceTints.Tint.CLOTH_BLUE, 10
		)

@tool
@icon("res://scenes/world/icons/lamp.svg")
class_name CeilingLamp
extends KitBlock
## A lamp with a wide shade that hangs from a ceiling: its origin is where it hangs.

## Length of its cable.
@export_range(0.1, 10.0, 0.05, "suffix:m") var drop: float = 1.0:
	set(p_value):
		drop = clampf(p_value, 0.1, 10.0)
		queue_rebuild()
## Colour of its light.
@export var colour: Color = Color(0.96, 0.96, 1.0):
	set(p_value):
		colour = p_value
		queue_rebuild()
## Light on a surface 1 m away, as a part of the noon's sun.
@export_range(0.0, 60.0, 0.1) var strength: float = 14.0:
	set(p_value):
		strength = clampf(p_value, 0.0, 60.0)
		queue_rebuild()
## Where its light ends.
@export_range(2.0, 60.0, 0.5, "suffix:m") var reach: float = 22.0:
	set(p_value):
		reach = clampf(p_value, 2.0, 60.0)
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(CeilingLamp, 256)
	entry.offered("Ceiling lamp", "light", {}, 4.0)
	return entry


func contact_key() -> StringName:
	return &"metal"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var paint: int = Steelwork.PAINT
	var iron: int = SurfaceTints.Tint.BLACK
	var neck: Vector3 = Vector3.DOWN * drop
	p_mesh.rod(Vector3.ZERO, neck, 0.012, 0.012, paint, iron, 5, false)
	p_mesh.rod(neck + Vector3.UP * 0.12, neck, 0.07, 0.09, paint, SurfaceTints.Tint.IRON, 10)
	var rim: Vector3 = neck + Vector3.DOWN * 0.26
	var shade: int = SurfaceTints.Tint.DARK_GREEN
	p_mesh.rod(neck, rim, 0.1, 0.34, paint, shade, 20, false)
	# Its inside is seen from below.
	_add_cone(p_mesh, rim, neck)
	p_mesh.rod(neck, rim + Vector3.UP * 0.08, 0.08, 0.11, paint, SurfaceTints.Tint.LAMP, 12)


func get_lamps() -> Array[LampLight]:
	var at: Vector3 = Vector3.DOWN * (drop + 0.3)
	var lamp: LampLight = LampLight.make(at, colour.srgb_to_linear() * strength, reach)
	lamp.angle = 1.3
	return [lamp]


func _add_cone(p_mesh: BlockMesh, p_rim: Vector3, p_neck: Vector3) -> void:
	const SIDES: int = 20
	for side: int in SIDES:
		var from: Vector3 = Vector3.RIGHT.rotated(Vector3.UP, TAU * side / SIDES)
		var to: Vector3 = Vector3.RIGHT.rotated(Vector3.UP, TAU * (side + 1) / SIDES)
		p_mesh.quad(
			p_neck + to * 0.09,
			p_neck + from * 0.09,
			p_rim + from * 0.33,
			p_rim + to * 0.33,
			Steelwork.PAINT,
			SurfaceTints.Tint.WHITE
		)

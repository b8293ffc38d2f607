@tool
@icon("res://scenes/world/icons/lamp.svg")
class_name StreetLamp
extends KitBlock
## A wooden post with a lamp that shines at night. Its arm points to +X.

## Height of the post.
@export_range(2.5, 10.0, 0.1, "suffix:m") var height: float = 6.2:
	set(p_value):
		height = clampf(p_value, 2.5, 10.0)
		rebuild()
## Colour of its light.
@export var colour: Color = Color(1.0, 0.72, 0.4):
	set(p_value):
		colour = p_value
		rebuild()
## Light on a surface 1 m away, as a part of the noon's sun.
@export_range(0.0, 30.0, 0.1) var strength: float = 9.0:
	set(p_value):
		strength = clampf(p_value, 0.0, 30.0)
		rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(StreetLamp, 256)
	entry.offered("Street lamp", "light")
	return entry


func contact_key() -> StringName:
	return &"metal"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var wood: int = SurfaceLayers.Layer.WOOD
	var steel: int = SurfaceLayers.Layer.STEEL
	var iron: int = SurfaceTints.Tint.IRON
	var plain: int = SurfaceTints.Tint.PLAIN
	p_mesh.rod(Vector3.ZERO, Vector3.UP * height, 0.1, 0.075, wood, plain, 8)
	var cross: float = height - 0.45
	p_mesh.box(Vector3(-0.05, cross, -0.7), Vector3(0.05, cross + 0.12, 0.7), wood, plain)
	for z: float in [-0.62, 0.0, 0.62]:
		var foot: Vector3 = Vector3(0.0, cross + 0.12, z)
		var clay: int = SurfaceLayers.Layer.CLAY
		p_mesh.rod(foot, foot + Vector3.UP * 0.1, 0.03, 0.02, clay, SurfaceTints.Tint.WHITE, 6)
	var arm: Vector3 = _lamp_place() + Vector3.UP * 0.12
	p_mesh.rod(Vector3(0.0, arm.y - 0.35, 0.0), arm, 0.03, 0.025, steel, iron, 6, false)
	var shade: Vector3 = arm - Vector3.UP * 0.08
	p_mesh.rod(arm + Vector3.UP * 0.03, shade, 0.05, 0.2, steel, iron, 12)
	var pale: int = SurfaceLayers.Layer.PLASTER_PALE
	p_mesh.rod(shade, shade - Vector3.UP * 0.08, 0.11, 0.06, pale, SurfaceTints.Tint.LAMP, 10)
	p_mesh.solid(Vector3(-0.1, 0.0, -0.1), Vector3(0.1, height, 0.1))


func get_lamps() -> Array[LampLight]:
	var light: Color = colour.srgb_to_linear() * strength
	return [LampLight.make(_lamp_place() - Vector3.UP * 0.2, light, 16.0)]


func _lamp_place() -> Vector3:
	return Vector3(1.15, height - 1.25, 0.0)

@tool
@icon("res://scenes/world/icons/ramp.svg")
class_name Ramp
extends KitBlock
## A ramp of concrete that rises along -Z from its origin, closed down to the floor, with kerbs.

const _KERB: float = 0.12

## Width, height at its end, length over the floor.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector3 = Vector3(2.5, 1.0, 6.0):
	set(p_value):
		size = p_value.clamp(Vector3(0.6, 0.05, 0.3), Vector3(50.0, 10.0, 100.0))
		queue_rebuild()
## Whether kerbs keep wheels on it.
@export var has_kerbs: bool = true:
	set(p_value):
		has_kerbs = p_value
		queue_rebuild()
## What it is made of.
@export var surface: SurfaceLayers.Layer = SurfaceLayers.Layer.CONCRETE:
	set(p_value):
		surface = p_value
		queue_rebuild()
## Its colour.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.PLAIN:
	set(p_value):
		tint = p_value
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(Ramp, 500, {"size": PropertyRule.vector3(0.05, 100.0)})
	entry.offered("Ramp", "slope")
	return entry


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = super()
	if size.y > size.z * 0.6:
		warnings.append("People slide down what is steeper than about 30 degrees: make it longer.")
	return warnings


func contact_key() -> StringName:
	return SurfaceLayers.key_of(surface)


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	const THICK: float = 0.3
	var half: float = size.x / 2.0
	var angle: float = atan2(size.y, size.z)
	var length: float = Vector2(size.y, size.z).length()
	var up: Vector3 = Vector3(0.0, sin(angle), -cos(angle))
	var corner: Vector3 = Vector3(-half, 0.0, 0.0)
	p_mesh.face(corner, Vector3.RIGHT, up, Vector2(size.x, length), surface, tint)
	var top: float = size.y
	var back: Vector3 = Vector3(half, 0.0, -size.z)
	p_mesh.face(back, Vector3.LEFT, Vector3.UP, Vector2(size.x, top), surface, tint)
	for side: float in [-half, half]:
		var foot: Vector3 = Vector3(side, 0.0, 0.0)
		var far: Vector3 = Vector3(side, 0.0, -size.z)
		var peak: Vector3 = Vector3(side, top, -size.z)
		if side > 0.0:
			p_mesh.triangle(far, foot, peak, surface, tint)
		else:
			p_mesh.triangle(foot, far, peak, surface, tint)
	var base: Transform3D = p_mesh.get_place()
	var out: Vector3 = Vector3.RIGHT.cross(up)
	p_mesh.set_place(base * Transform3D(Basis(Vector3.RIGHT, up, out), corner))
	p_mesh.solid(Vector3(0.0, 0.0, -THICK), Vector3(size.x, length, 0.0))
	if has_kerbs:
		for x: float in [0.0, size.x - _KERB]:
			p_mesh.box(
				Vector3(x, 0.1, -0.05),
				Vector3(x + _KERB, length - 0.02, 0.1),
				SurfaceLayers.Layer.PLASTER_PALE,
				SurfaceTints.Tint.YELLOW,
				0,
				true
			)
	p_mesh.set_place(base)

@tool
@icon("res://scenes/world/icons/loudspeakers.svg")
class_name Loudspeakers
extends KitBlock
## Loudspeakers that hang below their origin in a bow, or stand on it; they point to +Z.

const _BOX: Vector3 = Vector3(1.1, 0.34, 0.55)

## How many.
@export_range(1, 16) var count: int = 6:
	set(p_value):
		count = clampi(p_value, 1, 16)
		queue_rebuild()
## How much more each points down than the one above.
@export_range(0.0, 12.0, 0.5, "suffix:°") var bow: float = 4.0:
	set(p_value):
		bow = clampf(p_value, 0.0, 12.0)
		queue_rebuild()
## Whether they stand on the ground, which makes them solid; else they hang.
@export var is_standing: bool = false:
	set(p_value):
		is_standing = p_value
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(Loudspeakers, 100)
	entry.offered("Loudspeakers", "sound", {}, 5.0)
	return entry


func contact_key() -> StringName:
	return &"wood"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var place: Transform3D = p_mesh.get_place()
	var hinge: Transform3D = Transform3D.IDENTITY
	if is_standing:
		hinge.origin = Vector3.UP * _BOX.y * count
		p_mesh.solid(
			Vector3(-_BOX.x / 2.0, 0.0, -_BOX.z), Vector3(_BOX.x / 2.0, _BOX.y * count, 0.0)
		)
	else:
		var paint: int = Steelwork.PAINT
		for side: float in [-0.4, 0.4]:
			var at: Vector3 = Vector3(side, 0.0, -0.3)
			p_mesh.rod(at, at + Vector3.UP * 0.9, 0.008, 0.008, paint, 0, 5, false)
		p_mesh.box(
			Vector3(-0.5, 0.0, -0.5), Vector3(0.5, 0.05, -0.1), paint, SurfaceTints.Tint.IRON
		)
	for number: int in count:
		p_mesh.set_place(place * hinge)
		_add_box(p_mesh)
		hinge = hinge.translated_local(Vector3.DOWN * _BOX.y)
		if not is_standing:
			hinge = hinge.rotated_local(Vector3.RIGHT, deg_to_rad(bow))
	p_mesh.set_place(place)


func _add_box(p_mesh: BlockMesh) -> void:
	var half: float = _BOX.x / 2.0
	var black: int = SurfaceTints.Tint.BLACK
	p_mesh.box(
		Vector3(-half, 0.01 - _BOX.y, -_BOX.z),
		Vector3(half, -0.01, -0.03),
		SurfaceLayers.Layer.ASPHALT,
		SurfaceTints.Tint.GREY_STONE
	)
	p_mesh.box(
		Vector3(0.03 - half, 0.03 - _BOX.y, -0.03),
		Vector3(half - 0.03, -0.03, 0.0),
		SurfaceLayers.Layer.STEEL,
		black
	)
	for side: float in [-half - 0.012, half - 0.008]:
		p_mesh.box(
			Vector3(side, -0.2, -_BOX.z + 0.05),
			Vector3(side + 0.02, -0.08, -0.1),
			Steelwork.PAINT,
			SurfaceTints.Tint.IRON
		)

@tool
@icon("res://scenes/world/icons/seat_row.svg")
class_name SeatRow
extends KitBlock
## A row of theatre seats around the middle of its foot; who sits there looks towards -Z. Nobody is
## seated by it: for seats that people use see [Seat].

## How many seats.
@export_range(1, 60) var count: int = 8:
	set(p_value):
		count = clampi(p_value, 1, 60)
		queue_rebuild()
## From seat to seat.
@export_range(0.45, 1.0, 0.01, "suffix:m") var pitch: float = 0.56:
	set(p_value):
		pitch = clampf(p_value, 0.45, 1.0)
		queue_rebuild()
## Colour of their cloth.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.CLOTH_WINE:
	set(p_value):
		tint = p_value
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(SeatRow, 200)
	entry.offered("Seats", "chair row audience")
	return entry


func contact_key() -> StringName:
	return &"wood"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var place: Transform3D = p_mesh.get_place()
	for seat: int in count:
		var x: float = (seat - (count - 1) / 2.0) * pitch
		p_mesh.set_place(place * Transform3D(Basis.IDENTITY, Vector3(x, 0.0, 0.0)))
		_add_seat(p_mesh)
	for end: int in count + 1:
		var x: float = (end - count / 2.0) * pitch
		p_mesh.set_place(place * Transform3D(Basis.IDENTITY, Vector3(x, 0.0, 0.0)))
		_add_arm(p_mesh)
	p_mesh.set_place(place)


## Cushion and back, whose top is rounded by a second piece.
func _add_seat(p_mesh: BlockMesh) -> void:
	var half: float = pitch / 2.0 - 0.03
	var cloth: int = Steelwork.PAINT
	var shell: int = SurfaceTints.Tint.BLACK
	p_mesh.box(Vector3(-half, 0.37, -0.24), Vector3(half, 0.47, 0.2), Steelwork.PAINT, tint)
	p_mesh.box(Vector3(-half, 0.34, -0.22), Vector3(half, 0.37, 0.2), cloth, shell)
	var place: Transform3D = p_mesh.get_place()
	var lean: Basis = Basis(Vector3.RIGHT, 0.2)
	p_mesh.set_place(place * Transform3D(lean, Vector3(0.0, 0.42, 0.2)))
	p_mesh.box(Vector3(-half, 0.0, -0.04), Vector3(half, 0.48, 0.05), Steelwork.PAINT, tint)
	p_mesh.box(
		Vector3(0.05 - half, 0.48, -0.03), Vector3(half - 0.05, 0.53, 0.05), Steelwork.PAINT, tint
	)
	p_mesh.box(Vector3(-half, 0.02, 0.05), Vector3(half, 0.5, 0.07), cloth, shell)
	p_mesh.set_place(place)
	p_mesh.solid(Vector3(-half, 0.0, -0.24), Vector3(half, 0.47, 0.3))
	p_mesh.solid(Vector3(-half, 0.47, 0.18), Vector3(half, 0.92, 0.34))


func _add_arm(p_mesh: BlockMesh) -> void:
	var paint: int = Steelwork.PAINT
	var iron: int = SurfaceTints.Tint.BLACK
	p_mesh.box(Vector3(-0.02, 0.0, -0.05), Vector3(0.02, 0.6, 0.16), paint, iron)
	p_mesh.box(Vector3(-0.03, 0.0, -0.1), Vector3(0.03, 0.02, 0.2), paint, iron)
	p_mesh.box(
		Vector3(-0.03, 0.6, -0.2),
		Vector3(0.03, 0.635, 0.22),
		SurfaceLayers.Layer.WOOD,
		SurfaceTints.Tint.PLAIN
	)

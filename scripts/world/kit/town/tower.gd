@tool
@icon("res://scenes/world/icons/tower.svg")
class_name Tower
extends KitBlock
## A slender tower with a gallery and a copper dome: a landmark.

const _HALF: float = 2.1
const _RINGS: int = 8
const _STONE: SurfaceLayers.Layer = SurfaceLayers.Layer.CONCRETE
const _TRIM: SurfaceTints.Tint = SurfaceTints.Tint.TRIM_PALE

## Height of its shaft.
@export_range(6.0, 30.0, 0.5, "suffix:m") var height: float = 14.0:
	set(p_value):
		height = clampf(p_value, 6.0, 30.0)
		rebuild()
## Colour of its walls.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.IVORY:
	set(p_value):
		tint = p_value
		rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(Tower, 50)
	entry.offered("Tower", "building")
	return entry


func stands_alone() -> bool:
	return true


func contact_key() -> StringName:
	return &"plaster"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var pale: int = SurfaceLayers.Layer.PLASTER_PALE
	var corner: Vector3 = Vector3(_HALF, height, _HALF)
	p_mesh.set_dust(1.0, p_mesh.get_place().origin.y)
	p_mesh.box(Vector3(-_HALF, 0.0, -_HALF), corner, pale, tint, BlockMesh.FACE_BOTTOM, true)
	for y: float in [0.0, height * 0.45, height]:
		var out: float = _HALF + (0.35 if y == height else 0.08)
		var top: float = y + (0.4 if y != 0.0 else 0.7)
		p_mesh.box(Vector3(-out, y, -out), Vector3(out, top, out), _STONE, _TRIM)
	for x: float in [-1.7, 1.7]:
		for z: float in [-1.7, 1.7]:
			var post: Vector3 = Vector3(x, height + 0.4, z)
			p_mesh.rod(post, post + Vector3.UP * 2.6, 0.26, 0.22, pale, tint, 10)
	var roof: Vector3 = Vector3(2.3, height + 3.4, 2.3)
	p_mesh.box(Vector3(-2.3, height + 3.0, -2.3), roof, _STONE, _TRIM)
	_add_dome(p_mesh, Vector3.UP * (height + 3.4))
	var base: Transform3D = p_mesh.get_place()
	for wall: int in 4:
		p_mesh.set_place(base * Transform3D(Basis(Vector3.UP, wall * PI / 2.0), Vector3.ZERO))
		for y: float in [height * 0.25, height * 0.62]:
			_add_window(p_mesh, y)
	p_mesh.set_place(base)


func _add_dome(p_mesh: BlockMesh, p_foot: Vector3) -> void:
	var steel: int = SurfaceLayers.Layer.STEEL
	var copper: int = SurfaceTints.Tint.COPPER
	for ring: int in _RINGS:
		var low: float = PI / 2.0 * ring / _RINGS
		var high: float = PI / 2.0 * (ring + 1) / _RINGS
		var from: Vector3 = p_foot + Vector3.UP * 2.1 * sin(low)
		var to: Vector3 = p_foot + Vector3.UP * 2.1 * sin(high)
		var wide: float = 2.0 * cos(high) + 0.02
		p_mesh.rod(from, to, 2.0 * cos(low), wide, steel, copper, 20, false)
	var tip: Vector3 = p_foot + Vector3.UP * 3.8
	p_mesh.rod(p_foot + Vector3.UP * 2.0, tip, 0.07, 0.02, steel, SurfaceTints.Tint.YELLOW, 6)


func _add_window(p_mesh: BlockMesh, p_y: float) -> void:
	var from: Vector3 = Vector3(-0.5, p_y - 0.12, _HALF - 0.05)
	p_mesh.box(from, Vector3(0.5, p_y + 1.9, _HALF + 0.06), _STONE, _TRIM)
	p_mesh.box(
		Vector3(-0.36, p_y, _HALF),
		Vector3(0.36, p_y + 1.76, _HALF + 0.08),
		SurfaceLayers.Layer.PAINTED_WOOD,
		SurfaceTints.Tint.TURQUOISE
	)

@tool
@icon("res://scenes/world/icons/gate.svg")
class_name Gate
extends KitBlock
## A town gate with a pointed arch and battlements, across +X; its middle is at the origin.

const _HIGH: float = 5.4
const _HALF: float = 0.9
const _SPRING: float = 2.6
const _PARTS: int = 16

## Width of the way through.
@export_range(2.0, 10.0, 0.1, "suffix:m") var way: float = 5.2:
	set(p_value):
		way = clampf(p_value, 2.0, 10.0)
		rebuild()
## Width of the whole.
@export_range(4.0, 40.0, 0.1, "suffix:m") var width: float = 11.0:
	set(p_value):
		width = clampf(p_value, 4.0, 40.0)
		rebuild()
## Colour of its walls.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.SAND:
	set(p_value):
		tint = p_value
		rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(Gate, 50)
	entry.offered("Gate", "arch")
	return entry


func stands_alone() -> bool:
	return true


func contact_key() -> StringName:
	return &"plaster"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var plaster: int = SurfaceLayers.Layer.PLASTER
	var stone: int = SurfaceLayers.Layer.CONCRETE
	var trim: int = SurfaceTints.Tint.TRIM_PALE
	var bottom: int = BlockMesh.FACE_BOTTOM
	p_mesh.set_dust(1.0, p_mesh.get_place().origin.y)
	var side: float = (maxf(width, way + 1.0) - way) / 2.0
	for left: float in [-way / 2.0 - side, way / 2.0]:
		var from: Vector3 = Vector3(left, 0.0, -_HALF)
		var to: Vector3 = Vector3(left + side, _HIGH, _HALF)
		p_mesh.box(from, to, plaster, tint, bottom, true)
		var foot: Vector3 = Vector3(left + side + 0.1, 0.6, _HALF + 0.1)
		p_mesh.box(from - Vector3(0.1, 0.0, 0.1), foot, stone, trim, bottom)
	_add_arch(p_mesh)
	var half: float = way / 2.0 + side
	var corner: Vector3 = Vector3(half + 0.05, _HIGH + 0.15, _HALF + 0.05)
	p_mesh.box(Vector3(-half - 0.05, _HIGH, -_HALF - 0.05), corner, stone, trim)
	var count: int = int(2.0 * half / 1.25)
	for number: int in count:
		var x: float = -half + 0.25 + (2.0 * half - 1.2) * number / maxi(count - 1, 1)
		var low: Vector3 = Vector3(x, _HIGH + 0.15, -_HALF + 0.1)
		p_mesh.box(low, Vector3(x + 0.7, _HIGH + 0.9, _HALF - 0.1), plaster, tint)


func _add_arch(p_mesh: BlockMesh) -> void:
	var hidden: int = BlockMesh.FACE_TOP | BlockMesh.FACE_LEFT | BlockMesh.FACE_RIGHT
	var plaster: int = SurfaceLayers.Layer.PLASTER
	for part: int in _PARTS:
		var low: float = INF
		for t: float in [float(part) / _PARTS, float(part + 1) / _PARTS]:
			low = minf(low, _SPRING + 2.0 * pow(sin(PI * t), 0.8))
		var x: float = lerpf(-way / 2.0, way / 2.0, float(part) / _PARTS)
		var to: Vector3 = Vector3(x + way / _PARTS, _HIGH, _HALF - 0.1)
		p_mesh.box(Vector3(x, low, -_HALF + 0.1), to, plaster, tint, hidden, true)

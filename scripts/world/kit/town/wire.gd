@tool
@icon("res://scenes/world/icons/wire.svg")
class_name Wire
extends KitBlock
## A wire that hangs between its origin and another point, with washing on it or without.

const _PARTS: int = 9
const _TINTS: Array[int] = [
	SurfaceTints.Tint.WHITE,
	SurfaceTints.Tint.CLOTH_BLUE,
	SurfaceTints.Tint.RED,
	SurfaceTints.Tint.CREAM,
	SurfaceTints.Tint.CLOTH_OLIVE,
]

## The other end, in the node's frame.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var end: Vector3 = Vector3(9.0, 0.0, 0.0):
	set(p_value):
		end = p_value.limit_length(60.0)
		rebuild()
## How far its middle hangs down.
@export_range(0.0, 5.0, 0.05, "suffix:m") var sag: float = 0.6:
	set(p_value):
		sag = clampf(p_value, 0.0, 5.0)
		rebuild()
## Pieces of washing.
@export_range(0, 20) var washing: int = 0:
	set(p_value):
		washing = clampi(p_value, 0, 20)
		rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(Wire, 500, {"end": PropertyRule.vector3(-60.0, 60.0)})
	entry.offered("Wire", "cable washing", {}, 3.0)
	return entry


func contact_key() -> StringName:
	return &"metal"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var steel: int = SurfaceLayers.Layer.STEEL
	var black: int = SurfaceTints.Tint.BLACK
	for part: int in _PARTS:
		var from: Vector3 = _at(float(part) / _PARTS)
		p_mesh.rod(from, _at(float(part + 1) / _PARTS), 0.012, 0.012, steel, black, 3, false)
	var way: Vector3 = Vector3(end.x, 0.0, end.z).normalized()
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = 7 + washing
	for number: int in washing:
		var place: Vector3 = _at(0.12 + 0.76 * (number + 0.5) / washing)
		var half: Vector3 = way * dice.randf_range(0.22, 0.38)
		var down: Vector3 = Vector3.DOWN * dice.randf_range(0.5, 1.0)
		var tint: int = _TINTS[dice.randi_range(0, 4)]
		var cloth: int = SurfaceLayers.Layer.BURLAP
		var left: Vector3 = place - half
		var right: Vector3 = place + half
		p_mesh.quad(left, right, right + down, left + down, cloth, tint)
		p_mesh.quad(right, left, left + down, right + down, cloth, tint)


func _at(p_share: float) -> Vector3:
	return end * p_share + Vector3.DOWN * sag * 4.0 * p_share * (1.0 - p_share)

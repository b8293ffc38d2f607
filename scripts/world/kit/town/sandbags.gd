@tool
@icon("res://scenes/world/icons/sandbags.svg")
class_name Sandbags
extends KitBlock
## A breastwork of sandbags, from its origin to +X: cover for who kneels.

const _BAG: Vector3 = Vector3(0.58, 0.17, 0.36)
const _INSET: Vector3 = Vector3(0.025, 0.0, 0.035)

## Length.
@export_range(0.6, 20.0, 0.1, "suffix:m") var length: float = 2.4:
	set(p_value):
		length = clampf(p_value, 0.6, 20.0)
		rebuild()
## Rows of bags, each 0.17 m high.
@export_range(1, 8) var rows: int = 6:
	set(p_value):
		rows = clampi(p_value, 1, 8)
		rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(Sandbags, 500)
	entry.offered("Sandbags", "cover")
	return entry


func contact_key() -> StringName:
	return &"cloth"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = seed_of_place()
	for row: int in rows:
		var x: float = 0.0 if row % 2 == 0 else -_BAG.x / 2.0
		while x < length - 0.1:
			var from: float = maxf(x, 0.0)
			var wide: float = minf(x + _BAG.x, length) - from
			var nudge: float = dice.randf_range(-0.03, 0.03)
			if wide > 0.15:
				_add_bag(p_mesh, Vector3(from, _BAG.y * row, nudge), wide)
			x += _BAG.x
	p_mesh.solid(Vector3(0.0, 0.0, -_BAG.z), Vector3(length, _BAG.y * rows, 0.0))


## A bag with rounded edges: two frustums, one on the other.
func _add_bag(p_mesh: BlockMesh, p_at: Vector3, p_wide: float) -> void:
	var burlap: int = SurfaceLayers.Layer.BURLAP
	var plain: int = SurfaceTints.Tint.PLAIN
	var rings: Array[PackedVector3Array] = []
	for level: int in 3:
		var by: Vector3 = _INSET if level != 1 else Vector3.ZERO
		var low: Vector3 = p_at + Vector3(0.01 + by.x, _BAG.y * level / 2.0, by.z - _BAG.z)
		var high: Vector3 = p_at + Vector3(p_wide - 0.01 - by.x, 0.0, -by.z)
		var ring: PackedVector3Array = [
			Vector3(low.x, low.y, high.z),
			Vector3(high.x, low.y, high.z),
			Vector3(high.x, low.y, low.z),
			low,
		]
		rings.append(ring)
	for level: int in 2:
		for corner: int in 4:
			var next: int = (corner + 1) % 4
			var upper: PackedVector3Array = rings[level + 1]
			var lower: PackedVector3Array = rings[level]
			p_mesh.quad(upper[corner], upper[next], lower[next], lower[corner], burlap, plain)
	p_mesh.quad(rings[2][3], rings[2][2], rings[2][1], rings[2][0], burlap, plain)

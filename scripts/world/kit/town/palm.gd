@tool
@icon("res://scenes/world/icons/palm.svg")
class_name Palm
extends KitBlock
## A date palm. It leans to +X.

const _RINGS: int = 8
const _FRONDS: int = 18
const _PARTS: int = 7

## Height of the trunk.
@export_range(2.0, 14.0, 0.1, "suffix:m") var height: float = 7.0:
	set(p_value):
		height = clampf(p_value, 2.0, 14.0)
		rebuild()
## How far its top leans.
@export_range(0.0, 3.0, 0.05, "suffix:m") var lean: float = 0.7:
	set(p_value):
		lean = clampf(p_value, 0.0, 3.0)
		rebuild()
## Chooses its leaves.
@export_range(0, 9999) var variant: int = 1:
	set(p_value):
		variant = clampi(p_value, 0, 9999)
		rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(Palm, 500)
	entry.offered("Palm", "tree plant")
	return entry


func contact_key() -> StringName:
	return &"wood"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var bark: int = SurfaceLayers.Layer.BARK
	var last: Vector3 = Vector3.ZERO
	for ring: int in _RINGS:
		var t: float = float(ring + 1) / _RINGS
		var next: Vector3 = Vector3(lean * t * t, height * t, 0.0)
		var thick: float = lerpf(0.23, 0.14, t)
		p_mesh.rod(last, next, thick * 0.92, thick * 1.12, bark, SurfaceTints.Tint.PLAIN, 8, false)
		last = next
	var crown: Vector3 = last + Vector3.UP * 0.35
	p_mesh.rod(last - Vector3.UP * 0.1, crown, 0.2, 0.1, bark, SurfaceTints.Tint.LEAF_DRY, 8)
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = variant
	for number: int in _FRONDS:
		var angle: float = TAU * number / _FRONDS + dice.randf_range(-0.15, 0.15)
		var lift: float = dice.randf_range(-0.45, 1.0)
		_add_frond(p_mesh, last + Vector3.UP * 0.2, angle, lift, dice.randf_range(2.1, 3.0))
	p_mesh.solid(Vector3(-0.2, 0.0, -0.2), Vector3(0.2, height * 0.6, 0.2))


## A leaf: its rib bends down, leaflets on both sides.
func _add_frond(
	p_mesh: BlockMesh, p_from: Vector3, p_angle: float, p_lift: float, p_length: float
) -> void:
	var out: Vector3 = Vector3(cos(p_angle), 0.0, sin(p_angle))
	var side: Vector3 = Vector3(-sin(p_angle), 0.0, cos(p_angle))
	var leaf: int = SurfaceLayers.Layer.LEAF
	var tint: int = SurfaceTints.Tint.LEAF if p_lift > -0.25 else SurfaceTints.Tint.LEAF_DRY
	for part: int in _PARTS:
		var ends: Array[Vector3] = []
		for t: float in [float(part) / _PARTS, float(part + 1) / _PARTS]:
			var rise: float = p_lift * 0.55 * t - 0.75 * t * t
			ends.append(p_from + (out * t + Vector3.UP * rise) * p_length)
		var middle: float = float(part) / _PARTS
		var wide: float = 0.66 * sin(PI * clampf(middle + 0.14, 0.0, 1.0)) + 0.06
		for way: int in [-1, 1]:
			for half: int in 2:
				var a: Vector3 = ends[0].lerp(ends[1], 0.5 * half)
				var b: Vector3 = ends[0].lerp(ends[1], 0.5 * half + 0.34)
				var tip: Vector3 = a + (side * way + out * 0.75) * wide + Vector3.DOWN * wide * 0.5
				p_mesh.triangle(a, tip, b, leaf, tint)
				p_mesh.triangle(a, b, tip, leaf, tint)

@tool
@icon("res://scenes/world/icons/rubble.svg")
class_name Rubble
extends KitBlock
## A heap of stones, which people step over or around.

## Radius of the heap.
@export_range(0.3, 6.0, 0.1, "suffix:m") var radius: float = 1.0:
	set(p_value):
		radius = clampf(p_value, 0.3, 6.0)
		rebuild()
## Largest stones.
@export_range(0.05, 2.0, 0.05, "suffix:m") var stone: float = 0.3:
	set(p_value):
		stone = clampf(p_value, 0.05, 2.0)
		rebuild()
## What the stones are.
@export var surface: SurfaceLayers.Layer = SurfaceLayers.Layer.ROCK:
	set(p_value):
		surface = p_value
		rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(Rubble, 500)
	entry.offered("Rubble", "stones")
	return entry


func contact_key() -> StringName:
	return SurfaceLayers.key_of(surface)


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = seed_of_place()
	var count: int = clampi(int(radius * radius * 12.0 / maxf(stone * 3.0, 0.3)), 5, 60)
	for number: int in count:
		var share: float = sqrt(dice.randf())
		var angle: float = dice.randf() * TAU
		var size: float = stone * dice.randf_range(0.25, 1.0) * (1.15 - 0.7 * share)
		var at: Vector3 = Vector3(cos(angle), 0.0, sin(angle)) * radius * share
		at.y = size * 0.15 + (1.0 - share) * stone * 0.5
		_add_stone(p_mesh, at, size, dice)
		if size > 0.12:
			p_mesh.solid(at - Vector3(0.6, 0.5, 0.6) * size, at + Vector3(0.6, 0.45, 0.6) * size)


func _add_stone(
	p_mesh: BlockMesh, p_at: Vector3, p_size: float, p_dice: RandomNumberGenerator
) -> void:
	const SIDES: int = 6
	var plain: int = SurfaceTints.Tint.PLAIN
	var ring: PackedVector3Array = []
	var upper: PackedVector3Array = []
	for side: int in SIDES:
		var angle: float = TAU * side / SIDES
		var out: Vector3 = Vector3(cos(angle), 0.0, sin(angle)) * p_size
		ring.append(p_at + out * p_dice.randf_range(0.7, 1.0) - Vector3.UP * p_size * 0.3)
		var lift: Vector3 = Vector3.UP * p_size * p_dice.randf_range(0.3, 0.5)
		upper.append(p_at + out * p_dice.randf_range(0.4, 0.7) + lift)
	var top: Vector3 = p_at + Vector3.UP * p_size * 0.5
	for side: int in SIDES:
		var next: int = (side + 1) % SIDES
		p_mesh.triangle(ring[side], ring[next], upper[side], surface, plain)
		p_mesh.triangle(ring[next], upper[next], upper[side], surface, plain)
		p_mesh.triangle(top, upper[side], upper[next], surface, plain)

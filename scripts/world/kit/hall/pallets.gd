@tool
@icon("res://scenes/world/icons/pallets.svg")
class_name Pallets
extends KitBlock
## A row of pallets along X with loads on them, or a pile of empty ones.

## How many stand side by side.
@export_range(1, 12) var count: int = 1:
	set(p_value):
		count = clampi(p_value, 1, 12)
		queue_rebuild()
## Height of a load at most; 0 for piles of empty pallets.
@export_range(0.0, 2.4, 0.05, "suffix:m") var height: float = 1.1:
	set(p_value):
		height = clampf(p_value, 0.0, 2.4)
		queue_rebuild()
## Chooses the loads.
@export_range(0, 9999) var variant: int = 1:
	set(p_value):
		variant = clampi(p_value, 0, 9999)
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(Pallets, 1000)
	entry.offered("Pallets", "goods")
	return entry


func contact_key() -> StringName:
	return &"wood"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = variant
	for number: int in count:
		var at: Vector3 = Vector3(1.35 * number, 0.0, dice.randf_range(-0.06, 0.06))
		var top: float = 0.0
		if height > 0.2:
			top = Goods.add_load(p_mesh, at, height, dice)
		else:
			for pallet: int in dice.randi_range(4, 9):
				Goods.add_pallet(p_mesh, at + Vector3.UP * top)
				top += Goods.PALLET.y
		var half: Vector3 = Goods.PALLET / 2.0
		p_mesh.solid(at - Vector3(half.x, 0.0, half.z), at + Vector3(half.x, top, half.z))

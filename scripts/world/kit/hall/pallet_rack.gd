@tool
@icon("res://scenes/world/icons/pallet_rack.svg")
class_name PalletRack
extends KitBlock
## Shelves for pallets: blue posts, orange beams, loads on every board. It goes from its origin to
## +X and opens to +Z.

const _BAY_M: float = 2.8
const _DEEP_M: float = 1.1

## Number of bays side by side, 2.8 m each.
@export_range(1, 10) var bays: int = 2:
	set(p_value):
		bays = clampi(p_value, 1, 10)
		queue_rebuild()
## Number of boards above the floor.
@export_range(1, 6) var levels: int = 2:
	set(p_value):
		levels = clampi(p_value, 1, 6)
		queue_rebuild()
## Distance of boards.
@export_range(0.8, 3.0, 0.05, "suffix:m") var pitch: float = 1.6:
	set(p_value):
		pitch = clampf(p_value, 0.8, 3.0)
		queue_rebuild()
## Share of the places that are taken.
@export_range(0.0, 1.0, 0.05) var fill: float = 0.8:
	set(p_value):
		fill = clampf(p_value, 0.0, 1.0)
		queue_rebuild()
## Chooses the loads.
@export_range(0, 9999) var variant: int = 1:
	set(p_value):
		variant = clampi(p_value, 0, 9999)
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(PalletRack, 300)
	entry.offered("Pallet rack", "shelf goods")
	return entry


func contact_key() -> StringName:
	return &"metal"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = variant
	for post: int in bays + 1:
		_add_posts(p_mesh, _BAY_M * post)
	for bay: int in bays:
		var x: float = _BAY_M * bay
		for level: int in levels + 1:
			var y: float = pitch * level
			if level > 0:
				_add_board(p_mesh, x, y)
			for side: int in 2:
				if dice.randf() > fill:
					continue
				var at: Vector3 = Vector3(x + 0.75 + 1.3 * side, y, -_DEEP_M / 2.0)
				var high: float = Goods.add_load(p_mesh, at, pitch - 0.35, dice)
				var half: Vector3 = Goods.PALLET / 2.0
				p_mesh.solid(at - Vector3(half.x, 0.0, half.z), at + Vector3(half.x, high, half.z))


func _add_posts(p_mesh: BlockMesh, p_x: float) -> void:
	var blue: int = SurfaceTints.Tint.NAVY
	var size: Vector2 = Vector2(0.09, 0.07)
	var high: float = pitch * levels + 0.9
	for z: float in [-0.05, 0.05 - _DEEP_M]:
		var foot: Vector3 = Vector3(p_x, 0.0, z)
		Steelwork.beam(p_mesh, foot, foot + Vector3.UP * high, size, Steelwork.PAINT, blue, true)
		p_mesh.box(
			foot - Vector3(0.09, 0.0, 0.07),
			foot + Vector3(0.09, 0.012, 0.07),
			Steelwork.PAINT,
			SurfaceTints.Tint.IRON
		)
	var y: float = 0.25
	var is_front: bool = true
	while y + 0.75 < high:
		var near: float = -0.05 if is_front else 0.05 - _DEEP_M
		var far: float = 0.05 - _DEEP_M if is_front else -0.05
		var from: Vector3 = Vector3(p_x, y, near)
		var to: Vector3 = Vector3(p_x, y + 0.75, far)
		Steelwork.beam(p_mesh, from, to, Vector2(0.03, 0.03), Steelwork.PAINT, blue)
		y += 0.75
		is_front = not is_front
	Steelwork.guard(p_mesh, Vector3(p_x, 0.0, 0.0), Vector3(p_x, 0.0, -_DEEP_M), high)


func _add_board(p_mesh: BlockMesh, p_x: float, p_y: float) -> void:
	for z: float in [-0.03, 0.03 - _DEEP_M]:
		p_mesh.box(
			Vector3(p_x + 0.045, p_y - 0.14, z - 0.025),
			Vector3(p_x + _BAY_M - 0.045, p_y - 0.02, z + 0.025),
			Steelwork.PAINT,
			SurfaceTints.Tint.ORANGE
		)
	var board: int = SurfaceLayers.Layer.WOOD
	var low: Vector3 = Vector3(p_x + 0.05, p_y - 0.03, -_DEEP_M + 0.05)
	var high: Vector3 = Vector3(p_x + _BAY_M - 0.05, p_y, -0.05)
	p_mesh.box(low, high, board, SurfaceTints.Tint.OCHRE, 0, true)

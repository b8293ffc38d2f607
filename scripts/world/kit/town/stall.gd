@tool
@icon("res://scenes/world/icons/stall.svg")
class_name Stall
extends KitBlock
## A market stall: a counter with goods under a cloth roof. It is 2.6 m wide and opens to +Z.

const _WIDE: float = 2.6
const _DEEP: float = 1.9
const _FRONT_M: float = 2.15
const _BACK_M: float = 2.5
const _FRUIT: Array[int] = [
	SurfaceTints.Tint.RED,
	SurfaceTints.Tint.ORANGE,
	SurfaceTints.Tint.YELLOW,
	SurfaceTints.Tint.LEAF,
	SurfaceTints.Tint.CLOTH_WINE,
]

## Colour of the cloth.
@export var cloth: SurfaceTints.Tint = SurfaceTints.Tint.PLAIN:
	set(p_value):
		cloth = p_value
		rebuild()
## Chooses what is on sale.
@export_range(0, 9999) var variant: int = 1:
	set(p_value):
		variant = clampi(p_value, 0, 9999)
		rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(Stall, 200)
	entry.offered("Stall", "market")
	return entry


func contact_key() -> StringName:
	return &"wood"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var wood: int = SurfaceLayers.Layer.WOOD
	var plain: int = SurfaceTints.Tint.PLAIN
	var x: float = _WIDE / 2.0
	for side: float in [-x, x]:
		for z: float in [0.0, -_DEEP]:
			var foot: Vector3 = Vector3(side, 0.0, z)
			var top: Vector3 = foot + Vector3.UP * (_FRONT_M if z == 0.0 else _BACK_M)
			p_mesh.rod(foot, top, 0.035, 0.03, wood, plain, 6, false)
			p_mesh.solid(foot - Vector3(0.03, 0.0, 0.03), top + Vector3(0.03, 0.0, 0.03))
	_add_roof(p_mesh, x + 0.25)
	p_mesh.box(Vector3(-x + 0.1, 0.72, -0.85), Vector3(x - 0.1, 0.78, -0.1), wood, plain)
	for side: float in [-x + 0.15, x - 0.21]:
		for z: float in [-0.8, -0.2]:
			p_mesh.box(Vector3(side, 0.0, z), Vector3(side + 0.06, 0.72, z + 0.06), wood, plain)
	p_mesh.solid(Vector3(-x + 0.1, 0.0, -0.85), Vector3(x - 0.1, 0.8, -0.1))
	_add_goods(p_mesh, x)


func _add_roof(p_mesh: BlockMesh, p_x: float) -> void:
	const STRIPS: int = 4
	var fabric: int = SurfaceLayers.Layer.FABRIC
	for strip: int in STRIPS:
		var edge: Array[Vector2] = []
		for t: float in [float(strip) / STRIPS, float(strip + 1) / STRIPS]:
			var y: float = lerpf(_BACK_M, _FRONT_M, t) - 0.14 * sin(PI * t)
			edge.append(Vector2(lerpf(-_DEEP, 0.35, t), y))
		var a: Vector3 = Vector3(-p_x, edge[0].y, edge[0].x)
		var b: Vector3 = Vector3(p_x, edge[0].y, edge[0].x)
		var c: Vector3 = Vector3(p_x, edge[1].y, edge[1].x)
		var d: Vector3 = Vector3(-p_x, edge[1].y, edge[1].x)
		p_mesh.quad(a, b, c, d, fabric, cloth)
		p_mesh.quad(d, c, b, a, fabric, cloth)


## Boxes with heaps in them, and sacks.
func _add_goods(p_mesh: BlockMesh, p_x: float) -> void:
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = variant
	var wood: int = SurfaceLayers.Layer.WOOD
	var at: float = -p_x + 0.18
	while at < p_x - 0.65:
		var corner: Vector3 = Vector3(at, 0.78, -0.75)
		p_mesh.box(corner, corner + Vector3(0.5, 0.14, 0.55), wood, SurfaceTints.Tint.TAN)
		_add_heap(p_mesh, corner, _FRUIT[dice.randi_range(0, 4)], dice)
		at += 0.58
	for number: int in 3:
		var place: Vector3 = Vector3(-p_x + 0.3 + 0.55 * number, 0.0, 0.25)
		var sack: int = SurfaceLayers.Layer.BURLAP
		var plain: int = SurfaceTints.Tint.PLAIN
		p_mesh.rod(place, place + Vector3.UP * 0.38, 0.22, 0.19, sack, plain, 10)
	p_mesh.solid(Vector3(-p_x + 0.1, 0.0, 0.05), Vector3(-p_x + 1.6, 0.4, 0.45))


func _add_heap(
	p_mesh: BlockMesh, p_corner: Vector3, p_tint: int, p_dice: RandomNumberGenerator
) -> void:
	for number: int in 9:
		var x: float = p_dice.randf_range(0.08, 0.42)
		var place: Vector3 = p_corner + Vector3(x, 0.12, p_dice.randf_range(0.08, 0.47))
		var size: float = p_dice.randf_range(0.045, 0.075)
		var top: Vector3 = place + Vector3.UP * (size + 0.02)
		var pale: int = SurfaceLayers.Layer.PLASTER_PALE
		p_mesh.rod(place, top, size, size * 0.45, pale, p_tint, 7)

class_name HouseFurniture
extends RefCounted
## Furniture of a storey of a [House], along its walls, clear of its doors.

const WOOD: SurfaceLayers.Layer = SurfaceLayers.Layer.WOOD
const CLOTH: SurfaceLayers.Layer = SurfaceLayers.Layer.BURLAP
const POT: SurfaceLayers.Layer = SurfaceLayers.Layer.CLAY
const PLAIN: int = SurfaceTints.Tint.PLAIN
const CLOTHS: Array[int] = [
	SurfaceTints.Tint.CLOTH_WINE,
	SurfaceTints.Tint.CLOTH_BLUE,
	SurfaceTints.Tint.CLOTH_OLIVE,
	SurfaceTints.Tint.RED,
]

var _mesh: BlockMesh
var _plan: HousePlan
var _rect: Rect2
var _storey: int
var _y: float
var _dice: RandomNumberGenerator


func _init(p_mesh: BlockMesh, p_plan: HousePlan, p_rect: Rect2, p_storey: int) -> void:
	_mesh = p_mesh
	_plan = p_plan
	_rect = p_rect
	_storey = p_storey
	_y = HousePlan.GROUND_FLOOR_M if p_storey == 0 else p_storey * HousePlan.STOREY_M
	_dice = p_plan.dice


## Adds the furniture of the front room and of the back room.
func build() -> void:
	_mesh.set_finest(0.9)
	var left: float = _rect.position.x
	var front: float = -_rect.position.y
	var back: float = -_rect.end.y
	_add_rug(Vector3(_rect.get_center().x, _y, front - 2.1))
	if _storey == 0 and _plan.openings[0][0][0].kind == HousePlan.Kind.SHOP:
		_add_shelf(Vector3(left, _y, front - 3.4), 1.9)
		_add_sacks(Vector3(left + 0.5, _y, front - 1.6))
	elif _dice.randf() < 0.5:
		_add_table(Vector3(left + 1.0, _y, front - 2.6))
	else:
		_add_cushions(Vector3(left, _y, front - 1.1))
	# The back room.
	if _storey > 0 or _dice.randf() < 0.4:
		_add_bed(Vector3(left, _y, back))
		_add_chest(Vector3(left + 0.1, _y, back + 2.3))
	else:
		_add_shelf(Vector3(left, _y, back + 2.2), 1.6)
		_add_table(Vector3(left + 1.1, _y, back + 0.9))
	if _dice.randf() < 0.7:
		_add_pots(Vector3(left + 0.3, _y, front - 0.4))
	_mesh.set_finest(0.7)


func _add_rug(p_at: Vector3) -> void:
	var half: Vector3 = Vector3(minf(1.3, _rect.size.x / 2.0 - 0.4), 0.0, 0.85)
	_mesh.box(p_at - half, p_at + half + Vector3.UP * 0.012, SurfaceLayers.Layer.CARPET, PLAIN)


func _add_table(p_at: Vector3) -> void:
	const HIGH: float = 0.74
	var half: Vector3 = Vector3(0.65, 0.0, 0.42)
	_mesh.box(
		p_at - half + Vector3.UP * (HIGH - 0.04), p_at + half + Vector3.UP * HIGH, WOOD, PLAIN
	)
	for x: float in [-0.58, 0.52]:
		for z: float in [-0.35, 0.29]:
			var leg: Vector3 = p_at + Vector3(x, 0.0, z)
			_mesh.box(leg, leg + Vector3(0.06, HIGH - 0.04, 0.06), WOOD, PLAIN)
	_mesh.solid(p_at - half, p_at + half + Vector3.UP * HIGH)
	_mesh.rod(
		p_at + Vector3.UP * HIGH, p_at + Vector3.UP * (HIGH + 0.16), 0.05, 0.08, POT, PLAIN, 10
	)
	_add_stool(p_at + Vector3(0.2, 0.0, 0.75))
	_add_stool(p_at + Vector3(-0.35, 0.0, -0.72))


func _add_stool(p_at: Vector3) -> void:
	_mesh.rod(p_at + Vector3.UP * 0.4, p_at + Vector3.UP * 0.45, 0.18, 0.18, WOOD, PLAIN, 12)
	for number: int in 3:
		var out: Vector3 = Vector3.RIGHT.rotated(Vector3.UP, TAU * number / 3.0)
		_mesh.rod(
			p_at + out * 0.17,
			p_at + out * 0.1 + Vector3.UP * 0.4,
			0.02,
			0.02,
			WOOD,
			PLAIN,
			5,
			false
		)
	_mesh.solid(p_at - Vector3(0.15, 0.0, 0.15), p_at + Vector3(0.15, 0.45, 0.15))


## A low seat along the left wall.
func _add_cushions(p_at: Vector3) -> void:
	var tint: int = CLOTHS[_dice.randi_range(0, 3)]
	for number: int in 3:
		var corner: Vector3 = p_at + Vector3(0.05, 0.0, -0.85 * number)
		_mesh.box(corner + Vector3(0.0, 0.0, -0.8), corner + Vector3(0.7, 0.22, 0.0), CLOTH, tint)
		_mesh.box(
			corner + Vector3(0.0, 0.22, -0.75), corner + Vector3(0.18, 0.6, -0.05), CLOTH, tint
		)
	_mesh.solid(p_at + Vector3(0.05, 0.0, -2.5), p_at + Vector3(0.75, 0.22, 0.0))


func _add_bed(p_at: Vector3) -> void:
	const LONG: float = 2.0
	var corner: Vector3 = p_at + Vector3(0.05, 0.0, 0.08)
	_mesh.box(corner, corner + Vector3(0.95, 0.28, LONG), WOOD, PLAIN)
	_mesh.box(
		corner + Vector3(0.03, 0.28, 0.03),
		corner + Vector3(0.92, 0.45, LONG - 0.03),
		CLOTH,
		CLOTHS[_dice.randi_range(0, 3)]
	)
	_mesh.box(
		corner + Vector3(0.12, 0.45, 0.08),
		corner + Vector3(0.83, 0.57, 0.5),
		CLOTH,
		SurfaceTints.Tint.WHITE
	)
	_mesh.solid(corner, corner + Vector3(0.95, 0.47, LONG))


func _add_chest(p_at: Vector3) -> void:
	_mesh.box(p_at, p_at + Vector3(0.5, 0.5, 0.85), WOOD, PLAIN, 0, true)
	_mesh.box(p_at + Vector3(-0.02, 0.5, -0.02), p_at + Vector3(0.53, 0.56, 0.87), WOOD, PLAIN)


## A shelf along the left wall.
func _add_shelf(p_at: Vector3, p_long: float) -> void:
	const HIGH: float = 1.8
	const DEEP: float = 0.38
	for z: float in [0.0, p_long - 0.04]:
		_mesh.box(p_at + Vector3(0.02, 0.0, z), p_at + Vector3(DEEP, HIGH, z + 0.04), WOOD, PLAIN)
	for number: int in 4:
		var y: float = 0.15 + 0.5 * number
		_mesh.box(
			p_at + Vector3(0.02, y, 0.04),
			p_at + Vector3(DEEP, y + 0.03, p_long - 0.04),
			WOOD,
			PLAIN
		)
		_add_goods(p_at + Vector3(0.08, y + 0.03, 0.12), p_long - 0.24)
	_mesh.solid(p_at, p_at + Vector3(DEEP, HIGH, p_long))


func _add_goods(p_at: Vector3, p_long: float) -> void:
	var z: float = 0.0
	while z < p_long - 0.25:
		var wide: float = _dice.randf_range(0.1, 0.26)
		var high: float = _dice.randf_range(0.1, 0.34)
		match _dice.randi_range(0, 3):
			0:
				var tint: int = SurfaceTints.Tint.BLUE + _dice.randi_range(0, 7)
				_mesh.box(
					p_at + Vector3(0.02, 0.0, z),
					p_at + Vector3(0.22, high, z + wide),
					SurfaceLayers.Layer.PAINTED_WOOD,
					tint
				)
			1:
				var middle: Vector3 = p_at + Vector3(0.13, 0.0, z + wide / 2.0)
				_mesh.rod(
					middle, middle + Vector3.UP * high, wide * 0.4, wide * 0.28, POT, PLAIN, 8
				)
			2:
				_mesh.box(
					p_at + Vector3(0.0, 0.0, z),
					p_at + Vector3(0.24, high * 0.6, z + wide),
					CLOTH,
					CLOTHS[_dice.randi_range(0, 3)]
				)
		z += wide + _dice.randf_range(0.03, 0.12)


func _add_sacks(p_at: Vector3) -> void:
	for number: int in 4:
		var at: Vector3 = p_at + Vector3(0.5 * (number % 2), 0.0, -0.5 * (number / 2))
		_mesh.rod(at, at + Vector3.UP * 0.42, 0.24, 0.2, CLOTH, PLAIN, 10)
		_mesh.rod(at + Vector3.UP * 0.42, at + Vector3.UP * 0.52, 0.2, 0.07, CLOTH, PLAIN, 10)
	_mesh.solid(p_at - Vector3(0.22, 0.0, 0.7), p_at + Vector3(0.72, 0.45, 0.22))


func _add_pots(p_at: Vector3) -> void:
	for number: int in 3:
		var at: Vector3 = p_at + Vector3(0.34 * number, 0.0, -0.1 * (number % 2))
		var high: float = _dice.randf_range(0.3, 0.55)
		_mesh.rod(at, at + Vector3.UP * high * 0.6, 0.1, 0.17, POT, PLAIN, 12)
		_mesh.rod(at + Vector3.UP * high * 0.6, at + Vector3.UP * high, 0.17, 0.08, POT, PLAIN, 12)
	_mesh.solid(p_at - Vector3(0.15, 0.0, 0.25), p_at + Vector3(0.83, 0.4, 0.15))

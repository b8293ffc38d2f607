class_name HouseDetails
extends RefCounted
## The small things on a [House]: stained feet of walls, beams, spouts, tanks, aerials, rugs.

const STONE: SurfaceLayers.Layer = SurfaceLayers.Layer.CONCRETE
const METAL: SurfaceLayers.Layer = SurfaceLayers.Layer.CORRUGATED
const IRON: SurfaceLayers.Layer = SurfaceLayers.Layer.STEEL

var _mesh: BlockMesh
var _plan: HousePlan
var _dice: RandomNumberGenerator
var _top: float


func _init(p_mesh: BlockMesh, p_plan: HousePlan) -> void:
	_mesh = p_mesh
	_plan = p_plan
	_dice = p_plan.dice
	_top = p_plan.storeys * HousePlan.STOREY_M


## Adds what chance gives this house.
func build() -> void:
	if _dice.randf() < 0.6:
		_add_foot()
	if _dice.randf() < 0.55:
		_add_beams()
	_add_spouts()
	if _plan.storeys > 1 and _dice.randf() < 0.5:
		_add_cooler()
	if _dice.randf() < 0.5:
		_add_tank()
	if _dice.randf() < 0.5:
		_add_aerial()
	if _dice.randf() < 0.35:
		_add_rug()


func _add_foot() -> void:
	const DEEP: float = 0.045
	var high: float = _dice.randf_range(0.35, 0.7)
	for wall: int in [HousePlan.Facade.RIGHT, HousePlan.Facade.LEFT]:
		var frame: WallFrame = _frame(wall as HousePlan.Facade, 0.0)
		var length: float = _plan.length_of(wall as HousePlan.Facade)
		frame.bar(Rect2(-DEEP, 0.0, length + 2.0 * DEEP, high), 0.0, DEEP, STONE, _plan.trim)


## Ends of the beams that bear the roof.
func _add_beams() -> void:
	var frame: WallFrame = _frame(HousePlan.Facade.FRONT, _top)
	var x: float = 0.5
	while x < _plan.width - 0.3:
		_mesh.rod(
			frame.point(x, -0.32, -0.1),
			frame.point(x, -0.32, _dice.randf_range(0.28, 0.42)),
			0.075,
			0.07,
			SurfaceLayers.Layer.WOOD,
			SurfaceTints.Tint.PLAIN,
			7
		)
		x += 0.72


func _add_spouts() -> void:
	var frame: WallFrame = _frame(HousePlan.Facade.FRONT, _top)
	for share: float in [0.2, 0.8]:
		frame.bar(
			Rect2(_plan.width * share, 0.02, 0.14, 0.11), -0.05, 0.5, METAL, SurfaceTints.Tint.IRON
		)


func _add_cooler() -> void:
	var frame: WallFrame = _frame(HousePlan.Facade.FRONT, HousePlan.STOREY_M)
	var x: float = _plan.width - 1.5
	var white: int = SurfaceTints.Tint.WHITE
	frame.bar(Rect2(x, 0.35, 0.8, 0.55), 0.06, 0.4, METAL, white)
	frame.bar(Rect2(x + 0.08, 0.43, 0.45, 0.39), 0.4, 0.42, IRON, SurfaceTints.Tint.IRON)
	for side: float in [x + 0.1, x + 0.64]:
		frame.bar(Rect2(side, 0.25, 0.05, 0.1), 0.0, 0.4, IRON, SurfaceTints.Tint.IRON)


## A water tank on legs.
func _add_tank() -> void:
	var at: Vector3 = Vector3(
		_dice.randf_range(1.2, maxf(_plan.width * 0.45, 1.3)),
		_top,
		-_plan.depth * _dice.randf_range(0.5, 0.8)
	)
	for x: float in [-0.4, 0.4]:
		for z: float in [-0.4, 0.4]:
			var leg: Vector3 = at + Vector3(x, 0.0, z)
			_mesh.box(
				leg - Vector3(0.04, 0.0, 0.04),
				leg + Vector3(0.04, 0.55, 0.04),
				IRON,
				SurfaceTints.Tint.IRON
			)
	var tints: Array[int] = [
		SurfaceTints.Tint.WHITE, SurfaceTints.Tint.BLUE, SurfaceTints.Tint.COPPER
	]
	var tint: int = tints[_dice.randi_range(0, 2)]
	_mesh.rod(at + Vector3.UP * 0.55, at + Vector3.UP * 1.7, 0.6, 0.6, METAL, tint, 18)
	_mesh.rod(at + Vector3.UP * 1.7, at + Vector3.UP * 1.85, 0.6, 0.15, METAL, tint, 18)
	_mesh.solid(at - Vector3(0.5, 0.0, 0.5), at + Vector3(0.5, 1.75, 0.5))


func _add_aerial() -> void:
	var iron: int = SurfaceTints.Tint.IRON
	var at: Vector3 = Vector3(
		_dice.randf_range(0.6, maxf(_plan.width - 2.2, 0.7)), _top, -_dice.randf_range(0.6, 1.6)
	)
	_mesh.rod(at, at + Vector3.UP * 2.6, 0.025, 0.02, IRON, iron, 6)
	for number: int in 5:
		var y: float = 1.9 + 0.16 * number
		var reach: float = 0.45 - 0.05 * number
		_mesh.rod(
			at + Vector3(-reach, y, 0.0), at + Vector3(reach, y, 0.0), 0.008, 0.008, IRON, iron, 4
		)


## A rug over the parapet.
func _add_rug() -> void:
	var frame: WallFrame = _frame(HousePlan.Facade.FRONT, _top)
	var x: float = _plan.width * _dice.randf_range(0.2, 0.6)
	frame.bar(
		Rect2(x, -0.5, 1.1, _plan.parapet + 0.6),
		0.055,
		0.075,
		SurfaceLayers.Layer.CARPET,
		SurfaceTints.Tint.PLAIN
	)


func _frame(p_wall: HousePlan.Facade, p_height: float) -> WallFrame:
	return WallFrame.new(_mesh, _plan.corner_of(p_wall, p_height), HousePlan.along(p_wall))

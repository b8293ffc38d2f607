class_name HouseOpenings
extends RefCounted
## What fills the openings of a [House]: windows, doors, shops and balconies.

const WOOD: SurfaceLayers.Layer = SurfaceLayers.Layer.PAINTED_WOOD
const STONE: SurfaceLayers.Layer = SurfaceLayers.Layer.CONCRETE
const IRON: SurfaceLayers.Layer = SurfaceLayers.Layer.STEEL
const CLOTH: SurfaceLayers.Layer = SurfaceLayers.Layer.FABRIC

var _mesh: BlockMesh
var _plan: HousePlan


func _init(p_mesh: BlockMesh, p_plan: HousePlan) -> void:
	_mesh = p_mesh
	_plan = p_plan


## Fills an opening of a wall.
func fill(p_from: Vector3, p_right: Vector3, p_opening: HousePlan.Opening, p_storey: int) -> void:
	var frame: WallFrame = WallFrame.new(_mesh, p_from, p_right)
	match p_opening.kind:
		HousePlan.Kind.WINDOW:
			_add_window(frame, p_opening, p_storey)
		HousePlan.Kind.DOOR, HousePlan.Kind.ARCH:
			_add_door(frame, p_opening)
		HousePlan.Kind.SHOP:
			_add_shop(frame, p_opening)
		HousePlan.Kind.BALCONY:
			_add_door(frame, p_opening)
			_add_balcony(frame, p_opening.rect)


func _add_window(p_frame: WallFrame, p_opening: HousePlan.Opening, p_storey: int) -> void:
	var rect: Rect2 = p_opening.rect
	var at: Vector2 = rect.position
	p_frame.border(rect, 0.07, -0.24, -0.15, true, _plan.paint)
	p_frame.bar(
		Rect2(at.x - 0.08, at.y - 0.09, rect.size.x + 0.16, 0.09), -0.1, 0.09, STONE, _plan.trim
	)
	if p_opening.chance > 0.6:
		p_frame.bar(
			Rect2(at.x - 0.12, rect.end.y + 0.02, rect.size.x + 0.24, 0.14),
			-0.05,
			0.05,
			SurfaceLayers.Layer.WOOD,
			SurfaceTints.Tint.PLAIN
		)
	var is_open: bool = _plan.is_entered
	if not is_open:
		_add_pane(p_frame, rect)
	if p_opening.chance < 0.45:
		_add_shutters(p_frame, rect)
	elif p_opening.chance < 0.6 and not is_open:
		p_frame.bar(rect.grow(-0.07), -0.21, -0.17, WOOD, _plan.paint)
	elif p_storey == 0 or (p_opening.chance < 0.8 and not is_open):
		_add_bars(p_frame, rect)
	else:
		var middle: float = rect.get_center().x
		p_frame.bar(Rect2(middle - 0.03, at.y, 0.06, rect.size.y), -0.22, -0.17, WOOD, _plan.paint)


## Dark glass, where nobody looks in.
func _add_pane(p_frame: WallFrame, p_rect: Rect2) -> void:
	_mesh.face(
		p_frame.point(p_rect.position.x, p_rect.position.y, -0.2),
		p_frame.right,
		Vector3.UP,
		p_rect.size,
		SurfaceLayers.Layer.GLASS,
		SurfaceTints.Tint.PLAIN
	)


func _add_shutters(p_frame: WallFrame, p_rect: Rect2) -> void:
	var wide: float = p_rect.size.x / 2.0
	for x: float in [p_rect.position.x - wide, p_rect.end.x]:
		p_frame.bar(Rect2(x, p_rect.position.y, wide, p_rect.size.y), 0.0, 0.045, WOOD, _plan.paint)
		for share: float in [0.16, 0.74]:
			var y: float = p_rect.position.y + p_rect.size.y * share
			p_frame.bar(Rect2(x + 0.03, y, wide - 0.06, 0.09), 0.045, 0.07, WOOD, _plan.paint)


func _add_bars(p_frame: WallFrame, p_rect: Rect2) -> void:
	const COUNT: int = 6
	for number: int in COUNT:
		var x: float = lerpf(p_rect.position.x, p_rect.end.x, (number + 0.5) / COUNT)
		_mesh.rod(
			p_frame.point(x, p_rect.position.y, -0.1),
			p_frame.point(x, p_rect.end.y, -0.1),
			0.011,
			0.011,
			IRON,
			SurfaceTints.Tint.IRON,
			4,
			false
		)
	for share: float in [0.25, 0.75]:
		var y: float = lerpf(p_rect.position.y, p_rect.end.y, share)
		p_frame.bar(
			Rect2(p_rect.position.x, y - 0.012, p_rect.size.x, 0.024),
			-0.115,
			-0.085,
			IRON,
			SurfaceTints.Tint.IRON
		)
	_add_guard(p_frame, p_rect)


## What keeps things from flying through bars.
func _add_guard(p_frame: WallFrame, p_rect: Rect2) -> void:
	var low: Vector3 = p_frame.point(p_rect.position.x, p_rect.position.y, -0.13)
	var high: Vector3 = p_frame.point(p_rect.end.x, p_rect.end.y, -0.07)
	_mesh.solid(low, high)


func _add_door(p_frame: WallFrame, p_opening: HousePlan.Opening) -> void:
	var rect: Rect2 = p_opening.rect
	var at: Vector2 = rect.position
	if p_opening.kind == HousePlan.Kind.ARCH:
		_add_arch(p_frame, rect)
	else:
		p_frame.border(rect, 0.06, -0.27, -0.1, false, _plan.paint)
		p_frame.bar(
			Rect2(at.x - 0.14, rect.end.y, rect.size.x + 0.28, 0.2), -0.04, 0.06, STONE, _plan.trim
		)
	if not _plan.is_entered:
		# Without a gap: behind it is nothing but the sides of walls that are not seen.
		var side: float = 0.0 if p_opening.kind == HousePlan.Kind.ARCH else 0.06
		var size: Vector2 = rect.size - Vector2(2.0 * side, side)
		p_frame.leaf(Vector3(at.x + side, at.y, -0.2), size, 0.0, WOOD, _plan.paint)


## Blocks of stone around an opening, and a keystone.
func _add_arch(p_frame: WallFrame, p_rect: Rect2) -> void:
	const BLOCKS: int = 6
	for side: float in [p_rect.position.x - 0.22, p_rect.end.x]:
		for number: int in BLOCKS:
			var high: float = p_rect.size.y / BLOCKS
			var wide: float = 0.22 if number % 2 == 0 else 0.17
			var x: float = side if side > p_rect.position.x else p_rect.position.x - wide
			var rect: Rect2 = Rect2(x, p_rect.position.y + high * number, wide, high - 0.015)
			p_frame.bar(rect, -0.02, 0.05, STONE, _plan.trim)
	var lintel: Rect2 = Rect2(p_rect.position.x - 0.3, p_rect.end.y, p_rect.size.x + 0.6, 0.28)
	p_frame.bar(lintel, -0.02, 0.06, STONE, _plan.trim)
	var middle: float = p_rect.get_center().x
	p_frame.bar(Rect2(middle - 0.13, p_rect.end.y - 0.04, 0.26, 0.4), -0.02, 0.1, STONE, _plan.trim)


func _add_balcony(p_frame: WallFrame, p_rect: Rect2) -> void:
	const DEEP: float = 1.0
	const HIGH: float = 1.0
	var x0: float = p_rect.position.x - 0.5
	var x1: float = p_rect.end.x + 0.5
	var y: float = p_rect.position.y
	p_frame.bar(Rect2(x0, y - 0.18, x1 - x0, 0.18), -0.1, DEEP, STONE, _plan.trim, _plan.is_entered)
	for x: float in [x0 + 0.25, x1 - 0.37]:
		p_frame.bar(Rect2(x, y - 0.36, 0.12, 0.18), -0.05, 0.6, STONE, _plan.trim)
	var iron: int = SurfaceTints.Tint.IRON
	var top: float = y + HIGH
	p_frame.bar(Rect2(x0, top, x1 - x0, 0.045), DEEP - 0.06, DEEP, IRON, iron)
	var count: int = int((x1 - x0) / 0.13)
	for number: int in count + 1:
		var x: float = lerpf(x0 + 0.01, x1 - 0.01, float(number) / count)
		_mesh.rod(
			p_frame.point(x, y, DEEP - 0.03),
			p_frame.point(x, top, DEEP - 0.03),
			0.009,
			0.009,
			IRON,
			iron,
			4,
			false
		)
	for x: float in [x0, x1 - 0.03]:
		p_frame.bar(Rect2(x, top, 0.03, 0.045), 0.0, DEEP - 0.06, IRON, iron)
		for number: int in 7:
			var z: float = 0.1 + 0.12 * number
			_mesh.rod(
				p_frame.point(x + 0.015, y, z),
				p_frame.point(x + 0.015, top, z),
				0.009,
				0.009,
				IRON,
				iron,
				4,
				false
			)
		_mesh.solid(p_frame.point(x, y, 0.0), p_frame.point(x + 0.03, top, DEEP))
	_mesh.solid(p_frame.point(x0, y, DEEP - 0.06), p_frame.point(x1, top, DEEP))


func _add_shop(p_frame: WallFrame, p_opening: HousePlan.Opening) -> void:
	var rect: Rect2 = p_opening.rect
	var at: Vector2 = rect.position
	p_frame.border(rect, 0.1, -0.3, -0.2, false, SurfaceTints.Tint.TAN)
	var shut: float = 0.45 + 0.4 * p_opening.chance
	if not _plan.is_entered:
		shut = rect.size.y - 0.1
	# Its shutter is rolled down a little.
	p_frame.bar(
		Rect2(at.x + 0.1, rect.end.y - 0.1 - shut, rect.size.x - 0.2, shut),
		-0.25,
		-0.21,
		SurfaceLayers.Layer.CORRUGATED,
		_plan.paint
	)
	_add_awning(p_frame, rect)
	if _plan.is_entered:
		var counter: Rect2 = Rect2(at.x + 0.12, at.y, rect.size.x * 0.55, 0.85)
		p_frame.bar(counter, -0.75, -0.28, SurfaceLayers.Layer.WOOD, SurfaceTints.Tint.PLAIN, true)


## Cloth on two rods, which sags a little.
func _add_awning(p_frame: WallFrame, p_rect: Rect2) -> void:
	const STRIPS: int = 4
	const REACH: float = 1.7
	const DROP: float = 0.62
	var x0: float = p_rect.position.x - 0.35
	var x1: float = p_rect.end.x + 0.35
	var y: float = minf(p_rect.end.y + 0.35, HousePlan.STOREY_M - 0.05)
	var edge: Array[Vector2] = []
	for number: int in STRIPS + 1:
		var t: float = float(number) / STRIPS
		edge.append(Vector2(0.02 + REACH * t, y - DROP * t - 0.16 * sin(PI * t)))
	for number: int in STRIPS:
		var near: Vector2 = edge[number]
		var far: Vector2 = edge[number + 1]
		var corners: Array[Vector3] = [
			p_frame.point(x0, near.y, near.x),
			p_frame.point(x1, near.y, near.x),
			p_frame.point(x1, far.y, far.x),
			p_frame.point(x0, far.y, far.x)
		]
		_mesh.quad(corners[0], corners[1], corners[2], corners[3], CLOTH, _plan.cloth)
		_mesh.quad(corners[3], corners[2], corners[1], corners[0], CLOTH, _plan.cloth)
	var low: Vector2 = edge[STRIPS]
	for back: bool in [false, true]:
		var left: float = x1 if back else x0
		var right: float = x0 if back else x1
		_mesh.quad(
			p_frame.point(left, low.y, low.x),
			p_frame.point(right, low.y, low.x),
			p_frame.point(right, low.y - 0.22, low.x),
			p_frame.point(left, low.y - 0.22, low.x),
			CLOTH,
			_plan.cloth
		)
	for x: float in [x0 + 0.05, x1 - 0.05]:
		_mesh.rod(
			p_frame.point(x, low.y, low.x),
			p_frame.point(x, y - 1.0, 0.0),
			0.018,
			0.018,
			IRON,
			SurfaceTints.Tint.IRON,
			5,
			false
		)

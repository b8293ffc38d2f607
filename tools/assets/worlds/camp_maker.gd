class_name CampMaker
extends SolidMaker
## Ruins and what armies leave: camps, barriers, poles. Each is built around its place, on the
## ground, facing -Z.

const BURNT: int = SurfaceLayers.Layer.BURNT
const METAL: int = SurfaceLayers.Layer.METAL
const WOOD: int = SurfaceLayers.Layer.WOOD
const BRICK: int = SurfaceLayers.Layer.BRICK
const PLASTER: int = SurfaceLayers.Layer.PLASTER
const CONCRETE: int = SurfaceLayers.Layer.CONCRETE
const BURLAP: int = SurfaceLayers.Layer.BURLAP
const SHEET: int = SurfaceLayers.Layer.CORRUGATED
const BOARDS: int = SurfaceLayers.Layer.PAINTED_WOOD


## A house of which some walls stand.
func ruin() -> void:
	var size: Vector2 = Vector2(_dice.randf_range(7.0, 9.5), _dice.randf_range(5.5, 7.5))
	var corners: PackedVector2Array = [
		Vector2(-size.x, -size.y) / 2.0,
		Vector2(size.x, -size.y) / 2.0,
		size / 2.0,
		Vector2(-size.x, size.y) / 2.0
	]
	for wall: int in 4:
		var from: Vector2 = corners[wall]
		var to: Vector2 = corners[(wall + 1) % 4]
		_broken_wall(from, to, _dice.randf_range(1.2, 3.4), _dice.randf_range(0.2, 3.2), wall != 2)
	_broken_wall(Vector2(-0.6, -size.y / 2.0), Vector2(-0.6, size.y * 0.2), 2.4, 0.3, false)
	_mesh.set_dust(0.75, 0.0)
	_box(Vector3(0.0, 0.0, 0.0), Vector3(size.x, 0.14, size.y), CONCRETE, Tint.SAND)
	_mesh.set_dust(0.35, 0.0)
	for _stone: int in 46:
		var place: Vector3 = Vector3(
			_dice.randfn() * size.x * 0.42, 0.06, _dice.randfn() * size.y * 0.42
		)
		_rubble(place, _dice.randf_range(0.10, 0.42))
	for _beam: int in 4:
		var place: Vector3 = Vector3(_dice.randfn() * 2.0, 0.15, _dice.randfn() * 1.6)
		var way: Vector3 = Vector3(_dice.randfn(), absf(_dice.randfn()) * 0.35, _dice.randfn())
		_mesh.rod(place, place + way.normalized() * 2.6, 0.09, 0.08, WOOD, Tint.DARK, 6)


## A wall of sandbags along a line of places, so many rows high.
func sandbags(p_line: PackedVector2Array, p_rows: int) -> void:
	for part: int in p_line.size() - 1:
		var from: Vector2 = p_line[part]
		var to: Vector2 = p_line[part + 1]
		var way: Vector2 = (to - from).normalized()
		var count: int = maxi(roundi(from.distance_to(to) / 0.52), 1)
		for row: int in p_rows:
			for bag: int in count - row % 2:
				var spot: Vector2 = from + way * (0.52 * (bag + 0.5 + 0.5 * (row % 2)))
				var turn: float = -way.angle() + _dice.randf_range(-0.10, 0.10)
				_bag(Vector3(spot.x, 0.09 + 0.165 * row, spot.y), turn)
		var middle: Vector2 = (from + to) / 2.0
		var place: Transform3D = _mesh.get_place()
		var turned: Transform3D = Transform3D(
			Basis(Vector3.UP, -way.angle()), Vector3(middle.x, 0.0, middle.y)
		)
		_mesh.set_place(place * turned)
		_solid(
			Vector3(0.0, 0.0825 * p_rows, 0.0), Vector3(from.distance_to(to), 0.165 * p_rows, 0.32)
		)
		_mesh.set_place(place)


## A barrier of concrete as roads are closed with, 2.4 m long.
func road_barrier() -> void:
	var outline: PackedVector2Array = [
		Vector2(0.32, 0.0), Vector2(0.32, 0.1), Vector2(0.14, 0.36), Vector2(0.09, 0.86)
	]
	for part: int in outline.size() - 1:
		var low: Vector2 = outline[part]
		var high: Vector2 = outline[part + 1]
		for side: float in [-1.0, 1.0]:
			_mesh.quad(
				Vector3(-1.2 * side, low.y, low.x * side),
				Vector3(-1.2 * side, high.y, high.x * side),
				Vector3(1.2 * side, high.y, high.x * side),
				Vector3(1.2 * side, low.y, low.x * side),
				CONCRETE,
				Tint.PLAIN
			)
			_mesh.quad(
				Vector3(1.2 * side, low.y, low.x * side),
				Vector3(1.2 * side, high.y, high.x * side),
				Vector3(1.2 * side, high.y, -high.x * side),
				Vector3(1.2 * side, low.y, -low.x * side),
				CONCRETE,
				Tint.PLAIN
			)
	_mesh.quad(
		Vector3(-1.2, 0.86, 0.09),
		Vector3(-1.2, 0.86, -0.09),
		Vector3(1.2, 0.86, -0.09),
		Vector3(1.2, 0.86, 0.09),
		CONCRETE,
		Tint.PLAIN
	)
	_solid(Vector3(0.0, 0.43, 0.0), Vector3(2.4, 0.86, 0.4))


## Three crossed beams that stop tanks.
func hedgehog() -> void:
	for way: Vector3 in [
		Vector3(1.0, 0.75, 0.2), Vector3(-0.7, 0.75, 0.75), Vector3(-0.3, 0.75, -0.95)
	]:
		var arm: Vector3 = way.normalized() * 0.95
		_mesh.rod(
			Vector3.UP * 0.55 - arm, Vector3.UP * 0.55 + arm, 0.085, 0.085, BURNT, Tint.PLAIN, 4
		)
	_solid(Vector3.UP * 0.55, Vector3(0.7, 1.1, 0.7))


## A drum for oil.
func drum(p_tint: int) -> void:
	_mesh.rod(Vector3.ZERO, Vector3.UP * 0.88, 0.29, 0.29, METAL, p_tint, 16)
	for ring: float in [0.02, 0.30, 0.58, 0.86]:
		_mesh.rod(Vector3.UP * ring, Vector3.UP * (ring + 0.03), 0.302, 0.302, METAL, p_tint, 16)
	_solid(Vector3.UP * 0.44, Vector3(0.52, 0.88, 0.52))


## A guard's hut of corrugated sheet, open to -Z.
func hut() -> void:
	for side: float in [-1.0, 1.0]:
		_box(Vector3(side * 1.1, 1.1, 0.0), Vector3(0.05, 2.2, 2.2), SHEET, Tint.DRAB)
		_box(Vector3(side * 1.1, 1.15, -1.1), Vector3(0.1, 2.3, 0.1), WOOD, Tint.DARK)
		_box(Vector3(side * 1.1, 1.15, 1.1), Vector3(0.1, 2.3, 0.1), WOOD, Tint.DARK)
	_box(Vector3(0.0, 1.1, 1.1), Vector3(2.2, 2.2, 0.05), SHEET, Tint.DRAB)
	_box(Vector3(-0.75, 0.55, -1.1), Vector3(0.7, 1.1, 0.05), SHEET, Tint.DRAB)
	_box(Vector3(-0.7, 1.05, -0.85), Vector3(0.75, 0.05, 0.45), WOOD, Tint.PLAIN)
	_box(Vector3(0.0, 2.33, -0.15), Vector3(2.7, 0.06, 3.0), SHEET, Tint.PLAIN)
	_box(Vector3(0.0, 0.04, 0.0), Vector3(2.2, 0.08, 2.2), CONCRETE, Tint.PLAIN)


## A beam across a road, lifted to an angle, rad, of red and white boards.
func barrier_beam(p_length: float, p_angle: float) -> void:
	_box(Vector3(0.0, 0.5, 0.0), Vector3(0.3, 1.0, 0.3), CONCRETE, Tint.PLAIN)
	var pivot: Vector3 = Vector3(0.0, 1.0, 0.25)
	var way: Vector3 = Vector3(cos(p_angle), sin(p_angle), 0.0)
	var parts: int = roundi(p_length / 0.6)
	for part: int in parts:
		var tint: int = Tint.RED if part % 2 == 0 else Tint.WHITE
		_mesh.rod(
			pivot + way * 0.6 * part, pivot + way * 0.6 * (part + 1), 0.05, 0.05, BOARDS, tint, 6
		)
	_box(pivot - way * 0.5 + Vector3.DOWN * 0.1, Vector3(0.35, 0.35, 0.3), CONCRETE, Tint.GREY)


## A telegraph pole of 7 m with its cross beam along X. Returns where the wires hang.
func pole() -> PackedVector3Array:
	_mesh.rod(
		Vector3.DOWN * 0.6, Vector3.UP * 7.2, 0.13, 0.10, SurfaceLayers.Layer.DIRT, Tint.DARK, 8
	)
	_box(Vector3(0.0, 6.75, 0.0), Vector3(1.8, 0.11, 0.10), WOOD, Tint.DARK)
	var ends: PackedVector3Array = []
	for place: float in [-0.8, -0.35, 0.35, 0.8]:
		var foot: Vector3 = Vector3(place, 6.8, 0.0)
		_mesh.rod(foot, foot + Vector3.UP * 0.17, 0.035, 0.045, SurfaceLayers.Layer.GLASS, 0, 6)
		ends.append(foot + Vector3.UP * 0.15)
	_solid(Vector3.UP * 3.4, Vector3(0.24, 7.2, 0.24))
	return ends


## A tent for an army's camp, 5 x 4 m, its flaps open at both ends.
func tent() -> void:
	var cloth: int = BURLAP
	var eave: float = 1.35
	var ridge: float = 2.5
	for side: float in [-1.0, 1.0]:
		_mesh.quad(
			Vector3(2.0 * side, eave, 2.5 * side),
			Vector3(0.0, ridge, 2.5 * side),
			Vector3(0.0, ridge, -2.5 * side),
			Vector3(2.0 * side, eave, -2.5 * side),
			cloth,
			Tint.OLIVE
		)
		_mesh.quad(
			Vector3(0.0, ridge, 2.5 * side),
			Vector3(2.0 * side, eave, 2.5 * side),
			Vector3(2.0 * side, eave, -2.5 * side),
			Vector3(0.0, ridge, -2.5 * side),
			cloth,
			Tint.DARK
		)
		_box(Vector3(side * 2.0, eave / 2.0, 0.0), Vector3(0.02, eave, 5.0), cloth, Tint.OLIVE)
		_mesh.rod(
			Vector3(0.0, 0.0, side * 2.4), Vector3(0.0, 2.6, side * 2.4), 0.04, 0.04, WOOD, 0, 6
		)
		for along: float in [-2.4, 0.0, 2.4]:
			var foot: Vector3 = Vector3(side * 3.4, 0.0, along)
			_mesh.rod(Vector3(side * 2.0, eave, along), foot, 0.012, 0.012, BURLAP, 0, 4, false)
	_solid(Vector3(-2.0, 0.7, 0.0), Vector3(0.1, 1.4, 5.0))
	_solid(Vector3(2.0, 0.7, 0.0), Vector3(0.1, 1.4, 5.0))


## A crate of boards.
func crate(p_size: Vector3, p_tint: int) -> void:
	_box(Vector3.UP * p_size.y / 2.0, p_size, WOOD, p_tint)
	for side: float in [-1.0, 1.0]:
		_box(
			Vector3(side * p_size.x * 0.36, p_size.y / 2.0, 0.0),
			Vector3(0.09, p_size.y + 0.03, p_size.z + 0.03),
			WOOD,
			Tint.DARK
		)
	_solid(Vector3.UP * p_size.y / 2.0, p_size)


## A wall between two places that falls in steps from one height to another.
func _broken_wall(
	p_from: Vector2, p_to: Vector2, p_high: float, p_low: float, p_has_window: bool
) -> void:
	var place: Transform3D = _mesh.get_place()
	var way: Vector2 = p_to - p_from
	var length: float = way.length()
	_mesh.set_place(
		place * Transform3D(Basis(Vector3.UP, -way.angle()), Vector3(p_from.x, 0.0, p_from.y))
	)
	var x: float = 0.0
	var window: float = length * _dice.randf_range(0.3, 0.55)
	while x < length - 0.05:
		var wide: float = minf(_dice.randf_range(0.16, 0.5), length - x)
		var part: float = (x + wide / 2.0) / length
		var height: float = lerpf(p_high, p_low, smoothstep(0.1, 0.9, part))
		height = maxf(height + _dice.randf_range(-0.22, 0.22), 0.25)
		var middle: float = x + wide / 2.0
		var is_open: bool = p_has_window and absf(middle - window) < 0.65 and height > 1.0
		if is_open:
			_wall_part(x, wide, 0.0, 0.9)
			if height > 2.3:
				_wall_part(x, wide, 2.05, height)
		else:
			_wall_part(x, wide, 0.0, height)
		x += wide
	_mesh.set_place(place)


func _wall_part(p_x: float, p_wide: float, p_low: float, p_high: float) -> void:
	var from: Vector3 = Vector3(p_x, p_low, -0.17)
	var to: Vector3 = Vector3(p_x + p_wide, p_high, 0.17)
	# Plaster has come off the upper courses.
	var bare: float = maxf(p_high - _dice.randf_range(0.1, 0.9), p_low)
	if bare > p_low + 0.05:
		_mesh.box(from, Vector3(to.x, bare, 0.17), PLASTER, Tint.PALE_ROCK)
	if p_high > bare + 0.02:
		_mesh.box(Vector3(from.x, bare, -0.14), Vector3(to.x, p_high, 0.14), BRICK, Tint.PLAIN)
	_mesh.solid(from, to)


func _rubble(p_place: Vector3, p_size: float) -> void:
	var place: Transform3D = _mesh.get_place()
	var axis: Vector3 = Vector3(_dice.randfn(), 1.0, _dice.randfn()).normalized()
	_mesh.set_place(place * Transform3D(Basis(axis, _dice.randf() * TAU), p_place))
	var layer: int = BRICK if _dice.randf() < 0.6 else PLASTER
	_box(Vector3.ZERO, Vector3(p_size, p_size * 0.5, p_size * 0.7), layer, Tint.PLAIN)
	_mesh.set_place(place)


## A filled bag of 0.5 m: a ball pressed flat.
func _bag(p_place: Vector3, p_turn: float) -> void:
	var points: PackedVector3Array = []
	var normals: PackedVector3Array = []
	var places: PackedVector2Array = []
	var index: PackedInt32Array = []
	var columns: int = 8
	var rows: int = 4
	var basis: Basis = Basis(Vector3.UP, p_turn)
	for row: int in rows + 1:
		var tilt: float = PI * row / rows
		for column: int in columns + 1:
			var turn: float = TAU * column / columns
			var way: Vector3 = Vector3(sin(tilt) * cos(turn), -cos(tilt), sin(tilt) * sin(turn))
			var shape: Vector3 = Vector3(
				_fat(way.x) * 0.275, _fat(way.y) * 0.095, _fat(way.z) * 0.155
			)
			points.append(p_place + basis * shape)
			normals.append((basis * Vector3(way.x, way.y * 1.8, way.z)).normalized())
			places.append(Vector2(shape.x + shape.y, shape.z + shape.y))
			if row < rows and column < columns:
				var first: int = row * (columns + 1) + column
				var above: int = first + columns + 1
				index.append_array([first, first + 1, above, first + 1, above + 1, above])
	_mesh.surface(points, normals, places, index, BURLAP, Tint.PLAIN)


## Nearer to 1: a ball that is more of a box.
static func _fat(p_value: float) -> float:
	return signf(p_value) * pow(absf(p_value), 0.7)

class_name HallRoof
extends RefCounted
## The gable roof of a hall, its frames of steel and the gables: the ridge runs along X over the
## middle, the floor's middle is the origin.

const THICK: float = 0.14
const EAVES_OUT: float = 0.45
const _SHEET: SurfaceLayers.Layer = SurfaceLayers.Layer.CORRUGATED
const _PURLINS: int = 7
const _PANELS: int = 12

## Length, height of the eaves and depth of the hall, m.
var size: Vector3 = Vector3(40.0, 7.2, 24.0)
## How much higher the ridge is than the eaves, m.
var rise: float = 2.0
## Number of fields between frames.
var bays: int = 8
## Whether every second field lets light in.
var has_skylights: bool = true
## Colours of the gables' sheet outside and inside, of the roof, and of the steel.
var outside: int = SurfaceTints.Tint.SAGE
var inside: int = SurfaceTints.Tint.WHITE
var roof: int = SurfaceTints.Tint.GREY_STONE
var steel: int = SurfaceTints.Tint.NAVY
## Where no column may stand: from and to along X, m, towards +Z and towards -Z.
var free_south: PackedVector2Array = []
var free_north: PackedVector2Array = []

var _mesh: BlockMesh


## Adds the roof, the frames and the gables.
func build(p_mesh: BlockMesh) -> void:
	_mesh = p_mesh
	var base: Transform3D = p_mesh.get_place()
	for side: int in 2:
		p_mesh.set_place(base * Transform3D(Basis(Vector3.UP, PI * side), Vector3.ZERO))
		_add_slope()
		_add_gable()
	p_mesh.set_place(base)
	for frame: int in bays + 1:
		var x: float = lerpf(-size.x / 2.0 + 0.3, size.x / 2.0 - 0.3, float(frame) / bays)
		_add_frame(x)
	p_mesh.set_finest(1.25)
	var ridge: float = size.y + rise + THICK
	p_mesh.box(
		Vector3(-size.x / 2.0 - 0.3, ridge - 0.04, -0.3),
		Vector3(size.x / 2.0 + 0.3, ridge + 0.06, 0.3),
		Steelwork.PAINT,
		roof
	)


## Holes for light in a slope, from its eaves' left corner: x, up the slope, width, length, m.
func skylights() -> Array[Rect2]:
	var found: Array[Rect2] = []
	if not has_skylights:
		return found
	var wide: float = size.x / bays
	var length: float = _slope_length()
	for bay: int in bays:
		if bay % 2 == 1 or bays < 2:
			var x: float = 0.3 + wide * bay + wide * 0.2
			found.append(Rect2(x, length * 0.36, wide * 0.6, length * 0.44))
	return found


func _slope_length() -> float:
	return _slope_up().x


## Length of a slope with its eaves, and the angle.
func _slope_up() -> Vector2:
	var angle: float = atan2(rise, size.z / 2.0)
	return Vector2((size.z / 2.0 + EAVES_OUT) / cos(angle), angle)


## The slope towards +Z.
func _add_slope() -> void:
	var slope: Vector2 = _slope_up()
	var up: Vector3 = Vector3(0.0, sin(slope.y), -cos(slope.y))
	var out: Vector3 = Vector3.RIGHT.cross(up)
	var drop: float = EAVES_OUT * tan(slope.y)
	var long: float = size.x + 0.6
	var corner: Vector3 = Vector3(-long / 2.0, size.y - drop, size.z / 2.0 + EAVES_OUT)
	var extent: Vector2 = Vector2(long, slope.x)
	var holes: PackedVector4Array = []
	var back: PackedVector4Array = []
	for light: Rect2 in skylights():
		holes.append(Vector4(light.position.x, light.position.y, light.size.x, light.size.y))
		var mirrored: float = long - light.end.x
		back.append(Vector4(mirrored, light.position.y, light.size.x, light.size.y))
		_add_skylight(corner, up, out, light)
	_mesh.face(corner + out * THICK, Vector3.RIGHT, up, extent, _SHEET, roof, holes)
	var far: Vector3 = corner + Vector3.RIGHT * long
	_mesh.face(far, Vector3.LEFT, up, extent, _SHEET, inside, back)
	var rim: Vector2 = Vector2(long, THICK)
	_mesh.face(corner, Vector3.RIGHT, out, rim, Steelwork.PAINT, roof)
	Steelwork.beam(
		_mesh, corner + out * 0.02, far + out * 0.02, Vector2(0.16, 0.14), Steelwork.PAINT, steel
	)
	var base: Transform3D = _mesh.get_place()
	_mesh.set_place(base * Transform3D(Basis(Vector3.RIGHT, up, out), corner))
	_mesh.solid(Vector3.ZERO, Vector3(long, slope.x, THICK))
	for side: float in [0.0, long - 0.08]:
		_mesh.box(
			Vector3(side, 0.0, -0.02),
			Vector3(side + 0.08, slope.x, THICK + 0.03),
			Steelwork.PAINT,
			roof
		)
	_mesh.set_finest(2.5)
	for purlin: int in _PURLINS:
		var y: float = lerpf(EAVES_OUT + 0.3, slope.x - 0.25, float(purlin) / (_PURLINS - 1))
		_mesh.box(
			Vector3(0.3, y - 0.04, -0.17),
			Vector3(long - 0.3, y + 0.04, 0.0),
			Steelwork.PAINT,
			steel
		)
	_mesh.set_finest(1.25)
	_mesh.set_place(base)


## The sides of a hole and the bars over it.
func _add_skylight(p_corner: Vector3, p_up: Vector3, p_out: Vector3, p_light: Rect2) -> void:
	var base: Transform3D = _mesh.get_place()
	var from: Vector3 = p_corner + Vector3.RIGHT * p_light.position.x + p_up * p_light.position.y
	_mesh.set_place(base * Transform3D(Basis(Vector3.RIGHT, p_up, p_out), from))
	var white: int = SurfaceTints.Tint.WHITE
	var size_of: Vector2 = p_light.size
	for x: float in [-0.06, size_of.x]:
		_mesh.box(
			Vector3(x, -0.06, -0.02),
			Vector3(x + 0.06, size_of.y + 0.06, THICK + 0.12),
			Steelwork.PAINT,
			white
		)
	for y: float in [-0.06, size_of.y]:
		_mesh.box(
			Vector3(0.0, y, -0.02),
			Vector3(size_of.x, y + 0.06, THICK + 0.12),
			Steelwork.PAINT,
			white
		)
	for bar: int in range(1, 3):
		var x: float = size_of.x * bar / 3.0
		_mesh.box(
			Vector3(x - 0.025, 0.0, 0.06),
			Vector3(x + 0.025, size_of.y, 0.12),
			Steelwork.PAINT,
			white
		)
	for bar: int in range(1, 5):
		var y: float = size_of.y * bar / 5.0
		_mesh.box(
			Vector3(0.0, y - 0.02, 0.07), Vector3(size_of.x, y + 0.02, 0.11), Steelwork.PAINT, white
		)
	_mesh.set_place(base)


## The triangle over the wall towards +X, in strips whose waves stand upright.
func _add_gable() -> void:
	var half: float = size.z / 2.0
	var strips: int = maxi(2, ceili(size.z / 1.5 / 2.0) * 2)
	for strip: int in strips:
		var z0: float = lerpf(half, -half, float(strip) / strips)
		var z1: float = lerpf(half, -half, float(strip + 1) / strips)
		var y0: float = size.y + rise * (1.0 - absf(z0) / half)
		var y1: float = size.y + rise * (1.0 - absf(z1) / half)
		for back: bool in [false, true]:
			var x: float = size.x / 2.0 - (HallWall.THICK if back else 0.0)
			var left: Vector3 = Vector3(x, size.y, z1 if back else z0)
			var right: Vector3 = Vector3(x, size.y, z0 if back else z1)
			var left_top: Vector3 = Vector3(x, y1 if back else y0, left.z)
			var right_top: Vector3 = Vector3(x, y0 if back else y1, right.z)
			var tint: int = inside if back else outside
			_mesh.quad(right, left, left_top, right_top, _SHEET, tint)
		_mesh.solid(
			Vector3(size.x / 2.0 - HallWall.THICK, size.y, minf(z0, z1)),
			Vector3(size.x / 2.0, maxf(y0, y1), maxf(z0, z1))
		)


## Two columns and a truss.
func _add_frame(p_x: float) -> void:
	var half: float = size.z / 2.0 - HallWall.THICK - 0.16
	var low: float = size.y - 0.55
	for side: float in [-half, half]:
		if _is_free(p_x, free_south if side > 0.0 else free_north):
			continue
		var foot: Vector3 = Vector3(p_x, 0.0, side)
		Steelwork.profile(
			_mesh, foot, Vector3(p_x, size.y - 0.1, side), Vector2(0.22, 0.3), steel, true
		)
		_mesh.box(
			foot - Vector3(0.2, 0.0, 0.22),
			foot + Vector3(0.2, 0.03, 0.22),
			Steelwork.PAINT,
			SurfaceTints.Tint.IRON
		)
	_mesh.set_finest(2.5)
	var pale: int = Steelwork.PAINT
	var left: Vector3 = Vector3(p_x, low, -half)
	var right: Vector3 = Vector3(p_x, low, half)
	Steelwork.beam(_mesh, left, right, Vector2(0.14, 0.12), pale, steel)
	for side: float in [-half, half]:
		var eaves: Vector3 = Vector3(p_x, _chord(side), side)
		Steelwork.beam(
			_mesh, eaves, Vector3(p_x, _chord(0.0), 0.0), Vector2(0.14, 0.14), pale, steel
		)
	for panel: int in _PANELS:
		var z0: float = lerpf(-half, half, float(panel) / _PANELS)
		var z1: float = lerpf(-half, half, float(panel + 1) / _PANELS)
		var is_rising: bool = panel < _PANELS / 2
		var foot: Vector3 = Vector3(p_x, low, z0 if is_rising else z1)
		var other: float = z1 if is_rising else z0
		Steelwork.beam(
			_mesh, foot, Vector3(p_x, _chord(other), other), Vector2(0.07, 0.07), pale, steel
		)
		if panel > 0:
			Steelwork.beam(
				_mesh,
				Vector3(p_x, low, z0),
				Vector3(p_x, _chord(z0), z0),
				Vector2(0.06, 0.06),
				pale,
				steel
			)
	_mesh.set_finest(1.25)


## Height of a truss's upper chord at a depth, under the purlins.
func _chord(p_z: float) -> float:
	return size.y + rise * (1.0 - absf(p_z) / (size.z / 2.0)) - 0.27


func _is_free(p_x: float, p_ranges: PackedVector2Array) -> bool:
	for range_m: Vector2 in p_ranges:
		if p_x > range_m.x - 0.2 and p_x < range_m.y + 0.2:
			return true
	return false

@tool
class_name HeightField
extends RefCounted
## Heights of a terrain, what its ground is made of, and how much of the sky each point sees.
##
## Points lie on a grid, [member columns] along x and [member rows] along z, around the middle. The
## surface between four points is two triangles with the diagonal from the greatest x and least z to
## the least x and greatest z, as the physics engine has it.

## What can be painted on the ground, besides the sand below it. Numbers are those of the file.
enum Paint {
	## Stones close together.
	GRAVEL,
	## Bare rock.
	ROCK,
	## A road.
	ROAD,
	## Cracked clay of a wadi's bed.
	CLAY,
}

## Number of [enum Paint].
const PAINTS: int = 4
## Fewest and most points along an edge.
const MIN_SIDE: int = 2
const MAX_SIDE: int = 4097
## Least and greatest distance of points, m.
const MIN_CELL_M: float = 0.1
const MAX_CELL_M: float = 16.0
## Greatest height above or depth below 0, m.
const MAX_HEIGHT_M: float = 1000.0
## From this slope on (the cosine) sand does not lie and bare earth shows.
const BARE_SLOPE: float = 0.80
## Key of each paint for sound and dust; of bare sand it is [constant SAND].
const KEYS: Array[StringName] = [&"gravel", &"stone", &"asphalt", &"dirt"]
const SAND: StringName = &"sand"
## Key of bare earth on banks.
const EARTH: StringName = &"dirt"

## Points along x and along z.
var columns: int = MIN_SIDE
var rows: int = MIN_SIDE
## Distance of neighbouring points, m.
var cell_m: float = 1.0
## Height of each point, m, row after row.
var heights: PackedFloat32Array = []
## Four bytes for each point: how much of each [enum Paint] lies there.
var paint: PackedByteArray = []
## A byte for each point: the share of the sky that it sees.
var light: PackedByteArray = []


## A flat field.
static func create(p_columns: int, p_rows: int, p_cell_m: float) -> HeightField:
	var field: HeightField = HeightField.new()
	field.columns = clampi(p_columns, MIN_SIDE, MAX_SIDE)
	field.rows = clampi(p_rows, MIN_SIDE, MAX_SIDE)
	field.cell_m = clampf(p_cell_m, MIN_CELL_M, MAX_CELL_M)
	field.heights.resize(field.points())
	field.paint.resize(field.points() * PAINTS)
	field.light.resize(field.points())
	field.light.fill(255)
	return field


## Number of points.
func points() -> int:
	return columns * rows


## Length and width, m.
func size() -> Vector2:
	return Vector2(columns - 1, rows - 1) * cell_m


## Lowest and highest point, m. Takes a while: a million points are 80 ms.
func range_of_heights() -> Vector2:
	var least: float = INF
	var most: float = -INF
	for height: float in heights:
		least = minf(least, height)
		most = maxf(most, height)
	return Vector2(least, most)


## Height of the ground at a point, counted from the middle, m; beyond the edge the height of the
## edge.
func height_at(p_x: float, p_z: float) -> float:
	var place: Vector2 = _place_of(p_x, p_z)
	var column: int = mini(int(place.x), columns - 2)
	var row: int = mini(int(place.y), rows - 2)
	var across: float = place.x - column
	var down: float = place.y - row
	var first: int = row * columns + column
	var right: float = heights[first + 1]
	var below: float = heights[first + columns]
	if across + down <= 1.0:
		var near: float = heights[first]
		return near + (right - near) * across + (below - near) * down
	var far: float = heights[first + columns + 1]
	return far + (below - far) * (1.0 - across) + (right - far) * (1.0 - down)


## Normal of the ground at a point.
func normal_at(p_x: float, p_z: float) -> Vector3:
	var step: float = cell_m
	var across: float = height_at(p_x - step, p_z) - height_at(p_x + step, p_z)
	var down: float = height_at(p_x, p_z - step) - height_at(p_x, p_z + step)
	return Vector3(across, 2.0 * step, down).normalized()


## Number of the point that is nearest to a position.
func index_at(p_x: float, p_z: float) -> int:
	var place: Vector2 = _place_of(p_x, p_z)
	return roundi(place.y) * columns + roundi(place.x)


## How much of a paint lies at a position, 0 to 1.
func paint_at(p_x: float, p_z: float, p_paint: Paint) -> float:
	return paint[index_at(p_x, p_z) * PAINTS + p_paint] / 255.0


## Key of what the ground is made of at a position, for sound and dust.
func surface_at(p_x: float, p_z: float) -> StringName:
	var best: StringName = SAND
	var most: float = 0.5
	for index: int in PAINTS:
		var amount: float = paint_at(p_x, p_z, index as Paint)
		if amount >= most:
			most = amount
			best = KEYS[index]
	var is_firm: bool = best == KEYS[Paint.ROAD] or best == KEYS[Paint.ROCK]
	if not is_firm and normal_at(p_x, p_z).y < BARE_SLOPE:
		return EARTH
	return best


## A copy of the same size.
func duplicate() -> HeightField:
	var copy: HeightField = HeightField.new()
	copy.columns = columns
	copy.rows = rows
	copy.cell_m = cell_m
	copy.heights = heights.duplicate()
	copy.paint = paint.duplicate()
	copy.light = light.duplicate()
	return copy


## Column and row of a position, as numbers between the points, within the field.
func _place_of(p_x: float, p_z: float) -> Vector2:
	var place: Vector2 = Vector2(p_x, p_z) / cell_m + Vector2(columns - 1, rows - 1) / 2.0
	return place.clamp(Vector2.ZERO, Vector2(columns - 1, rows - 1))

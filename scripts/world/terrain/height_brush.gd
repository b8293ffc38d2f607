@tool
class_name HeightBrush
extends RefCounted
## Changes a [HeightField] around a position: raises, lowers, smooths, flattens, paints. Each change
## can be taken back: [HeightPatch] keeps what was there.

## What a brush does.
enum Kind {
	## Raises the ground by the strength, m.
	RAISE,
	## Lowers it by the strength, m.
	LOWER,
	## Brings each point nearer to the mean of its neighbours; strength 0 to 1.
	SMOOTH,
	## Brings each point nearer to the height in the middle; strength 0 to 1.
	FLATTEN,
	## Adds paint; strength 0 to 1.
	PAINT,
	## Takes all paint away; strength 0 to 1.
	CLEAN,
}

## What it does.
var kind: Kind = Kind.RAISE
## Radius, m.
var radius_m: float = 4.0
## How much in one stroke: see [enum Kind].
var strength: float = 0.1
## What [constant PAINT] adds.
var paint: HeightField.Paint = HeightField.Paint.GRAVEL


## Applies the brush at a position from the middle of a field, m. Returns what was there before, or
## null if the position is beyond the field.
func stroke(p_field: HeightField, p_x: float, p_z: float) -> HeightPatch:
	var middle: Vector2 = Vector2(p_x, p_z) / p_field.cell_m
	middle += Vector2(p_field.columns - 1, p_field.rows - 1) / 2.0
	var reach: float = radius_m / p_field.cell_m
	var from: Vector2i = Vector2i((middle - Vector2.ONE * reach).ceil())
	var to: Vector2i = Vector2i((middle + Vector2.ONE * reach).floor()) + Vector2i.ONE
	var whole: Rect2i = Rect2i(0, 0, p_field.columns, p_field.rows)
	var area: Rect2i = Rect2i(from, to - from).intersection(whole)
	if area.size.x <= 0 or area.size.y <= 0:
		return null
	var before: HeightPatch = HeightPatch.take(p_field, area)
	var goal: float = p_field.height_at(p_x, p_z)
	for row: int in range(area.position.y, area.end.y):
		for column: int in range(area.position.x, area.end.x):
			var away: float = Vector2(column, row).distance_to(middle) / reach
			var part: float = 1.0 - smoothstep(0.0, 1.0, away)
			if part > 0.0:
				_change(p_field, before, Vector2i(column, row), part, goal)
	return before


func _change(
	p_field: HeightField, p_before: HeightPatch, p_point: Vector2i, p_part: float, p_goal: float
) -> void:
	var index: int = p_point.y * p_field.columns + p_point.x
	var height: float = p_field.heights[index]
	match kind:
		Kind.RAISE:
			height += strength * p_part
		Kind.LOWER:
			height -= strength * p_part
		Kind.SMOOTH:
			height = lerpf(
				height, _mean(p_field, p_before, p_point), clampf(strength * p_part, 0.0, 1.0)
			)
		Kind.FLATTEN:
			height = lerpf(height, p_goal, clampf(strength * p_part, 0.0, 1.0))
		_:
			_change_paint(p_field, index, clampf(strength * p_part, 0.0, 1.0))
	var most: float = HeightField.MAX_HEIGHT_M
	p_field.heights[index] = clampf(height, -most, most)


func _change_paint(p_field: HeightField, p_index: int, p_part: float) -> void:
	for each: int in HeightField.PAINTS:
		var goal: float = 255.0 if kind == Kind.PAINT and each == paint else 0.0
		var at: int = p_index * HeightField.PAINTS + each
		p_field.paint[at] = roundi(lerpf(p_field.paint[at], goal, p_part))


## Mean height around a point as it was before the stroke.
func _mean(p_field: HeightField, p_before: HeightPatch, p_point: Vector2i) -> float:
	var sum: float = 0.0
	for offset: Vector2i in [Vector2i.LEFT, Vector2i.RIGHT, Vector2i.UP, Vector2i.DOWN]:
		var last: Vector2i = Vector2i(p_field.columns, p_field.rows) - Vector2i.ONE
		var point: Vector2i = (p_point + offset).clamp(Vector2i.ZERO, last)
		if p_before.area.has_point(point):
			sum += p_before.height_of(point)
		else:
			sum += p_field.heights[point.y * p_field.columns + point.x]
	return sum / 4.0

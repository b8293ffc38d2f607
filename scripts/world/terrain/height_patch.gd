@tool
class_name HeightPatch
extends RefCounted
## A rectangle of a [HeightField] as it was at a moment, to put it back.

## The points, by column and row.
var area: Rect2i = Rect2i()

var _heights: PackedFloat32Array = []
var _paint: PackedByteArray = []


## Copies the points of a rectangle, which must lie within the field.
static func take(p_field: HeightField, p_area: Rect2i) -> HeightPatch:
	var patch: HeightPatch = HeightPatch.new()
	patch.area = p_area
	for row: int in range(p_area.position.y, p_area.end.y):
		var from: int = row * p_field.columns + p_area.position.x
		var to: int = from + p_area.size.x
		patch._heights.append_array(p_field.heights.slice(from, to))
		var bytes: int = HeightField.PAINTS
		patch._paint.append_array(p_field.paint.slice(from * bytes, to * bytes))
	return patch


## Puts the points back. Returns a patch with what was there, to do it again.
func put_back(p_field: HeightField) -> HeightPatch:
	var other: HeightPatch = HeightPatch.take(p_field, area)
	for row: int in area.size.y:
		var to: int = (area.position.y + row) * p_field.columns + area.position.x
		for column: int in area.size.x:
			var from: int = row * area.size.x + column
			p_field.heights[to + column] = _heights[from]
			for each: int in HeightField.PAINTS:
				p_field.paint[(to + column) * HeightField.PAINTS + each] = (_paint[
					from * HeightField.PAINTS + each
				])
	return other


## The height that a point of the area had, m.
func height_of(p_point: Vector2i) -> float:
	var place: Vector2i = p_point - area.position
	return _heights[place.y * area.size.x + place.x]

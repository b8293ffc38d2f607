extends TestCase
## Brushes: what they change, where, and that it can be taken back.

var _field: HeightField = null
var _brush: HeightBrush = null


func before_each() -> void:
	_field = HeightField.create(41, 31, 0.5)
	_brush = HeightBrush.new()
	_brush.radius_m = 3.0


func test_raise_and_lower() -> void:
	_brush.strength = 0.5
	_brush.stroke(_field, 1.0, 2.0)
	almost_equal(_field.height_at(1.0, 2.0), 0.5, 1e-6)
	equal(_field.height_at(4.5, 2.0), 0.0)
	_brush.kind = HeightBrush.Kind.LOWER
	_brush.stroke(_field, 1.0, 2.0)
	almost_equal(_field.height_at(1.0, 2.0), 0.0, 1e-6)


func test_smooth_takes_roughness() -> void:
	for index: int in _field.points():
		_field.heights[index] = float(index % 2)
	_brush.kind = HeightBrush.Kind.SMOOTH
	_brush.strength = 1.0
	var before: float = _roughness()
	for _time: int in 4:
		_brush.stroke(_field, 0.0, 0.0)
	is_true(_roughness() < 0.6 * before, "%f of %f" % [_roughness(), before])


func test_flatten_levels_to_the_middle() -> void:
	for index: int in _field.points():
		_field.heights[index] = 0.1 * (index % _field.columns)
	_brush.kind = HeightBrush.Kind.FLATTEN
	_brush.strength = 1.0
	var goal: float = _field.height_at(0.0, 0.0)
	for _time: int in 30:
		_brush.stroke(_field, 0.0, 0.0)
	almost_equal(_field.height_at(1.0, 0.5), goal, 0.02)


func test_paint_and_clean() -> void:
	_brush.kind = HeightBrush.Kind.PAINT
	_brush.paint = HeightField.Paint.ROAD
	_brush.strength = 1.0
	_brush.stroke(_field, 0.0, 0.0)
	equal(_field.paint_at(0.0, 0.0, HeightField.Paint.ROAD), 1.0)
	equal(_field.surface_at(0.0, 0.0), &"asphalt")
	equal(_field.surface_at(5.0, 0.0), &"sand")
	_brush.kind = HeightBrush.Kind.CLEAN
	_brush.stroke(_field, 0.0, 0.0)
	equal(_field.surface_at(0.0, 0.0), &"sand")


func test_a_stroke_can_be_taken_back_and_done_again() -> void:
	var before: PackedFloat32Array = _field.heights.duplicate()
	_brush.stroke(_field, -9.5, -7.0)
	_brush.kind = HeightBrush.Kind.PAINT
	var patch: HeightPatch = _brush.stroke(_field, -9.5, -7.0)
	var painted: PackedByteArray = _field.paint.duplicate()
	var again: HeightPatch = patch.put_back(_field)
	equal(_field.paint.count(0), _field.paint.size())
	again.put_back(_field)
	equal(_field.paint, painted)
	_brush.kind = HeightBrush.Kind.LOWER
	_brush.stroke(_field, -9.5, -7.0).put_back(_field)
	not_equal(_field.heights, before)


func test_beyond_the_edge_nothing_happens() -> void:
	is_null(_brush.stroke(_field, 50.0, 0.0))
	not_null(_brush.stroke(_field, 10.5, 0.0))


func _roughness() -> float:
	var sum: float = 0.0
	for index: int in range(1, 10):
		sum += absf(_field.height_at(index * 0.1, 0.0) - _field.height_at(index * 0.1 + 0.5, 0.0))
	return sum

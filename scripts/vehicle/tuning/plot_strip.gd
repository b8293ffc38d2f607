class_name PlotStrip
extends Control
## A few curves over the last seconds, in one box with one scale, and their newest values.

## Values that are kept of a curve: 10 s at 60 a second.
const LENGTH: int = 600
## Colours of Okabe and Ito, which colour-blind people can distinguish.
const COLOURS: Array[Color] = [
	Color(0.34, 0.71, 0.91),
	Color(0.9, 0.62, 0.0),
	Color(0.0, 0.62, 0.45),
	Color(0.94, 0.89, 0.36),
	Color(0.8, 0.47, 0.65),
]

const _BACK: Color = Color(0.09, 0.1, 0.12, 0.85)
const _PALE: Color = Color(0.72, 0.75, 0.78)
const _FONT_SIZE: int = 12
const _MARGIN: float = 4.0
const _TITLE_WIDTH: float = 116.0
const _VALUE_WIDTH: float = 64.0

## What is shown, with its unit.
var title: String = ""
## The ends of the scale at least; it grows with what comes.
var scale_from: float = 0.0
## The upper end of the scale at least.
var scale_to: float = 1.0

var _curves: Array[PackedFloat32Array] = []
var _names: PackedStringArray = PackedStringArray()


## A strip with so many curves as it has names.
static func create(
	p_title: String, p_names: PackedStringArray, p_from: float, p_to: float
) -> PlotStrip:
	var strip: PlotStrip = PlotStrip.new()
	strip.title = p_title
	strip.scale_from = p_from
	strip.scale_to = p_to
	strip._names = p_names
	for _name: String in p_names:
		strip._curves.append(PackedFloat32Array())
	strip.custom_minimum_size = Vector2(470.0, 62.0)
	strip.mouse_filter = Control.MOUSE_FILTER_IGNORE
	return strip


## Adds the newest values, one for each curve; what is not finite counts as 0.
func push(p_values: PackedFloat32Array) -> void:
	for index: int in mini(_curves.size(), p_values.size()):
		var curve: PackedFloat32Array = _curves[index]
		curve.append(p_values[index] if is_finite(p_values[index]) else 0.0)
		if curve.size() > LENGTH:
			curve.remove_at(0)
		_curves[index] = curve
		scale_from = minf(scale_from, curve[-1])
		scale_to = maxf(scale_to, curve[-1])
	queue_redraw()


## The newest value of a curve; 0 where there is none.
func newest(p_curve: int) -> float:
	return 0.0 if _curves[p_curve].is_empty() else _curves[p_curve][-1]


## How many values there are of a curve.
func count() -> int:
	return 0 if _curves.is_empty() else _curves[0].size()


func _draw() -> void:
	var font: Font = ThemeDB.fallback_font
	draw_rect(Rect2(Vector2.ZERO, size), _BACK)
	var at: Vector2 = Vector2(_MARGIN, _FONT_SIZE + 2.0)
	draw_string(font, at, title, HORIZONTAL_ALIGNMENT_LEFT, -1.0, _FONT_SIZE, _PALE)
	var box: Rect2 = Rect2(
		_TITLE_WIDTH, _MARGIN, size.x - _TITLE_WIDTH - _VALUE_WIDTH, size.y - 2.0 * _MARGIN
	)
	var zero: float = _height_of(0.0, box)
	draw_line(Vector2(box.position.x, zero), Vector2(box.end.x, zero), Color(_PALE, 0.3))
	for index: int in _curves.size():
		var colour: Color = COLOURS[index % COLOURS.size()]
		var row: float = at.y + (index + 1) * (_FONT_SIZE + 1.0)
		if _curves.size() <= 3:
			var label: Vector2 = Vector2(_MARGIN, row)
			draw_string(
				font, label, _names[index], HORIZONTAL_ALIGNMENT_LEFT, -1.0, _FONT_SIZE, colour
			)
		var value: Vector2 = Vector2(box.end.x + _MARGIN, at.y + index * (_FONT_SIZE + 1.0))
		if row < size.y + _FONT_SIZE:
			draw_string(
				font,
				value,
				String.num(newest(index), 2),
				HORIZONTAL_ALIGNMENT_LEFT,
				-1.0,
				_FONT_SIZE,
				colour
			)
		_draw_curve(_curves[index], box, colour)


func _draw_curve(p_curve: PackedFloat32Array, p_box: Rect2, p_colour: Color) -> void:
	if p_curve.size() < 2:
		return
	var points: PackedVector2Array = PackedVector2Array()
	for index: int in p_curve.size():
		var x: float = p_box.end.x - p_box.size.x * (p_curve.size() - 1 - index) / float(LENGTH)
		points.append(Vector2(x, _height_of(p_curve[index], p_box)))
	draw_polyline(points, p_colour, 1.0)


func _height_of(p_value: float, p_box: Rect2) -> float:
	var share: float = (p_value - scale_from) / maxf(scale_to - scale_from, 1e-6)
	return p_box.end.y - clampf(share, 0.0, 1.0) * p_box.size.y

class_name LimbPlot
extends Control
## One limb's tracking error, joint torque and saturation over the last seconds: three curves, each
## with its own scale, and the newest values.

## What is shown, from left to right.
enum Trace { ERROR, TORQUE, SATURATION }

## Seconds that a curve is long.
const SPAN_S: float = 5.0
## Values that are kept of a curve.
const LENGTH: int = 150
## Width of the limb's name, px.
const NAME_WIDTH: float = 88.0
## Width of the newest value, px.
const VALUE_WIDTH: float = 44.0
## Colours of Okabe and Ito, which colour-blind people can distinguish.
const COLOURS: Array[Color] = [
	Color(0.34, 0.71, 0.91), Color(0.9, 0.62, 0.0), Color(0.94, 0.89, 0.36)
]
## Saturation above the limit: darker than the rest, too, not only another hue.
const OVER: Color = Color(1.0, 0.3, 0.22)
## Minimum end of a scale: degrees, N m, percent.
const MIN_TOPS: Array[float] = [5.0, 10.0, 120.0]

const _BACK: Color = Color(0.09, 0.1, 0.12, 0.85)
const _PALE: Color = Color(0.72, 0.75, 0.78)
const _FONT_SIZE: int = 13
const _SMALL_SIZE: int = 10
const _GAP: float = 4.0

## The label before the curves.
var title: String = ""

## Ring buffers, one behind the other; the oldest value is at [member _next].
var _values: Array[PackedFloat32Array] = []
var _next: int = 0
var _count: int = 0


func _init() -> void:
	custom_minimum_size = Vector2(380.0, 30.0)
	size_flags_vertical = Control.SIZE_EXPAND_FILL
	mouse_filter = Control.MOUSE_FILTER_IGNORE
	for curve: int in Trace.size():
		var ring: PackedFloat32Array = []
		ring.resize(LENGTH)
		_values.append(ring)


## Adds the newest values: degrees, N m, percent. [method CanvasItem.queue_redraw] shows them.
func push(p_error_deg: float, p_torque_nm: float, p_saturation_percent: float) -> void:
	var newest: Array[float] = [p_error_deg, p_torque_nm, p_saturation_percent]
	for curve: int in Trace.size():
		_values[curve][_next] = newest[curve] if is_finite(newest[curve]) else 0.0
	_next = (_next + 1) % LENGTH
	_count = mini(_count + 1, LENGTH)


## Forgets all values.
func clear() -> void:
	_next = 0
	_count = 0
	queue_redraw()


## How many values there are of each curve, at most [constant LENGTH].
func count() -> int:
	return _count


## A value that was pushed, 0 being the newest one's age; 0 where there is none.
func value(p_curve: Trace, p_age: int = 0) -> float:
	if p_age < 0 or p_age >= _count:
		return 0.0
	return _values[p_curve][posmod(_next - 1 - p_age, LENGTH)]


## Where a curve's box begins and how wide it is, px, in a row so wide.
static func box(p_curve: Trace, p_width: float) -> Vector2:
	var column: float = (p_width - NAME_WIDTH) / Trace.size()
	return Vector2(NAME_WIDTH + column * p_curve, column - VALUE_WIDTH - _GAP)


## A round number above a value: the end of its scale.
static func round_top(p_value: float) -> float:
	var decade: float = pow(10.0, floorf(log(maxf(p_value, 1e-3)) / log(10.0)))
	for step: float in [1.0, 1.5, 2.0, 3.0, 5.0, 7.5]:
		if p_value <= step * decade:
			return step * decade
	return 10.0 * decade


func _draw() -> void:
	var font: Font = get_theme_default_font()
	var base: float = size.y / 2.0 + _FONT_SIZE * 0.36
	draw_string(font, Vector2(2.0, base), title, HORIZONTAL_ALIGNMENT_LEFT, NAME_WIDTH, _FONT_SIZE)
	for curve: int in Trace.size():
		_draw_curve(curve as Trace, font, base)


func _draw_curve(p_curve: Trace, p_font: Font, p_base: float) -> void:
	var across: Vector2 = box(p_curve, size.x)
	var frame: Rect2 = Rect2(across.x, 1.0, across.y, size.y - 2.0)
	draw_rect(frame, _BACK)
	var top: float = MIN_TOPS[p_curve]
	for age: int in _count:
		top = maxf(top, value(p_curve, age))
	if top > MIN_TOPS[p_curve]:
		top = round_top(top)
	var newest: float = value(p_curve)
	var colour: Color = COLOURS[p_curve]
	if p_curve == Trace.SATURATION:
		_draw_limit(frame, top)
	if _count > 1:
		_draw_line_of(p_curve, frame, top)
	_draw_top(frame, top, p_font)
	var text: String = "%.1f" % newest if p_curve != Trace.SATURATION else "%.0f" % newest
	if p_curve == Trace.SATURATION and newest > 100.0:
		colour = OVER
		text += "!"
	var corner: Vector2 = Vector2(frame.end.x + 2.0, p_base)
	draw_string(
		p_font, corner, text, HORIZONTAL_ALIGNMENT_RIGHT, VALUE_WIDTH - 4.0, _FONT_SIZE, colour
	)


## The value of the upper edge, on its own background so that curves do not cross it.
func _draw_top(p_frame: Rect2, p_top: float, p_font: Font) -> void:
	var text: String = "%d" % roundi(p_top)
	var left: int = HORIZONTAL_ALIGNMENT_LEFT
	var extent: Vector2 = p_font.get_string_size(text, left, -1, _SMALL_SIZE)
	draw_rect(Rect2(p_frame.position, Vector2(extent.x + 4.0, _SMALL_SIZE + 2.0)), _BACK)
	var corner: Vector2 = p_frame.position + Vector2(2.0, _SMALL_SIZE)
	draw_string(p_font, corner, text, left, -1, _SMALL_SIZE, _PALE)


## The joint's limit.
func _draw_limit(p_frame: Rect2, p_top: float) -> void:
	var height: float = p_frame.end.y - p_frame.size.y * 100.0 / p_top
	var from: Vector2 = Vector2(p_frame.position.x, height)
	draw_dashed_line(from, Vector2(p_frame.end.x, height), Color(_PALE, 0.6), 1.0, 4.0)


func _draw_line_of(p_curve: Trace, p_frame: Rect2, p_top: float) -> void:
	var points: PackedVector2Array = []
	points.resize(_count)
	var over: PackedVector2Array = []
	var step: float = p_frame.size.x / (LENGTH - 1)
	for age: int in _count:
		var newest: float = value(p_curve, age)
		var share: float = clampf(newest / p_top, 0.0, 1.0)
		points[age] = Vector2(p_frame.end.x - age * step, p_frame.end.y - share * p_frame.size.y)
		if p_curve == Trace.SATURATION and newest > 100.0 and age > 0:
			over.append_array([points[age - 1], points[age]])
	draw_polyline(points, COLOURS[p_curve], 1.5)
	if not over.is_empty():
		draw_multiline(over, OVER, 2.5)

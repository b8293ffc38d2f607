class_name LatencyChart
extends RefCounted
## Draws delays: a histogram of the total, and a bar of the stages' means.

## The thesis's mean and standard deviation, ms (section 7.4.3).
const THESIS_MS: float = 50.7
const THESIS_SD_MS: float = 13.7
## Colours of the stages, which colour-blind people can distinguish (Okabe and Ito 2008).
const COLOURS: Array[Color] = [
	Color("56b4e9"),
	Color("0072b2"),
	Color("e69f00"),
	Color("d55e00"),
	Color("009e73"),
	Color("cc79a7"),
]
const _LINE: Color = Color(1.0, 1.0, 1.0, 0.5)
const _BAR: Color = Color("56b4e9")
const _THESIS: Color = Color("f0e442")
const _STEPS: int = 60

## What is drawn.
var probe: LatencyProbe = null
## Size of the letters, px.
var font_size: int = 12

var _canvas: CanvasItem = null
var _font: Font = ThemeDB.fallback_font


## Draws on a canvas, from within its [method CanvasItem._draw].
func _init(p_canvas: CanvasItem) -> void:
	_canvas = p_canvas


## The histogram of the total within an area. The axis ends behind the thesis's mean, or where it
## must.
func draw_histogram(p_area: Rect2) -> void:
	var most_ms: float = maxf(70.0, ceilf(probe.total.percentile(0.99) / 10.0) * 10.0 + 10.0)
	var bins: PackedInt32Array = probe.total.coarse(0.0, most_ms, _STEPS)
	var highest: int = 1
	for count: int in bins:
		highest = maxi(highest, count)
	var width: float = p_area.size.x / _STEPS
	var band: Rect2 = p_area
	band.position.x += (THESIS_MS - THESIS_SD_MS) / most_ms * p_area.size.x
	band.size.x *= 2.0 * THESIS_SD_MS / most_ms
	_canvas.draw_rect(band, Color(_THESIS, 0.08))
	for step: int in _STEPS:
		var height: float = p_area.size.y * bins[step] / highest
		var corner: Vector2 = Vector2(p_area.position.x + step * width, p_area.end.y - height)
		_canvas.draw_rect(Rect2(corner, Vector2(maxf(width - 1.0, 1.0), height)), _BAR)
	_canvas.draw_line(Vector2(p_area.position.x, p_area.end.y), p_area.end, _LINE)
	var step_ms: float = 10.0 if most_ms <= 150.0 else 50.0
	for tick: int in int(most_ms / step_ms) + 1:
		var x: float = p_area.position.x + tick * step_ms / most_ms * p_area.size.x
		_canvas.draw_line(Vector2(x, p_area.end.y), Vector2(x, p_area.end.y + 4.0), _LINE)
		_text(
			Vector2(x - font_size * 0.5, p_area.end.y + font_size + 4.0), "%.0f" % (tick * step_ms)
		)
	_draw_moment(
		p_area, THESIS_MS / most_ms, "thesis %.1f +- %.1f ms" % [THESIS_MS, THESIS_SD_MS], _THESIS
	)
	if probe.total.count() > 0:
		_draw_moment(
			p_area, probe.total.mean() / most_ms, "mean %.1f" % probe.total.mean(), Color.WHITE
		)


## The means of the stages beside each other, within an area.
func draw_stages(p_area: Rect2) -> void:
	var sum: float = 0.0
	for stage: LatencyHistogram in probe.stages:
		sum += maxf(stage.mean(), 0.0)
	var x: float = p_area.position.x
	for stage: int in probe.stages.size():
		var width: float = p_area.size.x * maxf(probe.stages[stage].mean(), 0.0) / maxf(sum, 0.001)
		_canvas.draw_rect(Rect2(x, p_area.position.y, width, p_area.size.y), COLOURS[stage])
		x += width


## A table of stages and total from a point on, with a line of heads.
func draw_table(p_corner: Vector2) -> void:
	var columns: Array[float] = [0.0, 11.0, 17.0, 23.0, 29.0, 35.0]
	var heads: Array[String] = ["ms", "mean", "sd", "p50", "p95", "p99"]
	var line: float = font_size * 1.5
	for column: int in heads.size():
		_text(p_corner + Vector2(columns[column] * font_size * 0.62, 0.0), heads[column], _LINE)
	for row: int in probe.stages.size() + 1:
		var is_total: bool = row == probe.stages.size()
		var delays: LatencyHistogram = probe.total if is_total else probe.stages[row]
		var corner: Vector2 = p_corner + Vector2(0.0, line * (row + 1))
		if not is_total:
			var swatch: Vector2 = Vector2(font_size * 0.6, font_size * 0.8)
			_canvas.draw_rect(Rect2(corner - Vector2(0.0, swatch.y), swatch), COLOURS[row])
		var name: String = "total" if is_total else String(LatencyMark.STAGES[row])
		_text(corner + Vector2(font_size, 0.0), name)
		var values: Array[float] = [
			delays.mean(),
			delays.deviation(),
			delays.percentile(0.5),
			delays.percentile(0.95),
			delays.percentile(0.99),
		]
		for column: int in values.size():
			var shown: String = "%.1f" % values[column] if delays.count() > 0 else "-"
			_text(corner + Vector2(columns[column + 1] * font_size * 0.62, 0.0), shown)


func _draw_moment(p_area: Rect2, p_part: float, p_text: String, p_colour: Color) -> void:
	var x: float = p_area.position.x + p_part * p_area.size.x
	_canvas.draw_line(Vector2(x, p_area.position.y), Vector2(x, p_area.end.y), p_colour, 1.5)
	var line: float = 1.0 if p_colour == _THESIS else 2.4
	var width: float = _font.get_string_size(p_text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
	# Beside the line, on the side where there is room.
	x += 4.0 if x + width + 4.0 < p_area.end.x else -4.0 - width
	_text(Vector2(x, p_area.position.y + font_size * line), p_text, p_colour)


func _text(p_place: Vector2, p_text: String, p_colour: Color = Color.WHITE) -> void:
	_canvas.draw_string(_font, p_place, p_text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size, p_colour)

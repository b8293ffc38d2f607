class_name LatencyPanel
extends Control
## The delays of the session on the screen: histogram, stages, table. A key opens and closes it.

## Input action that opens and closes it.
const ACTION: StringName = &"toggle_latency"
## Seconds between two drawings: percentiles are not worth more.
const PERIOD_S: float = 0.5

## What is shown; nothing without it.
var probe: LatencyProbe = null:
	set(value):
		probe = value
		queue_redraw()

var _since_s: float = 0.0


func _ready() -> void:
	visible = false
	mouse_filter = Control.MOUSE_FILTER_IGNORE


func _process(p_delta: float) -> void:
	_since_s += p_delta
	if visible and _since_s > PERIOD_S:
		_since_s = 0.0
		queue_redraw()


func _unhandled_key_input(p_event: InputEvent) -> void:
	if p_event.is_action_pressed(ACTION):
		visible = not visible
		queue_redraw()


func _draw() -> void:
	if probe == null:
		return
	draw_rect(Rect2(Vector2.ZERO, size), Color(0.1, 0.12, 0.14, 0.85))
	var chart: LatencyChart = LatencyChart.new(self)
	chart.probe = probe
	var margin: float = 12.0
	var width: float = size.x - 2.0 * margin
	chart.draw_histogram(Rect2(margin, margin, width, size.y * 0.35))
	chart.draw_stages(Rect2(margin, margin + size.y * 0.35 + 26.0, width, 10.0))
	chart.draw_table(Vector2(margin, margin + size.y * 0.35 + 58.0))

class_name JoinCover
extends ClientPart
## What is seen until the world of a session is there for the first time: our own ground with a bar,
## instead of an empty world. What is waited for stands above the bar, as [Hud] shows it; Esc opens
## the menu, from which one can leave.

## Below the layer of [Hud].
const _LAYER: int = -1
## The bar's width as a share of the window's, and its place, as a share of its height.
const _WIDTH: float = 0.4
const _HEIGHT: float = 0.66
const _THICK_PX: float = 6.0

var _layer: CanvasLayer = null
var _bar: ProgressBar = null


func open(p_context: ClientContext) -> String:
	super(p_context)
	_layer = CanvasLayer.new()
	_layer.layer = _LAYER
	_layer.visible = not ClientContext.is_headless() and not context.options.is_on("try")
	add_child(_layer)
	var ground: ColorRect = ColorRect.new()
	ground.color = UiStyle.SCREEN
	ground.set_anchors_preset(Control.PRESET_FULL_RECT)
	ground.mouse_filter = Control.MOUSE_FILTER_IGNORE
	_layer.add_child(ground)
	_bar = ProgressBar.new()
	_bar.show_percentage = false
	_bar.max_value = 1.0
	_bar.step = 0.0
	_bar.mouse_filter = Control.MOUSE_FILTER_IGNORE
	_bar.anchor_left = 0.5 - 0.5 * _WIDTH
	_bar.anchor_right = 0.5 + 0.5 * _WIDTH
	_bar.anchor_top = _HEIGHT
	_bar.anchor_bottom = _HEIGHT
	_bar.offset_bottom = _THICK_PX
	_layer.add_child(_bar)
	return ""


func end_frame(_delta_s: float) -> void:
	if not _layer.visible:
		return
	_bar.value = context.arrived
	# A world that fades in is whole when it is seen.
	_layer.visible = context.arrived < 1.0

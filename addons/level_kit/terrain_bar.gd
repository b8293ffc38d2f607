@tool
extends HFlowContainer
## The part of the dock that chooses a brush; it is there while a [Terrain] is selected.

const TerrainBrush: GDScript = preload("terrain_brush.gd")
## What can be chosen: title, what it does, what it paints.
const KINDS: Array[Array] = [
	["Raise", HeightBrush.Kind.RAISE],
	["Lower", HeightBrush.Kind.LOWER],
	["Smooth", HeightBrush.Kind.SMOOTH],
	["Flatten", HeightBrush.Kind.FLATTEN],
	["Road", HeightBrush.Kind.PAINT, HeightField.Paint.ROAD],
	["Gravel", HeightBrush.Kind.PAINT, HeightField.Paint.GRAVEL],
	["Rock", HeightBrush.Kind.PAINT, HeightField.Paint.ROCK],
	["Clay", HeightBrush.Kind.PAINT, HeightField.Paint.CLAY],
	["Sand", HeightBrush.Kind.CLEAN],
]
## Share of the greatest effect of a moment: heights in m, all else 0 to 1.
const RAISE_M: float = 0.1
const BLEND: float = 0.35

var _brush: RefCounted = null
var _kinds: OptionButton = OptionButton.new()
var _radius: SpinBox = SpinBox.new()
var _new: Button = Button.new()


## Takes over what does the work.
func configure(p_brush: RefCounted) -> void:
	_brush = p_brush


func _ready() -> void:
	add_child(_label("Brush"))
	_kinds.add_item("No brush")
	for row: Array in KINDS:
		_kinds.add_item(row[0])
	_kinds.item_selected.connect(func(_index: int) -> void: _choose())
	_kinds.tooltip_text = "Pull over the ground in the 3D view. Ctrl+Z takes a pull back."
	add_child(_kinds)
	add_child(_label("Radius"))
	_radius.min_value = 0.5
	_radius.max_value = 60.0
	_radius.step = 0.5
	_radius.value = 4.0
	_radius.suffix = "m"
	_radius.tooltip_text = "Radius of the brush"
	_radius.value_changed.connect(func(_value: float) -> void: _choose())
	add_child(_radius)
	_new.text = "Make flat ground"
	_new.pressed.connect(_make_flat)
	add_child(_new)
	EditorInterface.get_selection().selection_changed.connect(_update)
	_update()


func _update() -> void:
	var terrain: Terrain = TerrainBrush.find_selected()
	visible = terrain != null
	var is_new: bool = terrain != null and terrain.field == null
	for control: Control in find_children("*", "Control", false, false):
		control.visible = (control == _new) == is_new
	if terrain == null and _kinds.selected > 0:
		_kinds.select(0)
		_choose()


func _label(p_text: String) -> Label:
	var label: Label = Label.new()
	label.text = p_text
	return label


func _choose() -> void:
	var brush: HeightBrush = null
	if _kinds.selected > 0:
		var row: Array = KINDS[_kinds.selected - 1]
		brush = HeightBrush.new()
		brush.kind = row[1]
		brush.radius_m = _radius.value
		var is_height: bool = brush.kind in [HeightBrush.Kind.RAISE, HeightBrush.Kind.LOWER]
		brush.strength = RAISE_M if is_height else BLEND
		if row.size() > 2:
			brush.paint = row[2]
	_brush.set("brush", brush)


func _make_flat() -> void:
	var fault: String = _brush.call("make_flat", TerrainBrush.find_selected())
	if fault != "":
		EditorInterface.get_editor_toaster().push_toast(fault, EditorToaster.SEVERITY_WARNING)
	_update()

@tool
class_name UiRow
extends HBoxContainer
## A name and a control behind it. The name lights up while the control has the keyboard.

## What most names of a panel need, px: so controls begin at the same place.
const TITLE_PX: float = 130.0

## The name.
var title: Label = Label.new()


## [param p_title_px] is the least width of the name, the same for all rows of a panel.
func _init(p_title: String, p_control: Control, p_title_px: float = TITLE_PX) -> void:
	if p_title != "":
		name = p_title.to_pascal_case()
	title.text = p_title
	title.custom_minimum_size.x = p_title_px
	add_child(title)
	p_control.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	add_child(p_control)
	p_control.focus_entered.connect(
		title.add_theme_color_override.bind(&"font_color", UiStyle.ACCENT)
	)
	p_control.focus_exited.connect(title.remove_theme_color_override.bind(&"font_color"))

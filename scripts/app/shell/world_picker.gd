class_name WorldPicker
extends HFlowContainer
## The worlds that this program has, each as a picture with its name; one of them is chosen.
##
## The picture of a level lies beside its scene: [code]scenes/world/NAME/NAME.jpg[/code].

## Another world has been chosen.
signal chosen(p_world: String)

const _PICTURE_PX: Vector2 = Vector2(200.0, 112.0)

## Name of the chosen world, see [LevelStore].
var world: String = LevelStore.DEFAULT

var _group: ButtonGroup = ButtonGroup.new()


func _init() -> void:
	for name_of_level: String in LevelStore.names():
		add_child(_make(name_of_level))


## Gives the keyboard to the chosen world.
func focus_chosen() -> void:
	(_group.get_pressed_button() as Control).grab_focus()


## Chooses a world, as if the user had done it; nothing where there is none of that name.
func choose(p_world: String) -> void:
	var button: Button = find_child(p_world.to_pascal_case(), false, false) as Button
	if button != null:
		button.button_pressed = true


func _make(p_world: String) -> Button:
	var button: Button = Button.new()
	button.name = p_world.to_pascal_case()
	button.text = p_world.capitalize()
	button.toggle_mode = true
	button.button_group = _group
	button.theme_type_variation = UiStyle.PICTURE
	button.vertical_icon_alignment = VERTICAL_ALIGNMENT_TOP
	button.icon_alignment = HORIZONTAL_ALIGNMENT_CENTER
	button.expand_icon = true
	button.custom_minimum_size = _PICTURE_PX + Vector2(0.0, 2.5 * UiStyle.BODY_PX)
	var path: String = "%s/%s/%s.jpg" % [LevelStore.ROOT, p_world, p_world]
	if ResourceLoader.exists(path):
		button.icon = load(path)
	button.button_pressed = p_world == world
	button.toggled.connect(_on_toggled.bind(p_world))
	return button


func _on_toggled(p_is_on: bool, p_world: String) -> void:
	if p_is_on:
		world = p_world
		chosen.emit(p_world)

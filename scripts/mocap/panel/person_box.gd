class_name PersonBox
extends HFlowContainer
## Who wears the suit: name, known people, height.

## Another known person is chosen as the wearer.
signal person_chosen(p_name: String)
## The name was changed; an empty text is none.
signal name_entered(p_name: String)
## The height was changed, m.
signal height_changed(p_metres: float)
## The body's measures are wanted.
signal body_wanted

@export var _suit: OptionButton
@export var _name: LineEdit
@export var _known: OptionButton
@export var _height: SpinBox
@export var _body: Button


func _ready() -> void:
	_name.text_submitted.connect(func(text: String) -> void: name_entered.emit(text))
	_name.focus_exited.connect(func() -> void: name_entered.emit(_name.text))
	_known.item_selected.connect(_choose)
	_height.value_changed.connect(func(cm: float) -> void: height_changed.emit(cm / 100.0))
	_body.text = InputKeys.label("Body", &"toggle_body_sheet")
	_body.pressed.connect(body_wanted.emit)


## The list of suits: who wears each.
func suits() -> OptionButton:
	return _suit


## Shows a person, and who else is known.
func show_person(p_profile: PersonProfile, p_known: PackedStringArray) -> void:
	if not _name.has_focus():
		_name.text = p_profile.name
	_height.set_value_no_signal(p_profile.size.height * 100.0)
	_known.clear()
	_known.add_item("Known people")
	for name: String in p_known:
		_known.add_item(name)
	_known.selected = p_known.find(p_profile.name) + 1


func _choose(p_at: int) -> void:
	if p_at > 0:
		person_chosen.emit(_known.get_item_text(p_at))

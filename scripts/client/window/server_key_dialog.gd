class_name ServerKeyDialog
extends CanvasLayer
## Asks the user whether a server is still to be trusted that shows another key than the last time.
## Enter and Esc choose to leave, as long as the user does not go to the other button.

## The user does not trust it.
signal leave_wanted
## The user trusts it.
signal trusted(p_other: OtherServerKey)

const _TEXT: String = (
	"The server at %s shows another key than the last time:\n\n"
	+ "then  %s\nnow   %s\n\n"
	+ "It may have been set up anew, or somebody stands between you and it."
	+ " Ask its staff which key it has. Trust the new one?"
)

@export var _panel: Control
@export var _label: Label
@export var _leave: Button
@export var _trust: Button

var _other: OtherServerKey = null


func _ready() -> void:
	_panel.visible = false
	_leave.pressed.connect(_answer.bind(false))
	_trust.pressed.connect(_answer.bind(true))


## Asks about a key.
func ask(p_other: OtherServerKey) -> void:
	_other = p_other
	_label.text = _TEXT % [p_other.address, p_other.known, p_other.fingerprint()]
	_panel.visible = true
	Input.mouse_mode = Input.MOUSE_MODE_VISIBLE
	_leave.grab_focus()


## Whether it asks now.
func is_open() -> bool:
	return _panel.visible


func _input(p_event: InputEvent) -> void:
	if _panel.visible and p_event.is_action_pressed(&"ui_cancel"):
		get_viewport().set_input_as_handled()
		_answer(false)


func _answer(p_is_trusted: bool) -> void:
	_panel.visible = false
	if p_is_trusted:
		trusted.emit(_other)
	else:
		leave_wanted.emit()

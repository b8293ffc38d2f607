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

var _prompt: UiPrompt = UiPrompt.new("Is this the same server?")
var _other: OtherServerKey = null


func _init() -> void:
	_prompt.set_answers(["Leave", "Trust it"])
	_prompt.answered.connect(_answer)
	add_child(_prompt)


## Asks about a key.
func ask(p_other: OtherServerKey) -> void:
	_other = p_other
	Input.mouse_mode = Input.MOUSE_MODE_VISIBLE
	_prompt.ask(_TEXT % [p_other.address, p_other.known, p_other.fingerprint()])


## Whether it asks now.
func is_open() -> bool:
	return _prompt.visible


func _answer(p_answer: int) -> void:
	if p_answer == 1:
		trusted.emit(_other)
	else:
		leave_wanted.emit()

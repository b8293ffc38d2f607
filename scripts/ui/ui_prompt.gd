class_name UiPrompt
extends UiPanel
## A question in the middle of the screen. The first answer is the safe one: it has the keyboard at
## first, and Esc gives it.

## The user has answered: the number of the answer, from 0. The question is closed.
signal answered(answer: int)

var _text: Label = null


func _init(p_title: String = "", p_width_px: float = 592.0) -> void:
	super(p_title, p_width_px)
	_text = add_text()
	_text.name = "Text"
	visible = false


func _input(p_event: InputEvent) -> void:
	if visible and p_event.is_action_pressed(&"ui_cancel"):
		get_viewport().set_input_as_handled()
		_answer(0)


## Sets the answers, the safe one first.
func set_answers(p_texts: PackedStringArray) -> void:
	for at: int in p_texts.size():
		add_answer(p_texts[at], _answer.bind(at))


## Asks.
func ask(p_text: String) -> void:
	_text.text = p_text
	visible = true
	(answers.get_child(0) as Control).grab_focus()


func _answer(p_at: int) -> void:
	visible = false
	answered.emit(p_at)

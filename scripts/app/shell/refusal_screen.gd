class_name RefusalScreen
extends ShellScreen
## Why a session could not begin or go on, and what the user can do about it.

## The user wants to try once more, or elsewhere.
signal retry_wanted(p_choice: SessionChoice)

var _choice: SessionChoice = null


func _init(p_choice: SessionChoice, p_why: String) -> void:
	super("The session has ended")
	_choice = p_choice
	var why: Label = add_text(p_why.left(1).to_upper() + p_why.substr(1))
	why.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	add_answer("Back to the start", closed.emit)
	if Roles.find(_choice.role) >= 0:
		var retry: Button = add_answer("Try again", retry_wanted.emit.bind(_choice))
		retry.theme_type_variation = UiStyle.PRIMARY


func focus_first() -> void:
	var retry: Button = find_child("TryAgain", true, false) as Button
	var back: Button = find_child("BackToTheStart", true, false) as Button
	(retry if retry != null else back).grab_focus()

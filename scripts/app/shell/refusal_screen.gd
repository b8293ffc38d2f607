class_name RefusalScreen
extends ShellScreen
## Why a session could not begin or go on, and what the user can do about it.

var _choice: SessionChoice = null


func _init(p_choice: SessionChoice, p_why: String) -> void:
	super("The session did not begin")
	_choice = p_choice
	add_text(p_why)
	add_answer("Back", closed.emit)


func focus_first() -> void:
	find_child("Back", true, false).call("grab_focus")

class_name Interaction
extends Node
## Lets this machine's user use what the camera looks at: the key of the input action "interact".

## What the key would do now, for the screen; empty for nothing.
signal prompt_changed(p_text: String)

## Input action that uses what is looked at.
const ACTION: StringName = &"interact"

var _prompt: String = ""


func _process(_delta: float) -> void:
	var found: Interactable = find()
	var prompt: String = found.get_prompt() if found != null else ""
	if prompt != _prompt:
		_prompt = prompt
		prompt_changed.emit(prompt)


func _unhandled_input(p_event: InputEvent) -> void:
	if p_event.is_action_pressed(ACTION):
		var found: Interactable = find()
		if found != null:
			found.interact()
			get_viewport().set_input_as_handled()


## What is looked at and can be used, or null. What this session sits in comes first: leaving it
## must not need a look.
func find() -> Interactable:
	for node: Node in get_tree().get_nodes_in_group(Interactable.GROUP):
		var seat: Seat = node as Seat
		if seat != null and seat.entity != null and seat.is_mine():
			return seat
	var camera: Camera3D = get_viewport().get_camera_3d()
	if camera == null:
		return null
	return Interactable.find(get_tree(), camera.global_position, -camera.global_basis.z)

class_name Interaction
extends Node
## Lets this machine's user use what the camera looks at: the key of the input action "interact".

## What the key would do now, for the screen; empty for nothing.
signal prompt_changed(p_text: String)

## Input action that uses what is looked at.
const ACTION: StringName = &"interact"

## Where the user points instead of with the camera: [code]func() -> Transform3D[/code] (-Z ahead),
## if valid, such as the hand that holds a controller.
var aim: Callable = Callable()

var _prompt: String = ""
var _named: String = ""


func _process(_delta: float) -> void:
	if _named != "":
		_use_named()
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


## Uses the [Interactable] at or below a node of a name in the level, once, as soon as it is part of
## the session: for clients without a user. An empty name means none.
func use_by_name(p_name: String) -> void:
	_named = p_name


## What is looked at and can be used, or null. This session's own seat comes first, so
## that one can leave it without looking at it.
func find() -> Interactable:
	for node: Node in get_tree().get_nodes_in_group(Interactable.GROUP):
		var seat: Seat = node as Seat
		if seat != null and seat.entity != null and seat.is_mine():
			return seat
	if aim.is_valid():
		var from: Transform3D = aim.call()
		return Interactable.find(get_tree(), from.origin, -from.basis.z.normalized())
	var camera: Camera3D = get_viewport().get_camera_3d()
	if camera == null:
		return null
	return Interactable.find(get_tree(), camera.global_position, -camera.global_basis.z)


func _use_named() -> void:
	for node: Node in get_tree().get_nodes_in_group(Interactable.GROUP):
		var each: Interactable = node as Interactable
		if each.is_live() and str(each.get_path()).contains(_named):
			_named = ""
			each.interact()
			return

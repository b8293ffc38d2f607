class_name NameTags
extends Node3D
## Names over the heads of those who are near. A key shows and hides them.
##
## Each frame, for each person: [method wants], then [method put] where it says so; then once
## [method choose].

## Input action that shows and hides them.
const ACTION: StringName = &"toggle_names"
## Names at a time: of the people who are nearest.
const MAX_SHOWN: int = 16
## Distance beyond which nobody has a name, m.
const MAX_DISTANCE_M: float = 30.0
## Names fade from this distance on, m.
const _FADES_FROM_M: float = 20.0
## How opaque a name is from near.
const _ALPHA: float = 0.85
## Frames between two choices of who has a name.
const _FRAMES: int = 12
## Height above the head's joint, m.
const _ABOVE_M: float = 0.45
## Share of the window's height that a letter has at any distance.
const _SIZE: float = 0.0006

var _labels: Dictionary[int, Label3D] = {}
## Where the heads are of those who can have a name, in a frame in which that is chosen.
var _heads: Dictionary[int, Vector3] = {}
## Frames until it is chosen again.
var _wait: int = 0


func _unhandled_key_input(p_event: InputEvent) -> void:
	if p_event.is_action_pressed(ACTION):
		visible = not visible
		get_viewport().set_input_as_handled()


## Adds the name of a person, hidden until [method put].
func add(p_person: int, p_name: String) -> void:
	var label: Label3D = Label3D.new()
	label.text = p_name
	label.visible = false
	label.billboard = BaseMaterial3D.BILLBOARD_ENABLED
	label.fixed_size = true
	label.pixel_size = _SIZE
	label.no_depth_test = true
	label.shaded = false
	add_child(label)
	_labels[p_person] = label
	_wait = 0


## Whether it needs to know in this frame where a person's head is.
func wants(p_person: int) -> bool:
	return visible and (_wait == 0 or _labels[p_person].visible)


## Takes where the joint of a person's head is, m.
func put(p_person: int, p_head: Vector3) -> void:
	_labels[p_person].position = p_head + Vector3.UP * _ABOVE_M
	if _wait == 0:
		_heads[p_person] = p_head


## Now and then chooses who has a name: those who are nearest to a camera (m), but not the one out
## of whose eyes it looks (or -1).
func choose(p_camera: Vector3, p_eyes: int) -> void:
	if _labels.has(p_eyes):
		_labels[p_eyes].visible = false
	if not visible:
		_wait = 0
		return
	if _wait > 0:
		_wait -= 1
		return
	var near: Array[Vector2] = []
	for person: int in _heads:
		var distance: float = _heads[person].distance_to(p_camera)
		if person != p_eyes and distance < MAX_DISTANCE_M:
			near.append(Vector2(distance, person))
	# Where nobody has a pose yet it is chosen again at once.
	_wait = 0 if _heads.is_empty() else _FRAMES - 1
	_heads.clear()
	near.sort()
	var alphas: Dictionary[int, float] = {}
	for each: Vector2 in near.slice(0, MAX_SHOWN):
		var faded: float = smoothstep(_FADES_FROM_M, MAX_DISTANCE_M, each.x)
		# In steps: a label whose colour changes is made anew.
		alphas[int(each.y)] = snappedf(_ALPHA * (1.0 - faded), 0.05)
	for person: int in _labels:
		var label: Label3D = _labels[person]
		label.visible = alphas.has(person)
		if label.visible:
			label.modulate.a = alphas[person]
			label.outline_modulate.a = alphas[person]


## Takes a name away.
func remove(p_person: int) -> void:
	if _labels.has(p_person):
		_labels[p_person].free()
		_labels.erase(p_person)
		_heads.erase(p_person)

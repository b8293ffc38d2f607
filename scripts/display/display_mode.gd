class_name DisplayMode
extends Node
## A display: the window's own picture, stereo, several walls, or a headset.
##
## Each frame the client puts its [member camera] where the viewer looks from, and the mode shows
## what that camera sees. A mode that fails says why, and the client goes back to its window, which
## always works.

## A notice for the user.
signal notified(p_text: String)
## The mode cannot go on; [param p_why] says what is wrong and how to mend it.
signal failed(p_why: String)

## Modes come after everything that is shown has been moved, and after the cameras.
const PRIORITY: int = 20

## The camera of the client: where the viewer is and looks, at its time of the frame.
var camera: Camera3D = null


func _init() -> void:
	process_priority = PRIORITY


## Begins to show the world. Returns what is wrong and how to mend it, or an empty text.
func open() -> String:
	return ""


## Leaves the window as it was.
func close() -> void:
	pass


## When what is drawn in this frame will be seen, µs of [method Time.get_ticks_usec]; 0 where the
## mode does not know better than the window's [FrameClock].
func due_usec() -> int:
	return 0


## Stats for a report.
func report() -> Dictionary:
	return {}

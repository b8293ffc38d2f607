class_name TryOut
extends RefCounted
## A user who looks at themselves before the session begins ([code]--try[/code]): nothing is sent
## until they want to join, and until they are let in they can give it up again.
##
## Whoever makes the session listens to [signal join_wanted] and [signal stop_wanted], and says how
## far it is; whatever shows the user calls [method join] and [method stop].

## The user wants to join.
signal join_wanted
## The user does not want to join any more.
signal stop_wanted
## [member phase] or [member text] has changed.
signal changed

## How far it is.
enum Phase {
	## Nothing has been sent.
	LOOKING,
	## A server is asked.
	JOINING,
	## The session has begun: there is nothing to try out any more.
	JOINED,
}

## How far it is.
var phase: Phase = Phase.LOOKING
## What a user is to know of joining, such as why it failed; empty: nothing.
var text: String = ""
## Address of the session, for people.
var where: String = ""


## Whether the session has not begun.
func is_before_session() -> bool:
	return phase != Phase.JOINED


## The user wants to join.
func join() -> void:
	if phase == Phase.LOOKING:
		note(Phase.JOINING, "")
		join_wanted.emit()


## The user does not want to join any more.
func stop() -> void:
	if phase == Phase.JOINING:
		stop_wanted.emit()
		note(Phase.LOOKING, "")


## Says how far it is, with a text for the user.
func note(p_phase: Phase, p_text: String) -> void:
	phase = p_phase
	text = p_text
	changed.emit()

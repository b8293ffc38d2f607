@abstract class_name ClientPart
extends ProgramPart
## One job of a client, such as its sound or its display: a feature is a part of its own file, and
## [Client] conducts the parts without knowing any of them.
##
## [code]ProgramParts[/code] in [code]scripts/app[/code] lists which roles have which part, in their
## order. A client opens all parts, begins with each, then runs each frame in three steps, in every
## one of them all parts in their order: [method begin_frame], [method advance], [method end_frame].
## At the end it lets each part [method finish], then closes them in the opposite order. What parts
## know of one another is in the [ClientContext].

## What all parts share; set by [method open].
var context: ClientContext = null


## Takes over what all parts share, and what the options say. Returns what is wrong with the
## options, or an empty text. An overriding method calls this one first.
func open(p_context: ClientContext) -> String:
	context = p_context
	return ""


## A frame begins: reads devices, before what has arrived is taken in.
func begin_frame() -> void:
	pass


## Goes on, by the frame's length, s: everything gets to the place where the frame shows it.
func advance(_delta_s: float) -> void:
	pass


## Every node is where the frame, of this length, s, shows it.
func end_frame(_delta_s: float) -> void:
	pass


## Whether a session with a duration may end now.
func is_ready_to_end() -> bool:
	return true

@abstract class_name ServerPart
extends ProgramPart
## One job of a server, such as its levels or its effects: a feature is a part of its own file, and
## [Server] conducts the parts without knowing any of them.
##
## [code]ProgramParts[/code] in [code]scripts/app[/code] lists the parts in their order. A server
## opens all parts, begins with each, then runs each tick in four steps, in every one of them all
## parts in their order: [method receive] and [method advance] before the physics step,
## [method measure] and [method send] after it. At the end it lets each part [method finish], then
## closes them in the opposite order. What parts know of one another is in the [ServerContext].

## What all parts share; set by [method open].
var context: ServerContext = null


## Takes over what all parts share, and what the options say. Returns what is wrong with the
## options, or an empty text. An overriding method calls this one first.
func open(p_context: ServerContext) -> String:
	context = p_context
	return ""


## A tick begins, at a time in µs: takes in what has arrived since the last one.
func receive(_now_usec: int) -> void:
	pass


## Prepares the physics step of the tick, which has this length, s, and began at a time in µs.
func advance(_now_usec: int, _delta_s: float) -> void:
	pass


## The step is done: reads what has come of it.
func measure() -> void:
	pass


## Sends clients the state after the step, at a time in µs.
func send(_now_usec: int) -> void:
	pass


## Nothing is due before the next tick: does work that no tick should wait for.
func idle() -> void:
	pass


## Goes on in every frame, with a tick or without.
func frame() -> void:
	pass


## The options that may change while the server runs are read again, by the first part: takes over
## what has changed.
func take_options() -> void:
	pass

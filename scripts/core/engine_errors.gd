class_name EngineErrors
extends RefCounted
## Errors that the engine reports although nothing is wrong: they are left out of standard error, by
## their exact words. All others stay visible.
##
## Whoever meets another one adds it here, with what was found of it. The rest of the program uses
## what the engine has, and never silences it ([member Engine.print_error_messages]).

const _CONNECTION: String = "ERROR: Attempt to disconnect a nonexistent connection from '*'. "
const _AGAIN: String = "' is already connected to given callable '' in that object."

## What is left out.
##
## A child leaves a [Container], in release builds of Debian (4.6.3+ds-2). Container's
## remove_child_notify looks in vain for two of the three connections that add_child_notify made:
## CallableCustomMethodPointerBase::_setup works out a callable's hash from memory that it reads as
## another type than it was written as, and the compiler of that build takes the freedom to read it
## before. Harmless: the connections serve as long as the child is there. They stay until the child
## or the container is freed, and let a container that a child has left be laid out once more; a
## child that comes back finds them ("already connected"). Builds with debugging say whose callable
## it is and have no such errors.
##
## No speech service runs where [GuideCues] asks for its voices: there are none.
const HARMLESS: PackedStringArray = [
	_CONNECTION + "Signal: 'size_flags_changed', callable: ''.",
	_CONNECTION + "Signal: 'visibility_changed', callable: ''.",
	"ERROR: Signal 'size_flags_changed" + _AGAIN,
	"ERROR: Signal 'visibility_changed" + _AGAIN,
	'ERROR: Parameter "synth" is null.',
]


## Leaves them out from now on.
static func leave_out_harmless() -> void:
	for pattern: String in HARMLESS:
		ErrorFilter.leave_out(pattern)

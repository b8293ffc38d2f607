class_name Snapshot
extends RefCounted
## Where bodies are after a step of the simulation. Frame: Godot's world, metres.

## Number of the server's physics tick that made it. The one clock of a session.
var tick: int = 0
## Ticks per second of the server.
var tick_rate: int = 60
## Transform of each body, by the id that the [WorldDescription] gives it.
var bodies: Dictionary[int, Transform3D] = {}
## The newest sample that moved each person, by actor id.
var samples: Dictionary[int, SampleMark] = {}


## Which sample moved a person, for measuring the delay from sampling to display.
class SampleMark:
	## Number of the sample.
	var id: int = 0
	## When it was taken, Unix time on the wearer's machine, µs.
	var time_usec: int = 0

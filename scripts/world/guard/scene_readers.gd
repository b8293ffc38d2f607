class_name SceneReaders
extends RefCounted
## Makes a [SceneReader] when one is asked for, and not before.
##
## Behind [LevelReader] are the classes of the whole level kit. Who names it has them all compiled,
## half a second of a processor at each start of a program from its sources.

const _READER: String = "res://scripts/world/guard/level_reader.gd"


## A reader.
static func make() -> SceneReader:
	return (load(_READER) as GDScript).new()

@abstract class_name SceneReader
extends RefCounted
## Builds a [Level] from a text scene that may come from anybody: what [LevelReader] does, for those
## that few programs ever ask for it. [SceneReaders] makes one.

## Why the level is refused: file, line and reason; empty if it is not.
var refusal: String = ""
## All that is wrong with it, if [member most_faults] is more than 1.
var faults: PackedStringArray = []
## It goes on reading until it has found so much.
var most_faults: int = 1
## How much is done, 0 to 1. Other threads may read it.
var progress: float = 0.0

## The level of a text scene, not in the tree; null if it is refused. [param p_folder] has the whole
## paths of the files beside it, by name.
@abstract func build(
	p_bytes: PackedByteArray, p_file: String, p_folder: Dictionary[String, String] = {}
) -> Level

class_name BvhResult
extends RefCounted
## What reading a BVH file gave: a whole clip, or the reason why there is none.

## The clip, or null if the file could not be read.
var clip: BvhClip = null
## Why not, in one line: "walk.bvh:17: expected 'OFFSET' with 3 numbers, found 'OFFSET 1 x 3'".
## Empty if there is a clip.
var error: String = ""


## Whether there is a clip.
func is_ok() -> bool:
	return clip != null

class_name BvhPose
extends RefCounted
## Where all joints of a [BvhClip] are at one time: Godot's frame, right-handed, Y up.

## Rotation of each joint in the world from the rest pose, in which all are the identity. An end
## site has its parent's.
var orientations: Array[Quaternion] = []
## Place of each joint in the world, m.
var positions: PackedVector3Array = PackedVector3Array()

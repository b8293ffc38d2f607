class_name LandmarkFrame
extends RefCounted
## The landmarks of one person in one picture, numbered as MediaPipe numbers them.

## Points, m, seen by the camera: X right in the picture for who looks at it, Y up, Z to the camera;
## the hips' middle is at the origin.
var places: PackedVector3Array = PackedVector3Array()
## How well each is seen, 0 to 1.
var seen: PackedFloat32Array = PackedFloat32Array()
## x and y in widths of the picture from its top left corner, and how well it is seen; empty where
## the sender does not say.
var in_picture: PackedVector3Array = PackedVector3Array()
## Where each is from the camera, in the same frame, with Z = -1; empty without [member in_picture].
var rays: PackedVector3Array = PackedVector3Array()
## When it was taken, µs.
var usec: int = 0


## Works [member rays] out of [member in_picture], by the picture's height in widths and how much
## the camera sees across, degrees.
func set_rays(p_height: float, p_fov_deg: float) -> void:
	var per_width: float = 2.0 * tan(deg_to_rad(p_fov_deg) / 2.0)
	rays.resize(in_picture.size())
	for point: int in in_picture.size():
		var at: Vector3 = in_picture[point]
		rays[point] = Vector3((at.x - 0.5) * per_width, (p_height / 2.0 - at.y) * per_width, -1.0)

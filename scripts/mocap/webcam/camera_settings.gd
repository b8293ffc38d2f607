class_name CameraSettings
extends RefCounted
## What is known of a webcam that its pictures do not show.

## How much it sees across the picture, degrees.
var fov_deg: float = 65.0
## Most people that are followed.
var people: int = 1
## Height of the person in front of it, m; 0 where it is not known.
var height_m: float = 0.0

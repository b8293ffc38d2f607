class_name TrackLayout
extends Resource
## The measures of a tracked vehicle's model that its nodes do not say.

## Length of a link from pin to pin, m.
@export_range(0.05, 0.5, 0.001, "suffix:m") var pitch: float = 0.16
## Teeth of a sprocket.
@export_range(6, 40) var teeth: int = 14
## Width of the track, m.
@export_range(0.1, 1.5, 0.01, "suffix:m") var width: float = 0.6
## From the line through the pins to the surface that wheels run on, m.
@export_range(0.0, 0.2, 0.001, "suffix:m") var inner: float = 0.026
## From the line through the pins to the ground, m.
@export_range(0.0, 0.2, 0.001, "suffix:m") var outer: float = 0.058
## From a suspension arm's pivot to its wheel's axle, rearwards and upwards, m.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var arm: Vector2 = Vector2(0.40, -0.22)


## Radius of the line of pins around the sprocket, m.
func sprocket_radius() -> float:
	return teeth * pitch / TAU

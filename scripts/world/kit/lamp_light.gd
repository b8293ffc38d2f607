class_name LampLight
extends RefCounted
## What a lamp or a torch gives to the light of a level.

## Where it is, m.
var position: Vector3 = Vector3.ZERO
## Light on a surface 1 m away that faces it, linear.
var colour: Color = Color.WHITE
## Where it has faded to nothing, m.
var range_m: float = 10.0
## Direction of its cone.
var way: Vector3 = Vector3.DOWN
## Half the angle of its cone, rad; PI for all sides.
var angle: float = PI


## A lamp that shines to all sides.
static func make(p_position: Vector3, p_colour: Color, p_range_m: float) -> LampLight:
	var lamp: LampLight = LampLight.new()
	lamp.position = p_position
	lamp.colour = p_colour
	lamp.range_m = p_range_m
	return lamp


## The same lamp seen from another frame.
func moved(p_place: Transform3D) -> LampLight:
	var lamp: LampLight = make(p_place * position, colour, range_m)
	lamp.way = p_place.basis * way
	lamp.angle = angle
	return lamp

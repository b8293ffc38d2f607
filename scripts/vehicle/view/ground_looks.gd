class_name GroundLooks
extends RefCounted
## What grounds do under wheels: how much dust, of which colour, and whether tracks stay in them.


## Share of the most dust that comes from a kind of ground, 0 to 1.
static func dust_of(p_key: StringName) -> float:
	return ContactMaterial.named(p_key).dust


## Colour of the dust of a kind of ground, linear.
static func colour_of(p_key: StringName) -> Color:
	return ContactMaterial.named(p_key).dust_color.srgb_to_linear()


## How deep the prints are that stay in a kind of ground, 0 for none.
static func print_of(p_key: StringName) -> float:
	return ContactMaterial.named(p_key).print_depth

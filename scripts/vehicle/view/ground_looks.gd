class_name GroundLooks
extends RefCounted
## What grounds do under wheels: how much dust, of which colour, and whether tracks stay in them.

## Share of the most dust that each kind of ground gives; of others none comes.
const _DUST: Dictionary[StringName, float] = {
	&"sand": 1.0,
	&"dirt": 0.85,
	&"gravel": 0.45,
	&"rock": 0.12,
}
## Colour of the dust, linear, where it is not the sand's.
const _COLOURS: Dictionary[StringName, Color] = {
	&"sand": Color(0.68, 0.51, 0.31),
	&"dirt": Color(0.42, 0.28, 0.16),
	&"gravel": Color(0.40, 0.32, 0.22),
	&"rock": Color(0.36, 0.25, 0.16),
}
## How deep prints are that stay, 0 to 1.
const _PRINTS: Dictionary[StringName, float] = {
	&"sand": 1.0,
	&"dirt": 0.8,
	&"gravel": 0.35,
}


## Share of the most dust that comes from a kind of ground, 0 to 1.
static func dust_of(p_key: StringName) -> float:
	return _DUST.get(p_key, 0.0)


## Colour of the dust of a kind of ground, linear.
static func colour_of(p_key: StringName) -> Color:
	return _COLOURS.get(p_key, Color(0.68, 0.51, 0.31))


## How deep the prints are that stay in a kind of ground, 0 for none.
static func print_of(p_key: StringName) -> float:
	return _PRINTS.get(p_key, 0.0)

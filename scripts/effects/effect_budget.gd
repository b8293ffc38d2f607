@tool
class_name EffectBudget
extends RefCounted
## How many particles there may be, and how often they may fill the picture.
##
## Not the number of particles costs time but how much of the picture they cover, again and again.
## Where all together cover too much, each gets fewer of its particles, those far away first.

## Distance beyond which half the particles are drawn, m.
const HALF_M: float = 120.0
## The least share of its particles that each effect keeps.
const MIN_ROOM: float = 0.12

## Share of the particles of all effects: [code]Quality[/code] sets it.
static var share: float = 1.0
## How many times all particles together may fill the picture.
static var screens: float = 4.0


## Gives each effect of a world its room, seen by a camera.
static func spread(p_effects: Array[ParticleEffect], p_camera: Camera3D) -> void:
	var total: float = 0.0
	var wanted: PackedFloat32Array = []
	for shown: ParticleEffect in p_effects:
		var away: float = p_camera.global_position.distance_to(shown.global_position)
		var room: float = share * room_at(away)
		wanted.append(room)
		total += shown.screens(p_camera) * room * shown.share
	var part: float = minf(1.0, screens / maxf(total, 0.001))
	for index: int in p_effects.size():
		var room: float = maxf(wanted[index] * part, minf(MIN_ROOM, share))
		var before: float = p_effects[index].room
		# Every change costs a call to the renderer; but nothing stays a little below all.
		if absf(room - before) > 0.04 or (room == 1.0 and before < 1.0):
			p_effects[index].room = room


## Share of its particles that an effect has at a distance, m.
static func room_at(p_away: float) -> float:
	return clampf(1.25 - 0.75 * p_away / HALF_M, 0.5, 1.0)

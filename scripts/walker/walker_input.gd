class_name WalkerInput
extends RefCounted
## The wish of somebody who walks by keys or a stick in a tick: the command [code]walk[/code] of a
## person's [EntityType].
##
## It is rounded to the steps of that command before anybody uses it, so that server and client walk
## by the same numbers.

## Name of the command.
const COMMAND: StringName = &"walk"

## Numbers of corrections wrap at this.
const CORRECTIONS: int = 16

const _JUMPS: int = 4

## Wished velocity along +X and +Z of the world, m/s.
var wish: Vector2 = Vector2.ZERO
## Where to face: the angle about +Y, rad, 0 towards +Z.
var heading: float = 0.0
## How far up the eyes look, rad.
var look: float = 0.0
## One of [enum WalkerMover.Stance].
var stance: WalkerMover.Stance = WalkerMover.STAND
## Whether to jump, or to climb what is ahead.
var jumps: bool = false
## [method WalkerMover.get_check] of the state that the client has before this tick.
var check: int = 0
## Number of the newest correction that the client has taken, below [constant CORRECTIONS].
var correction: int = 0


## Reads the values of a command.
static func of_values(p_values: PackedFloat32Array) -> WalkerInput:
	var input: WalkerInput = WalkerInput.new()
	if p_values.size() < 6:
		return input
	input.wish = Vector2(p_values[0], p_values[1])
	input.heading = p_values[2]
	input.look = p_values[3]
	var moves: int = int(p_values[4])
	input.stance = mini(moves & 3, WalkerMover.PRONE) as WalkerMover.Stance
	input.jumps = moves & _JUMPS != 0
	input.correction = moves >> 4
	input.check = int(p_values[5])
	return input


## A velocity ahead and to the right of a heading, m/s, along +X and +Z of the world.
static func to_world(p_ahead: float, p_right: float, p_heading: float) -> Vector2:
	var ahead: Vector2 = Vector2(sin(p_heading), cos(p_heading))
	return ahead * p_ahead + Vector2(-ahead.y, ahead.x) * p_right


## The values of the command.
func to_values() -> PackedFloat32Array:
	var moves: int = stance | (_JUMPS if jumps else 0) | correction << 4
	return [wish.x, wish.y, heading, look, moves, check]


## What the server makes of it when it comes as a command of this form.
func rounded(p_schema: EntitySchema) -> WalkerInput:
	var values: PackedFloat32Array = to_values()
	for index: int in mini(values.size(), p_schema.fields.size()):
		values[index] = p_schema.fields[index].quantize(values[index])
	return of_values(values)


## Moves a walker by a tick.
func apply(p_mover: WalkerMover, p_delta_s: float) -> void:
	p_mover.tick(wish, heading, stance, jumps, p_delta_s)

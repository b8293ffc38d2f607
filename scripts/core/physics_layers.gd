class_name PhysicsLayers
extends RefCounted
## Bits of the 3D physics layers that project.godot names.

## What never moves.
const STATIC: int = 1 << 0
## People's limbs.
const PEOPLE: int = 1 << 1
## What people and forces move.
const PROPS: int = 1 << 2
## Everything that bodies collide with.
const ALL: int = STATIC | PEOPLE | PROPS

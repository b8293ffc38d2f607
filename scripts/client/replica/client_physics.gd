class_name ClientPhysics
extends RefCounted
## The physics space of a client: the level's static bodies are in it, so that rays and other
## queries find them; it is not stepped, so that it costs nothing.
##
## What needs steps (a capsule that predicts its own walk, debris that only this client sees) calls
## [method hold], and [method release] when it is gone. It never moves what
## the server simulates: bodies of props and people are kinematic here.

## Number of added bodies after which the space makes a few steps. Jolt frees the nodes of its trees
## only in a step: without any, the program would end after some 100,000 bodies.
const MAX_ADDED: int = 512

const _TIDYING_FRAMES: int = 3

static var _holders: int = 0
static var _added: int = 0
static var _tidying: int = 0


## A client begins: nobody needs steps.
static func begin() -> void:
	_holders = 0
	_added = 0
	_tidying = 0
	PhysicsServer3D.set_active(false)


## The client ends: the space steps as in any program.
static func end() -> void:
	PhysicsServer3D.set_active(true)


## Somebody needs steps.
static func hold() -> void:
	_holders += 1
	PhysicsServer3D.set_active(true)


## Somebody who needed steps needs them no longer.
static func release() -> void:
	_holders = maxi(_holders - 1, 0)
	PhysicsServer3D.set_active(is_stepping())


## Counts bodies that have come into the space.
static func note_added(p_bodies: int) -> void:
	_added += p_bodies


## Lets the space make steps if many bodies have come. Call it in each physics frame.
static func advance() -> void:
	if _added > MAX_ADDED:
		_added = 0
		_tidying = _TIDYING_FRAMES
	elif _tidying > 0:
		_tidying -= 1
	else:
		return
	PhysicsServer3D.set_active(is_stepping())


## Whether the space makes steps.
static func is_stepping() -> bool:
	return _holders > 0 or _tidying > 0

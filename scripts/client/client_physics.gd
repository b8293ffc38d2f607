class_name ClientPhysics
extends RefCounted
## The physics space of a client: the level's static bodies are in it, so that rays and other
## queries find them; it is not stepped, so that it costs nothing.
##
## What needs steps (a capsule that predicts its own walk, debris that only this client sees) calls
## [method hold], and [method release] when it is gone. It never moves what
## the server simulates: bodies of props and people are kinematic here.

static var _holders: int = 0


## A client begins: nobody needs steps.
static func begin() -> void:
	_holders = 0
	PhysicsServer3D.set_active(false)


## Somebody needs steps.
static func hold() -> void:
	_holders += 1
	PhysicsServer3D.set_active(true)


## Somebody who needed steps needs them no longer.
static func release() -> void:
	_holders = maxi(_holders - 1, 0)
	PhysicsServer3D.set_active(_holders > 0)


## Whether the space makes steps.
static func is_stepping() -> bool:
	return _holders > 0

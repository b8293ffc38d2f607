class_name Shell
extends RefCounted
## A shell that the server flies.

## What it is.
var ammunition: Ammunition = null
## How it flies.
var flight: ShellFlight = null
## From where on it is to be asked next what it has hit, m: at first the breech, so that a muzzle in
## a wall fires into the wall.
var from: Vector3 = Vector3.ZERO

class_name Shell
extends RefCounted
## A shell that the server flies.

## What it is.
var ammunition: Ammunition = null
## How it flies.
var flight: ShellFlight = null
## Start of the next ray that looks for a hit, m: at first the breech, so that a muzzle inside a
## wall fires into the wall.
var from: Vector3 = Vector3.ZERO

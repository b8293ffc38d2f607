class_name EntityCommand
extends RefCounted
## One command from a client to the server.

## Counts the commands of a client; wraps at 65536.
var number: int = 0
## The server's tick that the client meant it for.
var tick: int = 0
## The entity that is commanded.
var entity: int = 0
## Position of the command in its type's list.
var command: int = 0
## What the command carries, not decoded yet: its type defines how.
var bytes: PackedByteArray = PackedByteArray()

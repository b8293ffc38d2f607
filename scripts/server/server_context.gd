class_name ServerContext
extends RefCounted
## What the parts of a server share: its world, its people, its connections, and its tick.

## The server is to end with an exit code; the reason has been logged.
signal leave_wanted(p_exit_code: int)
## The options are to be read again.
signal reload_wanted
## The world has become slower than the clock, or keeps up again: see [member ServerStats.watch].
signal speed_changed

## The options of the program.
var options: Options = null
## The present level, and the table of all entities.
var level: ServerLevel = null
## The people who have bodies.
var people: ServerPeople = null
## All connections.
var link: ServerLink = ServerLink.new()
## Carries out what instructors order.
var control: SessionControl = SessionControl.new(link)
## Sends clients the state of the world; made by [ReplicationPart].
var replication: Replication = null
## The server's side of all entities; made by [EntitiesPart].
var entities: ServerEntities = null
## What is measured of the ticks.
var stats: ServerStats = null
## Makes the report of all parts: [code]func() -> Dictionary[/code].
var make_report: Callable = Callable()
## The present tick.
var tick: int = 0
## Processor time of the main thread for the network, in this tick so far, µs.
var network_usec: int = 0


## Ticks per second.
func rate() -> int:
	return Engine.physics_ticks_per_second


## The share of the network of each client, bit/s.
func bandwidth() -> float:
	return options.number("bandwidth") * 1000.0

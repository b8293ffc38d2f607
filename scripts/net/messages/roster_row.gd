class_name RosterRow
extends RefCounted
## One client in an instructor's list of who is here.

## Whether the client takes part.
enum State {
	## It waits until an instructor admits it.
	WAITING,
	## It takes part.
	HERE,
	## Its connection is lost; its session is kept for a while.
	LOST,
	## It waits for room.
	QUEUED,
}

## Names of the states, for people and for the status.
const STATE_NAMES: Dictionary[State, String] = {
	State.WAITING: "waiting",
	State.HERE: "here",
	State.LOST: "lost",
	State.QUEUED: "queued",
}

## Number of its session; 0 while it waits.
var session: int = 0
## Id of its connection; 0 while that is lost.
var peer: int = 0
## What it is.
var role: Roles.Role = Roles.Role.OBSERVER
## Whether it takes part.
var state: State = State.WAITING
## Its name; no other session has the same.
var name: String = ""
## IP address.
var address: String = ""
## Number of people whose motion it sends.
var people: int = 0
## Round trip to the server, ms; negative: not known.
var round_trip_ms: float = -1.0
## Median from a sample to its display at the client, ms; negative: not known.
var delay_ms: float = -1.0
## Mean difference between its people's bodies and their motion, degrees; negative: not known.
var tracking_deg: float = -1.0
## What it says of its suit; empty: nothing.
var suit: String = ""


## Name of the state.
func state_name() -> String:
	return STATE_NAMES[state]


## Whether it is here, and may do something.
func can(p_capability: Roles.Capability) -> bool:
	return state == State.HERE and Roles.can(role, p_capability)

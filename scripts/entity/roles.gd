class_name Roles
extends RefCounted
## What clients can be, and what each may do: one table for handshake, guard, server and help.
##
## A new role is a new member of [enum Role] and a row of [constant ROWS].

## What a client is. Numbers are those of the wire.
enum Role {
	## Watches.
	OBSERVER,
	## Sends the motion of people and has their bodies.
	TRAINEE,
	## Watches, directs the session and decides who takes part.
	INSTRUCTOR,
}

## What a role may do.
enum Capability {
	## Send the motion of people, who get bodies.
	SEND_MOTION = 1,
	## Command entities: press a button, take a seat, steer.
	COMMAND = 2,
	## Direct the session: change the level, have trainees calibrate.
	DIRECT = 4,
	## Decide who takes part: admit, refuse, kick and ban.
	MODERATE = 8,
	## Play back what was recorded, while the session runs.
	REVIEW = 16,
}

## Roles by number: name on the command line, capabilities, and what it is for.
const ROWS: Dictionary[int, Array] = {
	Role.OBSERVER: ["observer", Capability.COMMAND | Capability.REVIEW, "watches"],
	Role.TRAINEE:
	[
		"trainee",
		Capability.SEND_MOTION | Capability.COMMAND | Capability.REVIEW,
		"sends the motion of people and has their bodies"
	],
	Role.INSTRUCTOR:
	[
		"instructor",
		Capability.COMMAND | Capability.DIRECT | Capability.MODERATE | Capability.REVIEW,
		"watches, directs and decides who takes part"
	],
}


## Whether there is a role of a number.
static func is_role(p_role: int) -> bool:
	return ROWS.has(p_role)


## Whether a role may do something.
static func can(p_role: int, p_capability: Capability) -> bool:
	return is_role(p_role) and ROWS[p_role][1] & p_capability != 0


## Name of a role on the command line and in the log.
static func name_of(p_role: int) -> String:
	return ROWS[p_role][0] if is_role(p_role) else "nobody"


## The role of a name, or -1.
static func find(p_name: String) -> int:
	for role: int in ROWS:
		if ROWS[role][0] == p_name:
			return role
	return -1


## Names of all roles, or of those that may do something.
static func names(p_capability: int = 0) -> PackedStringArray:
	var found: PackedStringArray = []
	for role: int in ROWS:
		if p_capability == 0 or ROWS[role][1] & p_capability != 0:
			found.append(ROWS[role][0])
	return found


## What a role is for, for people.
static func describe(p_role: int) -> String:
	return ROWS[p_role][2] if is_role(p_role) else ""

class_name ProgramRoles
extends RefCounted
## What the program can be started as: a server, a client of each of [Roles], a replay, a load.

const SERVER: String = "server"
const LOAD: String = "load"
## The start screen, which begins the others.
const START: String = "start"
## Role of a client that plays a recording; it never joins a session.
const REPLAY: String = "replay"
## The roles that are no client of a session, and what they are for.
const _OTHERS: Dictionary[String, String] = {
	START: "opens the start screen, which leads to all others",
	SERVER: "simulates the world and sends its state to everybody",
	REPLAY: "shows what --record has kept",
	LOAD: "puts many clients without displays on a server, for ./run load",
}


## Names of all.
static func names() -> PackedStringArray:
	return PackedStringArray([START, SERVER]) + showing() + PackedStringArray([LOAD])


## Those that join a session.
static func joining() -> PackedStringArray:
	return Roles.names() + PackedStringArray([LOAD])


## Those that show a world.
static func showing() -> PackedStringArray:
	return Roles.names() + PackedStringArray([REPLAY])


## Those that send the motion of people.
static func moving() -> PackedStringArray:
	return Roles.names(Roles.Capability.SEND_MOTION)


## What one is for, for people.
static func describe(p_name: String) -> String:
	return _OTHERS.get(p_name, Roles.describe(Roles.find(p_name)))


## The role that arguments or environment name, known or not. By default an exported dedicated
## server is a server, every other build an observer.
static func find_in(p_arguments: PackedStringArray) -> String:
	var role: String = OS.get_environment("DISMOUNT_ROLE")
	for i: int in p_arguments.size():
		if p_arguments[i].begins_with("--role="):
			role = p_arguments[i].trim_prefix("--role=")
		elif p_arguments[i] == "--role" and i + 1 < p_arguments.size():
			role = p_arguments[i + 1]
	if role != "":
		return role
	var other: String = Roles.name_of(Roles.Role.OBSERVER)
	return SERVER if OS.has_feature("dedicated_server") else other

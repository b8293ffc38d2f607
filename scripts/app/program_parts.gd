class_name ProgramParts
extends RefCounted
## Which parts each role of the program is made of, and which options there are, as data: a new
## feature is a row here, and nothing else knows it.
##
## Parts are paths, so that a program compiles those of its own role only.

## The roles that have a part.
enum Who {
	## Every client.
	ALL,
	## Roles that take part in a session of a server.
	LIVE,
	## Roles that play a recording.
	REPLAY,
	## Roles that send motion.
	MOVES,
	## Roles that give orders.
	MODERATES,
}

## The parts of clients, in their order: see [ClientPart].
const CLIENT: Dictionary[String, Who] = {
	"res://scripts/client/session/live_session.gd": Who.LIVE,
	"res://scripts/client/session/replay_session.gd": Who.REPLAY,
	"res://scripts/client/session/session_recorder.gd": Who.ALL,
	"res://scripts/client/window/window_controls.gd": Who.ALL,
	"res://scripts/client/window/client_interaction.gd": Who.LIVE,
	"res://scripts/client/seat/client_seat.gd": Who.LIVE,
	"res://scripts/client/display/client_display.gd": Who.ALL,
	"res://scripts/client/display/client_frames.gd": Who.ALL,
	"res://scripts/client/walk/client_walker.gd": Who.MOVES,
	"res://scripts/client/suit/mocap_setup.gd": Who.MOVES,
	"res://scripts/client/orders/instructor_desk.gd": Who.MODERATES,
	"res://scripts/client/level/client_levels.gd": Who.LIVE,
	"res://scripts/client/session/join_cover.gd": Who.LIVE,
	"res://scripts/client/level/effect_updates.gd": Who.LIVE,
	"res://scripts/client/session/world_updates.gd": Who.ALL,
	"res://scripts/client/sound/client_sound.gd": Who.ALL,
	"res://scripts/client/display/world_view.gd": Who.ALL,
	"res://scripts/client/window/status_lines.gd": Who.ALL,
	"res://scripts/client/window/session_picture.gd": Who.ALL,
}

## The parts of a server, in their order: see [ServerPart].
const SERVER: PackedStringArray = [
	"res://scripts/server/parts/port_part.gd",
	"res://scripts/server/parts/replication_part.gd",
	"res://scripts/server/parts/level_part.gd",
	"res://scripts/server/effects/server_effects.gd",
	"res://scripts/server/parts/people_part.gd",
	"res://scripts/server/parts/entities_part.gd",
	"res://scripts/server/parts/walkers_part.gd",
	"res://scripts/server/parts/motion_part.gd",
	"res://scripts/server/parts/discovery_part.gd",
	"res://scripts/server/parts/status_part.gd",
	"res://scripts/server/parts/companion_part.gd",
]

## What has options: each script has [code]static func rows() -> Array[OptionRow][/code].
# They are compiled at each start of the program, with all that they name: constants of whole
# programs belong elsewhere.
const OPTIONS: PackedStringArray = [
	"res://scripts/net/session/connection_options.gd",
	"res://scripts/client/suit/suit_options.gd",
	"res://scripts/client/walk/walk_options.gd",
	"res://scripts/server/parts/server_options.gd",
	"res://scripts/server/parts/world_options.gd",
	"res://scripts/client/display/display_options.gd",
	"res://scripts/client/sound/sound_options.gd",
	"res://scripts/client/level/level_options.gd",
	"res://scripts/client/seat/seat_options.gd",
	"res://scripts/client/window/window_options.gd",
	"res://scripts/client/orders/orders_options.gd",
	"res://scripts/client/session/replay_options.gd",
	"res://scripts/load/load_options.gd",
	"res://scripts/app/run_options.gd",
]


## Paths of the parts of a client of a role.
static func of_client(p_role: String) -> PackedStringArray:
	var paths: PackedStringArray = []
	for path: String in CLIENT:
		if _has(p_role, CLIENT[path]):
			paths.append(path)
	return paths


static func _has(p_role: String, p_who: Who) -> bool:
	var role: int = Roles.find(p_role)
	match p_who:
		Who.LIVE:
			return p_role != ProgramRoles.REPLAY
		Who.REPLAY:
			return p_role == ProgramRoles.REPLAY
		Who.MOVES:
			return Roles.can(role, Roles.Capability.SEND_MOTION)
		Who.MODERATES:
			return Roles.can(role, Roles.Capability.MODERATE)
	return true

class_name ProgramOptions
extends RefCounted
## Every option of the program. Checks, [code]--help[/code] and docs/options.md are made from these
## rows: a new option is a row here, and the code that reads it.

# What is named here is compiled at each start of the program, with all that it names: constants of
# whole programs (a server, a client) belong elsewhere.

## Maximum of trainees, and of observers, of a load.
const _MAX_LOAD: int = 500

static var _levels: PackedStringArray = []


## Reads arguments such as [code]--port=7777[/code] and the environment, for a role, or for any.
static func parse(p_arguments: PackedStringArray, p_role: String = "") -> Options:
	return Options.parse(rows(), p_arguments, p_role)


## All options, grouped by topic.
static func rows() -> Array[OptionRow]:
	var moving: PackedStringArray = ProgramRoles.moving()
	var with_load: PackedStringArray = moving + PackedStringArray([ProgramRoles.LOAD])
	var sources: Array[OptionRow] = SourceOptions.rows(moving, with_load)
	return (
		_connection()
		+ sources
		+ _motion(moving, with_load)
		+ _server()
		+ _display()
		+ DisplayOptions.rows()
		+ _run()
	)


## Looked for once: a folder is read for them.
static func _level_names() -> PackedStringArray:
	if _levels.is_empty():
		_levels = LevelStore.names()
	return _levels


static func _connection() -> Array[OptionRow]:
	var joining: PackedStringArray = ProgramRoles.joining()
	var clients: PackedStringArray = Roles.names()
	var both: PackedStringArray = PackedStringArray([ProgramRoles.SERVER]) + joining
	return [
		OptionRow.number("port", both, Protocol.DEFAULT_PORT, [1, 65535], "UDP port of the server"),
		OptionRow.text("host", joining, "address of the server").or_default("127.0.0.1"),
		OptionRow.text(
			"name",
			clients,
			"your name, shown to the others; by default the role's",
			Protocol.MAX_NAME
		),
		OptionRow.text(
			"password",
			both,
			(
				"password of the session: the server asks for it, clients prove it."
				+ " Prefer DISMOUNT_PASSWORD: others on the machine can see arguments"
			)
		),
		(
			OptionRow
			. flag(
				"sealing",
				both,
				"encrypt and authenticate every datagram; 0 only where the network can be trusted"
			)
			. or_default(1)
		),
		(
			OptionRow
			. text(
				"server-fingerprint",
				joining,
				"fingerprint that the server's key must have; by default as the last time"
			)
			. shown_as("SHA256:...")
		),
		OptionRow.flag(
			"trust-new-key",
			joining,
			"trust the server's key though it is another than the last time, and remember it"
		),
		OptionRow.number(
			"snapshot-rate",
			joining,
			0,
			[0, 240],
			"snapshots per second to ask for; 0: one each tick"
		),
		OptionRow.decimal(
			"connect-timeout",
			clients,
			0.0,
			[0.0, 86400.0],
			"give up after this time without a server; 0: never",
			"s"
		),
		OptionRow.number(
			"protocol",
			clients,
			Protocol.VERSION,
			[0, 65535],
			"protocol version to claim, for tests"
		),
	]


static func _motion(
	p_moving: PackedStringArray, p_with_load: PackedStringArray
) -> Array[OptionRow]:
	return [
		OptionRow.text("person", p_moving, "who wears the suit: name of size and calibration"),
		OptionRow.choice(
			"avatar",
			p_moving,
			"",
			AvatarStore.NAMES,
			(
				"what the others see you as; by default as the world says, else %s"
				% AvatarStore.NAMES[0]
			)
		),
		OptionRow.choice(
			"calibrate", p_moving, "", ClientCalibration.KINDS.keys(), "calibrate at the start"
		),
		OptionRow.flag("panel", p_moving, "open the device panel at the start (key M)"),
		OptionRow.text("unit", p_with_load, "unit of the motion file; guessed by default").shown_as(
			"|".join(BvhOptions.UNITS.keys()) + "|METRES"
		),
		OptionRow.choice(
			"up",
			p_with_load,
			"",
			BvhOptions.AXES.keys(),
			"up axis of the motion file; guessed by default"
		),
		OptionRow.number("rate", p_with_load, 60, [1, 240], "samples to send", "per second"),
		OptionRow.choice(
			"feedback",
			p_moving,
			"local",
			["local", "server"],
			"your own body: shown at once, or as the server simulates it"
		),
	]


static func _server() -> Array[OptionRow]:
	var server: PackedStringArray = [ProgramRoles.SERVER]
	return [
		(
			OptionRow
			. text("world", server, "the level: one of the program's, or of --levels")
			. or_default(LevelStore.DEFAULT)
			. shown_as("|".join(_level_names()) + "|NAME")
		),
		(
			OptionRow
			. file("levels", server, "folder of levels that clients may get from this server")
			. shown_as("FOLDER")
		),
		(
			OptionRow
			. file("effects", server, "folder of effects; what changes in it goes to all clients")
			. shown_as("FOLDER")
		),
		OptionRow.text(
			"time", server, "time of day at the start, hours; by default the level's own"
		),
		OptionRow.choice(
			"weather",
			server,
			"",
			WorldConditions.WEATHERS,
			"weather at the start; by default the level's own"
		),
		OptionRow.number(
			"level-bandwidth",
			server,
			LevelOffers.DEFAULT_KBITS,
			[100, 10_000_000],
			"limit for all downloads of levels together",
			"kbit/s"
		),
		(
			OptionRow
			. number(
				"max-clients",
				server,
				Protocol.DEFAULT_MAX_CLIENTS,
				# ENet's maximum, less those that are just arriving.
				[1, 4000],
				"maximum of clients"
			)
		),
		(
			OptionRow
			. number(
				"max-people",
				server,
				PeopleChanges.DEFAULT_MAX,
				# Each has 16 bodies of the 10,240 that the engine has room for.
				[1, 500],
				"maximum of people who have a body, of all clients together"
			)
		),
		(
			OptionRow
			. number(
				"max-per-address",
				server,
				ServerRules.QUARTER,
				[ServerRules.QUARTER, 4000],
				"maximum of clients from one address; -1: a quarter of --max-clients, 4 at least; 0: any"
			)
		),
		OptionRow.file(
			"server-key",
			server,
			"file of the key by which clients know the server again; made if there is none"
		),
		OptionRow.text("instructor-password", server, "password of instructors, if theirs differs"),
		OptionRow.flag("waiting-room", server, "everybody waits until an instructor admits them"),
		OptionRow.file(
			"ban-file", server, "JSON list of banned addresses; new bans are added to it"
		),
		OptionRow.number(
			"bandwidth", server, 250, [1, 1000000], "limit for each client's snapshots", "kbit/s"
		),
		OptionRow.decimal(
			"pose-error",
			server,
			Protocol.POSE_ERROR_DEG,
			[EntityTableMessage.MIN_ERROR_DEG, EntityTableMessage.MAX_ERROR_DEG],
			"maximum error of limbs on the wire",
			"degrees"
		),
		OptionRow.choice(
			"root",
			server,
			"grounded",
			RootModes.BY_NAME.keys(),
			"how people's travel is found and followed"
		),
		OptionRow.number(
			"status-port",
			server,
			0,
			[0, 65535],
			"TCP port of the status on 127.0.0.1; 0: the number of --port"
		),
		OptionRow.number(
			"end-with", server, 0, [0, 1 << 30], "end when the process of this number has; 0: none"
		),
	]


static func _display() -> Array[OptionRow]:
	var showing: PackedStringArray = ProgramRoles.showing()
	var clients: PackedStringArray = Roles.names()
	return [
		OptionRow.choices_of(
			"views", showing, "mesh,static", WorldViews.NAMES, "worlds to show at the start"
		),
		(
			OptionRow
			. text("physics-at", showing, "when the physics world fades in and out again, s")
			. shown_as("BEGIN,END")
		),
		OptionRow.choice(
			"quality",
			showing,
			"",
			Quality.NAMES,
			"how much is drawn; by default what fits the machine, or what was chosen in the menu"
		),
		OptionRow.choice(
			"sound",
			showing,
			"auto",
			ClientSound.MODES,
			"whether the client makes sound; auto: where it has a window (docs/sound.md)"
		),
		OptionRow.text("volume", showing, "how loud all is, instead of the menu's, %").shown_as(
			"0-100"
		),
		OptionRow.flag("captions", showing, "show captions of sounds, whatever the menu says"),
		OptionRow.text("camera", showing, "camera at the start, degrees and m").shown_as(
			"AZIMUTH,ELEVATION,DISTANCE|around|behind|eyes"
		),
		OptionRow.choice(
			"smoothing",
			showing,
			"adaptive_low_delay",
			WorldReplica.SMOOTHING.keys(),
			"method for the motion between updates (docs/smoothing.md)"
		),
		OptionRow.number(
			"fps",
			showing,
			FramePacer.HEADLESS_FPS,
			[1, 1000],
			"frames without a window",
			"per second"
		),
		OptionRow.number(
			"level-store",
			clients,
			ReceivedLevels.DEFAULT_ROOM >> 20,
			[1, 1 << 20],
			"room for levels that servers have sent",
			"MB"
		),
		(
			OptionRow
			. text(
				"platform", clients, "motion platform to send cues to while you sit in a vehicle"
			)
			. shown_as(PlatformAddress.FORM)
		),
		OptionRow.choice(
			"platform-kind",
			clients,
			MotionPlatform.PRESETS[0],
			MotionPlatform.PRESETS,
			"what the motion platform can do (docs/motion-platform.md)"
		),
		OptionRow.number(
			"platform-rate", clients, 200, [100, 250], "cues for the platform", "per second"
		),
		(
			OptionRow
			. flag(
				"force-feedback", clients, "rumble and a wheel's forces while you sit in a vehicle"
			)
			. or_default(1)
		),
		(
			OptionRow
			. flag(
				"prediction", clients, "show the vehicle that you drive where it will be, at once"
			)
			. or_default(1)
		),
		OptionRow.text(
			"use", clients, "use the Interactable at or below a node of this name, once it is there"
		),
		OptionRow.text(
			"drive",
			clients,
			"drive by a list instead of keys: THROTTLE:STEERING:BRAKE:SECONDS, with commas between"
		),
		(
			OptionRow
			. text(
				"orders",
				Roles.names(Roles.Capability.MODERATE),
				"orders to give, one after the other (docs/session-guide.md)"
			)
			. shown_as("ORDER:NAME,...")
		),
	]


static func _run() -> Array[OptionRow]:
	var all: PackedStringArray = ProgramRoles.names()
	var showing: PackedStringArray = ProgramRoles.showing()
	var recording: PackedStringArray = PackedStringArray([ProgramRoles.SERVER]) + showing
	var load_only: PackedStringArray = [ProgramRoles.LOAD]
	return [
		OptionRow.file("config", all, "read options from this file, see docs/options.md"),
		OptionRow.file(
			"log-file", all, "write the log to this file too; a server reopens it after SIGHUP"
		),
		OptionRow.choice("log-level", all, "info", Log.LEVELS, "lines that are left out below it"),
		OptionRow.choice("role", all, "", all, "role to start; by default server or observer"),
		OptionRow.decimal("duration", all, 0.0, [0.0, 1e7], "end after this time; 0: never", "s"),
		OptionRow.file("report", all, "write stats to this file (JSON)"),
		OptionRow.decimal(
			"report-every",
			recording,
			ReportFile.PERIOD_S,
			[0.02, 86400.0],
			"time between two writings of --report",
			"s"
		),
		OptionRow.file(
			"record", recording, "record what this client receives, or everything at the server"
		),
		OptionRow.file("file", [ProgramRoles.REPLAY], "recording to replay"),
		OptionRow.decimal(
			"from", [ProgramRoles.REPLAY], 0.0, [0.0, 1e7], "where in the recording to begin", "s"
		),
		OptionRow.file("screenshot", showing, "save a picture (PNG) in high quality at the end"),
		OptionRow.file("latency-csv", showing, "write the latency of each sample, stage by stage"),
		OptionRow.number("trainees", load_only, 1, [0, _MAX_LOAD], "clients that send motion"),
		OptionRow.number("observers", load_only, 1, [0, _MAX_LOAD], "clients that watch"),
	]

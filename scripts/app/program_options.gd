class_name ProgramOptions
extends RefCounted
## Every option of the program, and which values are refused: see [Options].

## Every option: its name, default (whose type it has) and what it means.
const TABLE: Array[Array] = [
	["role", "", "server, trainee, observer, instructor, replay or load"],
	["host", "127.0.0.1", "address of the server to join"],
	["port", Protocol.DEFAULT_PORT, "UDP port of the server"],
	["name", "", "your name, shown to the others"],
	["bvh", "", "trainee: motion files (a,b: several people) to be played in a loop"],
	["xbus", 0, "trainee: 1: motion from the suit on this machine's USB ports"],
	["suit-rate", 100, "trainee: samples per second of the suit, 10 to 512"],
	["mvn", 0, "trainee: UDP port for MVN's network stream (usually 9763); 0 does without"],
	["tracker", "", "trainee: body tracker of another plugin, such as /user/body_tracker"],
	["suit-record", "", "trainee: record every byte of suits and of MVN to this file"],
	["suit-play", "", "trainee: motion from such a file, in a loop"],
	["person", "", "trainee: who wears the suit: whose size and calibration are taken and kept"],
	["calibrate", "", "trainee: calibrate at the start: t_pose, n_pose, t_to_n, full or quick"],
	["panel", 0, "trainee: 1: the panel with devices and sensors is open at the start (key M)"],
	["unit", "", "trainee: unit of the motion file: m, cm, mm, inch, cmu or metres per unit"],
	["up", "", "trainee: up axis of the motion file: y or z"],
	["rate", 60, "trainee: samples per second"],
	["codec", "smallest_3", "trainee: how samples go: smallest_3, thesis_12, thesis_4 or float"],
	["world", LevelStore.DEFAULT, "server: name of the level: a folder in scenes/world"],
	["max-clients", Protocol.DEFAULT_MAX_CLIENTS, "server: clients that are admitted"],
	["bandwidth", 250, "server: kbit/s for each client's snapshots, headers counted"],
	["pose-error", 0.1, "server: how far limbs may be off on the wire, degrees (0.02 to 5)"],
	["status-port", 0, "server: TCP port of the status on 127.0.0.1; 0: the same number as --port"],
	["password", "", "password of the session; the server asks for it, the clients tell it"],
	["instructor-password", "", "server: password of instructors, if it is another"],
	["waiting-room", 0, "server: 1: an instructor admits everybody else"],
	["max-per-address", 0, "server: clients that are admitted from one address; 0 any number"],
	["ban-file", "", "server: JSON list of addresses that are not let in"],
	["orders", "", "instructor: admit, refuse, kick or ban, then :NAME or :*, by commas"],
	["dtls", 0, "client: 1: encrypt the connection, where the engine can"],
	["dtls-certificate", "", "certificate (PEM): the server's own, or the one to be trusted"],
	["dtls-key", "", "server: private key (PEM) of the certificate"],
	["snapshot-rate", 0, "client: snapshots per second that are wanted; 0 as the server does"],
	[
		"root",
		"soft",
		"server: where travel comes from: soft, held, inertial, contacts, lowest_foot"
	],
	["connect-timeout", 0.0, "client: give up after so many seconds without a server; 0 never"],
	["duration", 0.0, "end after so many seconds; 0 never"],
	["report", "", "write stats of the session to this file (JSON) every second"],
	["screenshot", "", "client: write a picture of the screen to this file before the end"],
	["record", "", "record the session to this file: what the server sends, or all of it there"],
	["file", "", "replay: recording to show"],
	["latency-csv", "", "client: write the delay of every sample, stage by stage, to this file"],
	["use", "", "client: use what is below a node of this name in the level, once it is there"],
	["fps", 0, "client without a window: frames per second; 0 for 240"],
	[
		"smoothing",
		"",
		"client: none, linear, extrapolate_lerp, hermite, error_offset, adaptive_low_delay (default)"
	],
	["feedback", "local", "trainee: how the own body is shown: local (at once) or server"],
	["trainees", 1, "load: clients that send motion"],
	["observers", 1, "load: clients that watch"],
	["views", "mesh,static", "client: worlds to show at first: mesh, static, physics"],
	["camera", "", "client: azimuth,elevation,distance of the camera, degrees and m"],
	["protocol", Protocol.VERSION, "client: protocol version to claim (for tests)"],
]

## What options mean that are given without a value.
const BARE: Dictionary[String, String] = {
	"xbus": "1", "panel": "1", "mvn": "9763", "dtls": "1", "waiting-room": "1"
}


## Reads arguments such as [code]--port=7777[/code] and the environment.
static func parse(p_arguments: PackedStringArray) -> Options:
	var options: Options = Options.parse(TABLE, BARE, p_arguments)
	_check_network(options)
	_check_motion(options)
	_check_display(options)
	return options


## The options, a line each, for people.
static func describe() -> String:
	return Options.describe(TABLE)


static func _check_network(p_options: Options) -> void:
	p_options.check_range("port", "a port", 1, 65535)
	p_options.check_range("bandwidth", "the bandwidth", 1, 1000000)
	# ENet's most, less those that are just arriving.
	p_options.check_range("max-clients", "the number of clients", 1, 4000)
	p_options.check_range("snapshot-rate", "--snapshot-rate", 0, 240)
	for name: String in ["trainees", "observers"]:
		p_options.check_range(name, "--" + name, 0, LoadRun.MAX_CLIENTS)
	var error: float = p_options.degrees("pose-error")
	var min_error: float = EntityTableMessage.MIN_ERROR_DEG
	if error < min_error or error > EntityTableMessage.MAX_ERROR_DEG:
		p_options.refuse("--pose-error is %s to 5 degrees, found %s" % [min_error, error])


static func _check_motion(p_options: Options) -> void:
	p_options.check_range("rate", "a rate", 1, 240)
	p_options.check_range("suit-rate", "--suit-rate", 10, 512)
	p_options.check_range("mvn", "--mvn, a UDP port,", 0, 65535)
	p_options.check_choice("calibrate", [""] + ClientCalibration.KINDS.keys())
	p_options.check_choice("codec", PoseMessage.CODECS.keys())


static func _check_display(p_options: Options) -> void:
	p_options.check_choice("feedback", ["local", "server"])
	p_options.check_choice("smoothing", [""] + WorldReplica.SMOOTHING.keys())
	p_options.check_range("fps", "--fps", 0, 1000)

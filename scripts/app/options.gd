class_name Options
extends RefCounted
## What the user asked for: arguments after [code]--[/code], or environment variables of the same
## meaning ([code]--max-clients=8[/code] is [code]DISMOUNT_MAX_CLIENTS=8[/code]). Arguments win.

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

## What is wrong with the arguments, or an empty text.
var error: String = ""

var _values: Dictionary[String, Variant] = {}


## Reads arguments such as [code]--port=7777[/code] and the environment.
static func parse(p_arguments: PackedStringArray) -> Options:
	var options: Options = Options.new()
	for row: Array in TABLE:
		options._values[row[0]] = row[1]
	for row: Array in TABLE:
		var variable: String = "DISMOUNT_" + (row[0] as String).to_upper().replace("-", "_")
		if OS.get_environment(variable) != "":
			options._set_option(row[0], OS.get_environment(variable), variable)
	for argument: String in p_arguments:
		var parts: PackedStringArray = argument.trim_prefix("--").split("=", true, 1)
		if parts.size() == 1 and BARE.has(parts[0]):
			parts.append(BARE[parts[0]])
		if not argument.begins_with("--") or parts.size() != 2:
			options._refuse("'%s' is not of the form --name=value" % argument)
		else:
			options._set_option(parts[0], parts[1], "--" + parts[0])
	return options


## The options, a line each, for people.
static func describe() -> String:
	var lines: PackedStringArray = []
	for row: Array in TABLE:
		var shown: String = "--%s=%s" % [row[0], row[1]]
		lines.append("  %-28s %s" % [shown, row[2]])
	return "\n".join(lines)


## The value of a text option.
func text(p_name: String) -> String:
	return _values[p_name]


## The value of an option that names a file, as a full path: a relative one counts from where the
## program was started, not from where it lies. Empty if there is none.
func file(p_name: String) -> String:
	return full_path(_values[p_name])


## The values of an option that names files with commas between; a file whose own name has commas is
## one file.
func files(p_name: String) -> PackedStringArray:
	var paths: PackedStringArray = []
	if FileAccess.file_exists(file(p_name)):
		return [file(p_name)]
	for part: String in text(p_name).split(",", false):
		paths.append(full_path(part))
	return paths


## A path as a full one, see [method file].
static func full_path(p_path: String) -> String:
	if p_path == "" or not p_path.is_relative_path() or p_path.contains("://"):
		return p_path
	return OS.get_environment("PWD").path_join(p_path)


## The value of a whole-number option.
func number(p_name: String) -> int:
	return _values[p_name]


## The value of an option in degrees.
func degrees(p_name: String) -> float:
	return _values[p_name]


## The value of an option in seconds.
func seconds(p_name: String) -> float:
	return _values[p_name]


func _set_option(p_name: String, p_value: String, p_source: String) -> void:
	if not _values.has(p_name):
		_refuse("there is no option --%s" % p_name)
	elif _values[p_name] is int:
		# Longer ones do not fit a number, and the engine reports an error of its own.
		if p_value.is_valid_int() and p_value.length() < 10 and p_value.to_int() >= 0:
			_values[p_name] = p_value.to_int()
		else:
			_refuse("%s expects a whole number, found '%s'" % [p_source, p_value])
	elif _values[p_name] is float:
		var seconds_asked: float = p_value.to_float() if p_value.is_valid_float() else -1.0
		if seconds_asked >= 0.0 and is_finite(seconds_asked):
			_values[p_name] = seconds_asked
		else:
			_refuse("%s expects %s, found '%s'" % [p_source, _unit_of(p_name), p_value])
	else:
		_values[p_name] = p_value
	_check_range("port", "a port", 65535)
	_check_range("bandwidth", "the bandwidth", 1000000)
	_check_range("rate", "a rate", 240)
	if number("snapshot-rate") > 240:
		_refuse("--snapshot-rate is at most 240, found %d" % number("snapshot-rate"))
	# ENet's most, less those that are just arriving.
	_check_range("max-clients", "the number of clients", 4000)
	for name: String in ["trainees", "observers"]:
		if number(name) > LoadRun.MAX_CLIENTS:
			_refuse("--%s is at most %d, found %d" % [name, LoadRun.MAX_CLIENTS, number(name)])
	var error_asked: float = degrees("pose-error")
	var least: float = EntityTableMessage.MIN_ERROR_DEG
	if error_asked < least or error_asked > EntityTableMessage.MAX_ERROR_DEG:
		_refuse("--pose-error is %s to 5 degrees, found %s" % [least, error_asked])
	_check_choice("feedback", ["local", "server"])
	if number("suit-rate") < 10 or number("suit-rate") > 512:
		_refuse("--suit-rate is between 10 and 512, found %d" % number("suit-rate"))
	if number("mvn") > 65535:
		_refuse("--mvn is a UDP port, found %d" % number("mvn"))
	_check_choice("calibrate", [""] + ClientCalibration.KINDS.keys())
	_check_choice("codec", PoseMessage.CODECS.keys())
	_check_choice("smoothing", [""] + SmoothingMethods.BY_NAME.keys())
	if number("fps") > 1000:
		_refuse("--fps is at most 1000, found %d" % number("fps"))


static func _unit_of(p_name: String) -> String:
	return "degrees" if p_name == "pose-error" else "seconds"


func _check_range(p_name: String, p_what: String, p_most: int) -> void:
	if number(p_name) < 1 or number(p_name) > p_most:
		_refuse("%s is between 1 and %d, found %d" % [p_what, p_most, number(p_name)])


func _check_choice(p_name: String, p_known: Array) -> void:
	if not text(p_name) in p_known:
		var known: String = ", ".join(p_known.filter(func(name: String) -> bool: return name != ""))
		_refuse("--%s is one of %s, found '%s'" % [p_name, known, text(p_name)])


func _refuse(p_why: String) -> void:
	if error == "":
		error = p_why

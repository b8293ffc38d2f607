extends SceneTree
## One display of a station, without a picture: frame by frame it agrees with the other one on what
## is shown. Prints a JSON line at the end: moments (µs of the machine's clock) and ticks shown.
##
## Options: --port=PORT of the first display, or of what stands before it; --leads; --fps=N;
## --behind=MS by which its own snapshots come later; --seconds=S.

const RATE: float = 60.0
const FINGERPRINT: int = 4711
const WANDER_MS: float = 4.0

var _sync: StationSync = null
var _moments: Array[float] = []
var _ticks: Array[float] = []
var _leads: bool = false
var _end_s: float = 0.0


func _initialize() -> void:
	_leads = OS.get_cmdline_user_args().has("--leads")
	Engine.max_fps = _number("fps")
	_sync = StationSync.new(FINGERPRINT, _leads)
	var fault: String = _sync.open("127.0.0.1", _number("port"))
	if fault != "":
		printerr(fault)
		quit(2)
	_end_s = Time.get_unix_time_from_system() + _number("seconds")


func _process(_delta: float) -> bool:
	var now: float = Time.get_unix_time_from_system()
	# What it would show by itself: a smoother makes an even time of snapshots, which settles at
	# another delay on each machine, and wanders a little with what its network does.
	var late_s: float = (_number("behind") + WANDER_MS * sin(now + float(_leads))) * 1e-3
	var own: float = (fmod(now, 86400.0) - late_s) * RATE
	var tick: float = _sync.agree(own, Time.get_ticks_usec(), RATE)
	_sync.tell(Transform3D.IDENTITY, Vector3.ZERO, Vector3.RIGHT)
	_moments.append(now * 1e6)
	_ticks.append(tick)
	if now < _end_s:
		return false
	print(JSON.stringify({"moments": _moments, "ticks": _ticks, "report": _sync.report()}))
	_sync.close()
	return true


func _number(p_name: String) -> int:
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with("--%s=" % p_name):
			return argument.get_slice("=", 1).to_int()
	return 0

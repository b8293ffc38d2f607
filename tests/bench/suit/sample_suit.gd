extends SceneTree
## Somebody in a suit on USB who calibrates and then plays a clip: how far the samples of the suit
## are from the clip, degrees, before anything of physics or of a network.
##
## --bvh=FILE --seconds=S --masters=N. Says "ready" as soon as all masters measure, and begins a
## full calibration then. Prints JSON: mean and p95 over all limbs, the spine as that which 17
## sensors tell of it; spine_deg is how far that is from the clip's own; count.

const ClipMatch: GDScript = preload("res://tests/bench/suit/clip_match.gd")
## Until the wearer has come from the calibration's pose into the clip, s.
const PASSAGE_S: float = 3.0
const LIMIT_S: float = 120.0

var _options: Dictionary[String, String] = {}
var _feed: UsbSuitFeed = UsbSuitFeed.new()
var _suit: SuitSource = null
var _match: ClipMatch = ClipMatch.new()
var _fault: String = ""


func _initialize() -> void:
	for argument: String in OS.get_cmdline_user_args():
		var parts: PackedStringArray = argument.trim_prefix("--").split("=", true, 1)
		_options[parts[0]] = parts[1] if parts.size() > 1 else ""
	_match.clip.open(_options.get("bvh", ""))
	_fault = _match.clip.error
	if _fault == "":
		_feed.open(100)
		_fault = _feed.error
	if _fault == "":
		_suit = SuitSource.new(_feed)
		Engine.max_fps = 60
		await _run()
	_feed.close()
	if _fault != "":
		printerr(_fault)
	quit(0 if _fault == "" else 1)


func _run() -> void:
	await _await(_is_complete, "the masters do not measure")
	if _fault != "":
		return
	print("ready")
	_fault = _suit.start_calibration(CalibrationGuide.Kind.FULL, _now_s())
	await _await(func() -> bool: return not _suit.process.is_running(), "no calibration")
	if _fault != "" or _suit.process.result == null or _suit.process.result.error != "":
		_fault = "not calibrated: " + _fault
		return
	_suit.accept_calibration()
	var begin_s: float = _now_s() + PASSAGE_S
	var end_s: float = begin_s + _options.get("seconds", "20").to_float()
	while _now_s() < end_s:
		await process_frame
		var pose: PoseSample = _advance()
		if pose != null and _now_s() > begin_s:
			var turns: Array[Quaternion] = []
			for limb: int in Limbs.COUNT:
				turns.append(pose.orientation(limb))
			_match.times.append(pose.time_usec / 1e6)
			_match.poses.append(turns)
	_print()


func _await(p_is_so: Callable, p_fault: String) -> void:
	var holds: Callable = func() -> bool: return p_is_so.call() or _fault != ""
	if not await Waiting.until(self, holds, _advance, LIMIT_S):
		_fault = p_fault


func _advance() -> PoseSample:
	_feed.advance()
	_suit.advance(_now_s())
	return _suit.sample(roundi(_now_s() * 1e6))


func _is_complete() -> bool:
	var measuring: int = 0
	for device: SuitDevice in _feed.devices:
		measuring += 1 if device.is_measuring() else 0
	var wanted: int = _options.get("masters", "1").to_int()
	return measuring >= wanted and _suit.newest_frame != null


static func _now_s() -> float:
	return Time.get_unix_time_from_system()


func _print() -> void:
	for limb: int in Limbs.COUNT:
		if limb != Limbs.SPINE:
			_match.limbs.append(limb)
	var offset_s: float = _match.best_offset()
	var all: Statistics = Statistics.new()
	var spine: Statistics = Statistics.new()
	for at: int in _match.poses.size():
		var truth: PoseSample = _match.clip.pose_at(_match.times[at] - _match.times[0] + offset_s)
		var filler: LimbFiller = LimbFiller.new()
		for mount: int in BodyMounts.COUNT:
			filler.set_mount(mount, truth.orientation(BodyMounts.LIMBS[mount]))
		filler.fill()
		for limb: int in Limbs.COUNT:
			var turn: Quaternion = _match.poses[at][limb]
			all.add(Rotations.between_deg(turn, filler.limbs[limb]))
			if limb == Limbs.SPINE:
				spine.add(Rotations.between_deg(turn, truth.orientation(limb)))
	var found: Dictionary = {
		"mean": all.mean(),
		"p95": all.percentile(0.95),
		"spine_deg": spine.mean(),
		"count": _match.poses.size(),
	}
	print(JSON.stringify(found))

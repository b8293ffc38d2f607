extends SceneTree
## Writes the motion of an emulated suit's wearer from a BVH file.
##
## [codeblock lang=text]
## godot --headless --path . -s scripts/emulation/write_suit_motion.gd --
##     --bvh=FILE --out=FILE [--rate=HZ] [--unit=U] [--up=y|z]
## [/codeblock]
## Exit code 0; 2 with one line on the error output if the call is wrong or a file cannot be used.

const USAGE: String = "usage: --bvh=FILE --out=FILE [--rate=HZ] [--unit=U] [--up=y|z]"

var _options: Dictionary[String, String] = {"rate": "100", "unit": "", "up": ""}


func _initialize() -> void:
	var fault: String = _write()
	if not fault.is_empty():
		printerr(fault)
	quit(0 if fault.is_empty() else 2)


func _write() -> String:
	for argument: String in OS.get_cmdline_user_args():
		var name: String = argument.get_slice("=", 0).trim_prefix("--")
		if not argument.contains("=") or name not in ["bvh", "out", "rate", "unit", "up"]:
			return "unknown option '%s'; %s" % [argument, USAGE]
		_options[name] = argument.substr(argument.find("=") + 1)
	if not _options.has("bvh") or not _options.has("out"):
		return USAGE
	var motion: SuitMotion = SuitMotion.new()
	motion.rate_hz = _options["rate"].to_float()
	if motion.rate_hz < 10.0 or motion.rate_hz > 1000.0:
		return "a rate is 10 to 1000 Hz, not '%s'" % _options["rate"]
	motion.calibration.kind = CalibrationGuide.Kind.FULL
	motion.clip = BvhSource.new()
	motion.clip.open(_options["bvh"], _options["unit"], _options["up"])
	if motion.clip.error != "":
		return motion.clip.error
	var file: FileAccess = FileAccess.open(_options["out"], FileAccess.WRITE)
	if file == null or not file.store_buffer(motion.encode()):
		return "cannot write %s" % _options["out"]
	return ""

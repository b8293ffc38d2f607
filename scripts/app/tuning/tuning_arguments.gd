class_name TuningArguments
extends RefCounted
## The command line of the tuning scene.

## The clip; empty for the scene's own.
var bvh: String = ""
## Seconds of playing after which it quits; 0 for never.
var duration_s: float = 0.0
## Where a picture of the window goes before it quits.
var screenshot: String = ""
## What is wrong, or an empty text.
var error: String = ""


## Reads [code]--bvh=FILE[/code], [code]--duration=S[/code], [code]--screenshot=FILE[/code].
static func parse(p_arguments: PackedStringArray) -> TuningArguments:
	var made: TuningArguments = TuningArguments.new()
	for argument: String in p_arguments:
		var value: String = argument.get_slice("=", 1) if argument.contains("=") else ""
		if argument.begins_with("--bvh=") and value != "":
			made.bvh = _absolute(argument.trim_prefix("--bvh="))
		elif argument.begins_with("--screenshot=") and value != "":
			made.screenshot = _absolute(argument.trim_prefix("--screenshot="))
		elif argument.begins_with("--duration=") and value.is_valid_float():
			made.duration_s = value.to_float()
		else:
			made.error = (
				"expected --bvh=FILE, --duration=S or --screenshot=FILE, found '%s'" % argument
			)
		if made.duration_s < 0.0 or made.duration_s > 86400.0 or is_nan(made.duration_s):
			made.error = "a duration is 0 to 86400 s, found '%s'" % value
			made.duration_s = 0.0
	if made.screenshot != "" and made.duration_s == 0.0:
		made.duration_s = LimbPlot.SPAN_S
	return made


## Godot changes into the project's folder: relative paths are those of the shell.
static func _absolute(p_path: String) -> String:
	if p_path.is_absolute_path() or p_path.contains("://"):
		return p_path
	return OS.get_environment("PWD").path_join(p_path)

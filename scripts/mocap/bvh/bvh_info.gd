extends SceneTree
## Prints what a BVH file holds.
##
## [codeblock lang=text]
## godot --headless --path . -s scripts/mocap/bvh/bvh_info.gd -- FILE [--unit=U] [--up=y|z]
## [/codeblock]
## U is m, cm, mm, inch, cmu or a number of metres. Exit code 0; 2 with one line on the error output
## if the call is wrong or the file cannot be read.

const USAGE: String = "usage: bvh FILE [--unit=cm|m|mm|inch|cmu|<metres>] [--up=y|z]"

var _path: String = ""
var _options: BvhOptions = BvhOptions.new()


func _initialize() -> void:
	var fault: String = _read_arguments()
	if not fault.is_empty():
		printerr(fault)
		quit(2)
		return
	var result: BvhParser.Result = BvhParser.parse_file(_path, _options)
	if not result.is_ok():
		printerr(result.error)
		quit(2)
		return
	_print_clip(result.clip)
	quit(0)


func _read_arguments() -> String:
	for argument: String in OS.get_cmdline_user_args():
		var choice: String = argument.get_slice("=", 1)
		if argument.begins_with("--unit="):
			_options.unit_metres = BvhOptions.parse_unit(choice)
			if _options.unit_metres <= 0.0:
				return "unknown unit '%s'; %s" % [choice, USAGE]
		elif argument.to_lower() == "--up=y":
			_options.up_axis = BvhOptions.UpAxis.Y
		elif argument.to_lower() == "--up=z":
			_options.up_axis = BvhOptions.UpAxis.Z
		elif argument.begins_with("-"):
			return "unknown option '%s'; %s" % [argument, USAGE]
		elif _path.is_empty():
			_path = argument
		else:
			return "more than one file; %s" % USAGE
	return "no file given; %s" % USAGE if _path.is_empty() else ""


func _print_clip(p_clip: BvhClip) -> void:
	var up: String = "Z" if p_clip.up_axis == BvhOptions.UpAxis.Z else "Y"
	var unit: String = BvhOptions.unit_name(p_clip.unit_metres)
	print("file: %s" % _path)
	print("joints: %d" % p_clip.joint_count())
	print("end_sites: %d" % p_clip.end_site_count())
	print("channels: %d" % p_clip.channel_count)
	print("frames: %d" % p_clip.frame_count)
	print("frame_time: %.6f s" % p_clip.frame_time)
	print("duration: %.2f s" % (p_clip.frame_count * p_clip.frame_time))
	print("unit: %s (%s)" % [unit, p_clip.unit_reason])
	print("up: %s (%s)" % [up, p_clip.up_reason])
	for note: String in p_clip.notes:
		print("note: %s" % note)

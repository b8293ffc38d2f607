extends SceneTree
## Prints what a BVH file holds, and whether it is a person's motion.
##
## [codeblock lang=text]
## godot --headless --path . -s scripts/mocap/bvh/bvh_info.gd -- FILE [--unit=U] [--up=AXIS]
## [/codeblock]
## U is one of [constant BvhOptions.UNITS] or a number of metres, AXIS one of [constant
## BvhOptions.AXES]. Exit code 0; 2 with one line on the error output if the call is wrong, the file
## cannot be read or it shows no person.

const USAGE: String = "usage: bvh FILE [--unit=m|cm|mm|inch|cmu|dm|foot|<metres>] [--up=AXIS]"

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
	var source: BvhSource = BvhSource.new()
	source.use(result.clip)
	_print_clip(result.clip, source)
	if source.error != "":
		printerr(source.error)
	quit(0 if source.error == "" else 2)


func _read_arguments() -> String:
	for argument: String in OS.get_cmdline_user_args():
		var choice: String = argument.get_slice("=", 1)
		if argument.begins_with("--unit="):
			_options.unit_metres = BvhOptions.parse_unit(choice)
			if _options.unit_metres <= 0.0:
				return "unknown unit '%s'; %s" % [choice, USAGE]
		elif argument.begins_with("--up=") and BvhOptions.AXES.has(choice.to_lower()):
			_options.up_axis = BvhOptions.parse_axis(choice)
		elif argument.begins_with("-"):
			return "unknown option '%s'; %s" % [argument, USAGE]
		elif _path.is_empty():
			_path = argument
		else:
			return "more than one file; %s" % USAGE
	return "no file given; %s" % USAGE if _path.is_empty() else ""


func _print_clip(p_clip: BvhClip, p_source: BvhSource) -> void:
	var up: String = BvhOptions.axis_name(p_clip.up_axis)
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
	if p_source.error == "":
		var anatomy: BvhAnatomy = BvhAnatomy.new(p_clip, p_source.rig.map)
		var sizes: Array = [anatomy.stature() * p_clip.unit_metres, p_source.get_hip_height()]
		print("person: %.2f m tall by legs and trunk, hips at %.2f m" % sizes)
	for note: String in p_source.notes:
		print("note: %s" % note)

extends SceneTree
## Makes motion sets and says what is in them.
##
## [codeblock lang=text]
## godot --headless -s scripts/mocap/matching/motion_set_tool.gd -- build TABLE OUT [--clips=FOLDER]
##     [--unit=U]
## godot --headless -s scripts/mocap/matching/motion_set_tool.gd -- show FILE
## [/codeblock]
## Exit code 0; 2 with one line on the error output if the call is wrong or a file is.

const USAGE: String = "usage: motion-set build TABLE OUT [--clips=FOLDER] [--unit=U] | show FILE"
## At which a set is tried, m/s.
const _SPEEDS: PackedFloat32Array = [0.0, 0.8, 1.5, 3.0]

var _words: PackedStringArray = PackedStringArray()
var _clips: String = ""
var _unit: String = ""


func _initialize() -> void:
	var fault: String = _read_arguments()
	if fault == "":
		fault = _build() if _words[0] == "build" else _show()
	if fault != "":
		printerr(fault)
	quit(0 if fault == "" else 2)


func _read_arguments() -> String:
	for argument: String in OS.get_cmdline_user_args():
		var value: String = argument.get_slice("=", 1)
		if argument.begins_with("--clips="):
			_clips = value
		elif argument.begins_with("--unit="):
			_unit = value
			if BvhOptions.parse_unit(value) <= 0.0:
				return "unknown unit '%s'; %s" % [value, USAGE]
		elif argument.begins_with("-"):
			return "unknown option '%s'; %s" % [argument, USAGE]
		else:
			_words.append(argument)
	var is_call: bool = (
		(_words.size() == 3 and _words[0] == "build")
		or (_words.size() == 2 and _words[0] == "show")
	)
	return "" if is_call else USAGE


func _build() -> String:
	if not FileAccess.file_exists(_words[1]):
		return "there is no table %s" % _words[1]
	var text: String = FileAccess.get_file_as_string(_words[1])
	var table: MotionSetTable = MotionSetTable.parse(text, _words[1])
	if table.error != "":
		return table.error
	var builder: MotionSetBuilder = MotionSetBuilder.new()
	builder.add_table(table, _clips if _clips != "" else _words[1].get_base_dir(), _unit)
	if builder.error != "":
		return builder.error
	var fault: String = builder.save(_words[2])
	if fault != "":
		return fault
	_words[1] = _words[2]
	return _show()


func _show() -> String:
	var motion: MotionSet = MotionSet.new()
	var fault: String = motion.load_file(_words[1])
	if fault != "":
		return fault
	var slowest: float = INF
	var fastest: float = 0.0
	var frames: int = 0
	print("clip                  stance  seconds  speed    direction  feet on the ground")
	for clip: int in motion.get_clip_count():
		var count: int = motion.get_clip_frame_count(clip)
		var speed: float = motion.get_clip_speed(clip)
		frames += count
		slowest = minf(slowest, speed)
		fastest = maxf(fastest, speed)
		var row: Array = [
			motion.get_clip_name(clip),
			MotionSetTable.STANCES.find_key(motion.get_clip_stance(clip)),
			count / MotionSetBuilder.RATE,
			speed,
			rad_to_deg(motion.get_clip_travel(clip)),
			roundi(100.0 * motion.get_clip_contact_share(clip)),
		]
		print("%-20s  %-6s  %5.1f s  %.2f h/s  %4.0f deg   %d %%" % row)
	var sums: Array = [
		motion.get_clip_count(),
		frames / MotionSetBuilder.RATE,
		frames,
		motion.get_frame_count(),
		motion.get_searched_count(),
		slowest,
		fastest,
	]
	print(
		"%d clips, %.1f s, %d frames, %d with those that are made, %d searched" % sums.slice(0, 5)
	)
	print("speeds %.2f to %.2f heights of the hips a second" % sums.slice(5))
	print(
		(
			"a search takes %.0f us"
			% (motion.measure_search(500, 1, motion.get_searched_count()) / 1000.0)
		)
	)
	_try(motion)
	return ""


## Says how well a body follows by the set: soles that slide at some speeds.
func _try(p_set: MotionSet) -> void:
	for speed: float in _SPEEDS:
		var matcher: MotionMatcher = MotionMatcher.new()
		matcher.set_motion_set(p_set)
		matcher.reset(Vector3.ZERO, 0.0)
		var slide: SoleSlide = SoleSlide.new()
		var velocity: Vector3 = Vector3(0, 0, speed)
		for tick: int in 600:
			var delta: float = 1.0 / MotionSetBuilder.RATE
			var place: Vector3 = velocity * tick * delta
			matcher.advance(delta, place, velocity, 0.0, velocity, 0.0, MotionMatcher.STAND, true)
			slide.look(matcher.get_soles(), delta)
		var clip: String = matcher.get_clip_name()
		print("at %.1f m/s soles slide by %.1f cm/s (%s)" % [speed, 100.0 * slide.mean(), clip])

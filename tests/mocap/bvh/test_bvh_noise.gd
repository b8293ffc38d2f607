extends TestCase
## Noise is refused with its reason; lively motion is not, at any frame rate.

const CLIPS: PackedStringArray = ["01_01", "01_03", "Boxing_Toes"]
## Frames of noise that are made.
const FRAMES: int = 240

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 11


func test_noise_is_refused() -> void:
	for clip_name: String in CLIPS:
		for kind: String in ["white", "narrow", "steps", "shuffled", "numbers", "tremble"]:
			var fault: String = _fault(_noise(clip_name, kind))
			contains(fault, "deg a frame: this is not motion", "%s, %s" % [clip_name, kind])


func test_smooth_noise_is_refused() -> void:
	for clip_name: String in CLIPS:
		contains(_fault(_noise(clip_name, "waves")), "bend every way", clip_name)


func test_hips_that_jump_are_refused() -> void:
	for clip_name: String in CLIPS:
		contains(_fault(_noise(clip_name, "hips")), "the hips jump by", clip_name)


func test_a_clip_that_plays_too_fast_is_refused() -> void:
	var clip: BvhClip = _clip("Boxing_Toes")
	clip.set_data(clip.joints, clip.values, clip.frame_time / 30.0)
	contains(_fault(clip), "the frame time is wrong")


func test_places_that_leap_are_refused() -> void:
	var clip: BvhClip = _clip("01_03")
	var values: PackedFloat64Array = clip.values
	for frame: int in [500, 900, 1300]:
		values[frame * clip.channel_count] += 2000.0
	clip.set_data(clip.joints, values, clip.frame_time)
	contains(_fault(clip), "the file is damaged")


func test_motion_is_not() -> void:
	for clip_name: String in CLIPS:
		for rate: float in [120.0, 60.0, 30.0, 15.0, 10.0, 6.0]:
			var clip: BvhClip = _clip(clip_name)
			var step: int = maxi(roundi(1.0 / rate / clip.frame_time), 1)
			var values: PackedFloat64Array = []
			for frame: int in range(0, clip.frame_count, step):
				values.append_array(_row(clip, frame))
			clip.set_data(clip.joints, values, clip.frame_time * step)
			equal(_fault(clip), "", "%s at %.0f Hz" % [clip_name, rate])


func _fault(p_clip: BvhClip) -> String:
	var source: BvhSource = BvhSource.new()
	source.use(p_clip)
	return source.error


func _clip(p_name: String) -> BvhClip:
	return BvhParser.parse_file("res://assets/motion/%s.bvh" % p_name).clip


func _row(p_clip: BvhClip, p_frame: int) -> PackedFloat64Array:
	var start: int = p_frame * p_clip.channel_count
	return p_clip.values.slice(start, start + p_clip.channel_count)


func _noise(p_name: String, p_kind: String) -> BvhClip:
	var clip: BvhClip = _clip(p_name)
	var is_turn: Array[bool] = []
	for joint: BvhJoint in clip.joints:
		for channel: int in joint.channels:
			is_turn.append(BvhJoint.is_rotation(channel))
	var values: PackedFloat64Array = []
	var row: PackedFloat64Array = _row(clip, 100)
	for frame: int in FRAMES:
		var source: int = _random.randi_range(0, clip.frame_count - 1)
		var next: PackedFloat64Array = _row(clip, source if p_kind == "shuffled" else frame)
		for column: int in row.size():
			next[column] = _number(
				p_kind, is_turn[column], next[column], row[column], column, frame
			)
		row = next
		values.append_array(next)
	clip.set_data(clip.joints, values, 1.0 / 60.0)
	return clip


func _number(
	p_kind: String, p_is_turn: bool, p_true: float, p_last: float, p_column: int, p_frame: int
) -> float:
	if p_kind == "numbers":
		return _random.randf_range(-1000.0, 1000.0)
	if p_kind == "hips":
		return p_true if p_is_turn else p_true + _random.randf_range(-30.0, 30.0)
	if not p_is_turn:
		return p_true
	match p_kind:
		"white":
			return _random.randf_range(-180.0, 180.0)
		"narrow":
			return _random.randf_range(-30.0, 30.0)
		"steps":
			return p_last + _random.randfn(0.0, 5.0)
		"tremble":
			return p_true + _random.randfn(0.0, 3.0)
		"waves":
			return 120.0 * sin(p_frame * (0.05 + 0.013 * (p_column * 7 % 11)) + p_column)
	return p_true

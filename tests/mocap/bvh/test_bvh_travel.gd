extends TestCase
## Files whose positions alone are mirrored are put right, and no others.

const NOTE: String = "the way was mirrored back"


func test_mirrored_ways_are_mirrored_back() -> void:
	for axes: Array in [[0], [2], [0, 2]]:
		var truth: BvhClip = _clip()
		var clip: BvhClip = _clip()
		_mirror(clip, axes)
		BvhGuess.settle(clip, BvhOptions.new())
		contains("\n".join(clip.notes), NOTE, str(axes))
		for frame: int in range(0, clip.frame_count, 500):
			var way: Vector3 = clip.root_position(frame) - clip.root_position(0)
			var wanted: Vector3 = truth.root_position(frame) - truth.root_position(0)
			almost_equal(way, wanted, 1e-3, str(axes))


func test_true_ways_are_left_alone() -> void:
	for clip_name: String in ["01_01", "01_03", "Boxing_Toes"]:
		var clip: BvhClip = BvhParser.parse_file("res://assets/motion/%s.bvh" % clip_name).clip
		is_false("\n".join(clip.notes).contains(NOTE), clip_name)


func _clip() -> BvhClip:
	return BvhParser.parse_file("res://assets/motion/01_03.bvh").clip


func _mirror(p_clip: BvhClip, p_axes: Array) -> void:
	var values: PackedFloat64Array = p_clip.values
	for axis: int in p_axes:
		var column: int = p_clip.joints[0].channels.find(axis)
		for frame: int in p_clip.frame_count:
			values[frame * p_clip.channel_count + column] *= -1.0
	p_clip.set_data(p_clip.joints, values, p_clip.frame_time)

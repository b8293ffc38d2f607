extends TestCase
## What BvhWriter writes is read back to the same clip.

const Samples: GDScript = preload("res://tests/mocap/bvh/bvh_samples.gd")


func test_text_of_a_small_clip() -> void:
	var clip: BvhClip = BvhParser.parse_text(Samples.SIMPLE).clip
	var lines: PackedStringArray = BvhWriter.to_text(clip, 1).split("\n")
	equal(lines[3], "\tOFFSET 0.0 0.0 0.0")
	equal(lines[8], "\t\tCHANNELS 3 Zrotation Xrotation Yrotation")
	equal(lines[9], "\t\tEnd Site")
	equal(lines[25], "Frames: 3")
	equal(lines[28], "1.5 90.0 0.0 90.0 0.0 0.0 0.0 0.0 0.0 45.0")
	equal(lines.size(), 31)


func test_random_clips_survive() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 20080901
	for round_number: int in 300:
		var clip: BvhClip = Samples.random_clip(random)
		var result: BvhParser.Result = BvhParser.parse_text(BvhWriter.to_text(clip), "random.bvh")
		equal(result.error, "", "round %d" % round_number)
		if not result.is_ok():
			continue
		_is_same(clip, result.clip)
		equal(BvhWriter.to_text(result.clip), BvhWriter.to_text(clip))


func test_a_long_clip_survives() -> void:
	var clip: BvhClip = BvhParser.parse_file("res://assets/motion/01_01.bvh").clip
	var again: BvhClip = BvhParser.parse_text(BvhWriter.to_text(clip)).clip
	equal(again.values, clip.values)


func test_saves_a_file() -> void:
	var path: String = "user://saved.bvh"
	var clip: BvhClip = BvhParser.parse_text(Samples.SIMPLE).clip
	equal(BvhWriter.save(clip, path), OK)
	equal(BvhParser.parse_file(path).clip.values, clip.values)
	equal(BvhWriter.save(clip, "user://no_such_folder/saved.bvh"), ERR_FILE_NOT_FOUND)


func _is_same(p_clip: BvhClip, p_again: BvhClip) -> void:
	equal(p_again.joints.size(), p_clip.joints.size())
	for index: int in p_clip.joints.size():
		var joint: BvhJoint = p_clip.joints[index]
		var other: BvhJoint = p_again.joints[index]
		equal(other.name, joint.name)
		equal(other.parent, joint.parent)
		equal(other.channels, joint.channels)
		equal(other.is_end_site, joint.is_end_site)
		almost_equal(other.offset, joint.offset, 1e-5)
	equal(p_again.frame_count, p_clip.frame_count)
	almost_equal(p_again.frame_time, p_clip.frame_time, 1e-9)
	almost_equal(p_again.values, p_clip.values, 6e-7)

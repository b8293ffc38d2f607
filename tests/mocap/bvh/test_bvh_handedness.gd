extends TestCase
## Mirrored motion files are mirrored back, and no others.

const CLIPS: PackedStringArray = ["01_01", "01_03", "Boxing_Toes"]
const NOTE: String = "it was mirrored"


func test_true_files_are_left_alone() -> void:
	for clip_name: String in CLIPS:
		var clip: BvhClip = _clip(clip_name)
		equal(_notes(clip), 0, clip_name)
		# Somebody who walks backwards faces forward.
		_reverse(clip)
		BvhGuess.settle(clip, BvhOptions.new())
		equal(_notes(clip), 0, clip_name + " backwards")


func test_a_mirrored_file_moves_as_the_true_one() -> void:
	for clip_name: String in CLIPS:
		for axis: int in 3:
			var clip: BvhClip = _clip(clip_name)
			var truth: BvhRig = BvhRig.from_clip(_clip(clip_name))
			_mirror(clip, axis)
			BvhGuess.settle(clip, BvhOptions.new())
			var note: String = "%s mirrored along %s" % [clip_name, "XYZ"[axis]]
			equal(_notes(clip), 1, note)
			var rig: BvhRig = BvhRig.from_clip(clip)
			equal(rig.error, "", note)
			_compare(rig, truth, note)


func test_names_in_another_language_tell_too() -> void:
	var sides: Dictionary[String, String] = {"Left": "левая ", "Right": "правая "}
	var clip: BvhClip = _clip("01_03")
	for joint: BvhJoint in clip.joints:
		for side: String in sides:
			if joint.name.begins_with(side):
				joint.name = sides[side] + "часть"
	_mirror(clip, 0)
	BvhGuess.settle(clip, BvhOptions.new())
	equal(_notes(clip), 1)


## Both rigs play the same motion, wherever they stand and whichever way they begin.
func _compare(p_rig: BvhRig, p_truth: BvhRig, p_note: String) -> void:
	for share: float in [0.2, 0.5, 0.9]:
		var time: float = share * p_truth.clip.duration()
		var hips: Quaternion = p_rig.limb_rotation(Limbs.HIPS, time).inverse()
		var true_hips: Quaternion = p_truth.limb_rotation(Limbs.HIPS, time).inverse()
		for limb: int in Limbs.COUNT:
			var turn: Quaternion = hips * p_rig.limb_rotation(limb, time)
			var wanted: Quaternion = true_hips * p_truth.limb_rotation(limb, time)
			is_true(turn.angle_to(wanted) < deg_to_rad(1.0), "%s: %s" % [p_note, Limbs.BONES[limb]])
		# And goes the same way, as its wearer sees it.
		var way: Vector3 = hips * (p_rig.hips_position(time + 0.1) - p_rig.hips_position(time))
		var next: Vector3 = p_truth.hips_position(time + 0.1) - p_truth.hips_position(time)
		almost_equal(way, true_hips * next, 2e-3, p_note)


func _clip(p_name: String) -> BvhClip:
	return BvhParser.parse_file("res://assets/motion/%s.bvh" % p_name).clip


func _notes(p_clip: BvhClip) -> int:
	var count: int = 0
	for note: String in p_clip.notes:
		count += 1 if note.contains(NOTE) else 0
	return count


## As a program with a left-handed axis writes it.
func _mirror(p_clip: BvhClip, p_axis: int) -> void:
	var values: PackedFloat64Array = p_clip.values
	for joint: BvhJoint in p_clip.joints:
		joint.offset[p_axis] *= -1.0
		for position: int in joint.channels.size():
			var channel: int = joint.channels[position]
			if (channel < 3) != (channel % 3 == p_axis):
				continue
			for frame: int in p_clip.frame_count:
				values[frame * p_clip.channel_count + joint.first_channel + position] *= -1.0
	p_clip.set_data(p_clip.joints, values, p_clip.frame_time)


func _reverse(p_clip: BvhClip) -> void:
	var values: PackedFloat64Array = []
	for frame: int in p_clip.frame_count:
		var start: int = (p_clip.frame_count - 1 - frame) * p_clip.channel_count
		values.append_array(p_clip.values.slice(start, start + p_clip.channel_count))
	p_clip.set_data(p_clip.joints, values, p_clip.frame_time)

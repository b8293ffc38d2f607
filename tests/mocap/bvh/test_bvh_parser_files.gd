extends TestCase
## Whole files: the thesis's example, Carnegie Mellon's clips, and hand-made odd ones.
##
## The places in Carnegie Mellon's clips are those of its skeleton and motion (ASF, AMC), by other
## matrices than those of the converter and of the reader.

const DATA: String = "res://tests/data/bvh/"
const MOTION: String = "res://assets/motion/"


func test_example_of_the_thesis() -> void:
	var clip: BvhClip = _clip(DATA + "thesis_example.bvh")
	equal(clip.joint_count(), 18)
	equal(clip.end_site_count(), 5)
	equal(clip.channel_count, 57)
	equal(clip.frame_count, 2)
	equal(clip.frame_time, 0.033333)
	equal(BvhOptions.unit_name(clip.unit_metres), "inch")
	# The thesis prints each joint's own rotation, the inverse of ours by its convention. Only the
	# collar can be compared: where X is not 0 the printed quaternions are not of length 1.
	var collar: int = clip.find_joint("LeftCollar")
	var wanted: Array[Quaternion] = [
		Quaternion(-0.0078171064286399, 0.088637181342426, 0.087502717571974, 0.99218225006713),
		Quaternion(-0.006021618823607, 0.035791871462232, 0.16579892649827, 0.98549144999639)
	]
	for frame: int in 2:
		var parent: Quaternion = clip.global_orientation(frame, clip.joints[collar].parent)
		var own: Quaternion = parent.inverse() * clip.global_orientation(frame, collar)
		almost_equal(own, wanted[frame], 1e-6)
	almost_equal(clip.root_position(0), Vector3(8.03, 35.01, 88.36) * 0.0254)
	almost_equal(
		clip.global_orientation(0, 0),
		Quaternion(-0.011727655, -0.982545566, -0.131385659, 0.131165852),
		1e-6
	)


func test_carnegie_mellon_01_01() -> void:
	var clip: BvhClip = _clip(MOTION + "01_01.bvh")
	_has_shape(clip, [31, 7, 96, 2751], 0.0083333, "CMU")
	equal(clip.value(0, 0, 0), 9.3722)
	equal(clip.value(2750, 0, 1), clip.values[2750 * 96 + 1])
	var pose: BvhClip.Pose = clip.sample_global(999)
	_is_at(clip, pose, "Head", Vector3(0.517871, 1.558010, 2.596996))
	_is_at(clip, pose, "LeftHand", Vector3(0.756268, 1.009200, 2.590419))
	_is_at(clip, pose, "RightFoot", Vector3(0.397291, 0.112782, 2.439968))
	almost_equal(
		pose.orientations[clip.find_joint("Head")],
		Quaternion(0.029161, -0.627491, 0.060461, 0.775725),
		2e-6
	)
	_stands(clip)


func test_carnegie_mellon_01_03() -> void:
	var clip: BvhClip = _clip(MOTION + "01_03.bvh")
	_has_shape(clip, [31, 7, 96, 4510], 0.0083333, "CMU")
	var pose: BvhClip.Pose = clip.sample_global(4509)
	_is_at(clip, pose, "Head", Vector3(-0.222823, 1.515252, 0.694836))
	_is_at(clip, pose, "RightFoot", Vector3(-0.298187, 0.133417, 0.832372))
	almost_equal(
		pose.orientations[clip.find_joint("LeftHand")],
		Quaternion(0.374692, -0.321433, 0.479044, -0.725813),
		2e-6
	)
	_stands(clip)


func test_carnegie_mellon_boxing() -> void:
	var clip: BvhClip = _clip(MOTION + "Boxing_Toes.bvh")
	_has_shape(clip, [21, 5, 66, 3069], 0.01, "centimetre")
	equal(
		clip.notes,
		PackedStringArray(
			["Boxing_Toes.bvh:128: 3069 frames declared, 3070 found; the last one is left out"]
		)
	)
	var pose: BvhClip.Pose = clip.sample_global(2000)
	_is_at(clip, pose, "Head", Vector3(-0.001924, 1.301835, 0.630635))
	almost_equal(
		pose.orientations[clip.find_joint("Head")],
		Quaternion(0.251635, -0.959339, 0.122922, 0.035201),
		2e-6
	)
	_stands(clip)


func test_exporter_mess() -> void:
	var clip: BvhClip = _clip(DATA + "exporter_mess.bvh")
	var names: PackedStringArray = PackedStringArray()
	for joint: BvhJoint in clip.joints:
		names.append(joint.name)
	var wanted: PackedStringArray = ["mixamorig:Hips", "Bip01 L Thigh", "Left Toe Tip"]
	wanted.append_array(["Left Arm#1", "", ""])
	equal(names, wanted)
	equal(clip.joints[0].offset, Vector3(0, 1, 0))
	equal(clip.joints[3].channels.size(), 0)
	equal(clip.frame_time, 0.5)
	equal(clip.values, PackedFloat64Array([1, 0, 0, 90, 0, 0, 45, 1, 0.5, 0, -90, 0, 0, -45]))
	equal(clip.joints[0].channels[0], BvhJoint.Channel.Y_POSITION)


func test_old_mac_line_endings() -> void:
	equal(_clip(DATA + "old_mac.bvh").values, PackedFloat64Array([5]))


func test_wrapped_rows() -> void:
	var clip: BvhClip = _clip(DATA + "wrapped_rows.bvh")
	equal(clip.frame_count, 4)
	equal(clip.value(2, 0, 1), 8.0)


func test_z_up_metres() -> void:
	var clip: BvhClip = _clip(DATA + "z_up_metres.bvh")
	equal(clip.up_axis, BvhOptions.UpAxis.Z)
	equal(clip.unit_metres, 1.0)
	almost_equal(clip.root_position(0), Vector3(1, 0.9, -2))
	var pose: BvhClip.Pose = clip.sample_global(0)
	almost_equal(pose.positions[clip.find_joint("Head")], Vector3(1, 1.6, -2))
	# Turned by 90 degrees about the file's Z, so about Godot's Y.
	almost_equal(pose.positions[clip.find_joint("LeftFoot")], Vector3(1, 0, -2.1))
	almost_equal(pose.orientations[0], Quaternion(Vector3.UP, PI / 2))


func test_names_beyond_ascii() -> void:
	equal(_clip(DATA + "latin1_name.bvh").joints[0].name, "Hüfte")
	equal(_clip(DATA + "utf8_name.bvh").joints[0].name, "腰")


func _clip(p_path: String) -> BvhClip:
	var result: BvhParser.Result = BvhParser.parse_file(p_path)
	equal(result.error, "")
	return result.clip


func _has_shape(p_clip: BvhClip, p_counts: Array[int], p_time: float, p_unit: String) -> void:
	var counts: Array[int] = [p_clip.joint_count(), p_clip.end_site_count()]
	counts.append_array([p_clip.channel_count, p_clip.frame_count])
	equal(counts, p_counts)
	equal(p_clip.frame_time, p_time)
	equal(BvhOptions.unit_name(p_clip.unit_metres), p_unit)
	equal(p_clip.up_axis, BvhOptions.UpAxis.Y)


func _is_at(p_clip: BvhClip, p_pose: BvhClip.Pose, p_joint: String, p_place: Vector3) -> void:
	almost_equal(p_pose.positions[p_clip.find_joint(p_joint)], p_place, 1e-5, p_joint)


func _stands(p_clip: BvhClip) -> void:
	var lowest: float = INF
	var highest: float = -INF
	for frame: int in range(0, p_clip.frame_count, 50):
		for place: Vector3 in p_clip.sample_global(frame).positions:
			lowest = minf(lowest, place.y)
			highest = maxf(highest, place.y)
	is_true(lowest > -0.3 and lowest < 0.2, "lowest point %s m" % lowest)
	is_true(highest > 1.4 and highest < 3.0, "highest point %s m" % highest)

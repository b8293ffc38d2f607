extends TestCase
## Orientations, positions, frames and units of BvhClip, and the guesses.

const Samples: GDScript = preload("bvh_samples.gd")


func test_rest_pose_in_metres() -> void:
	var clip: BvhClip = _clip(Samples.SIMPLE)
	equal(clip.unit_metres, 0.01)
	almost_equal(
		clip.rest_positions(),
		[
			Vector3.ZERO,
			Vector3(0, 0.5, 0),
			Vector3(0, 0.9, 0),
			Vector3(0.1, 0, 0),
			Vector3(0.1, -0.9, 0)
		]
	)
	almost_equal(clip.rest_offset(4), Vector3(0, -0.9, 0))


func test_positions_follow_the_rotations() -> void:
	var pose: BvhClip.Pose = _clip(Samples.SIMPLE).sample_global(1)
	# The hips turn by 90 degrees about Z: up becomes -X. The leg then turns by 45 about its X.
	var hips: Vector3 = Vector3(0.015, 0.9, 0)
	almost_equal(pose.positions[0], hips)
	almost_equal(pose.positions[2], hips + Vector3(-0.9, 0, 0))
	almost_equal(pose.positions[3], hips + Vector3(0, 0.1, 0))
	var foot: Vector3 = Vector3(0.9 * sqrt(0.5), 0.1, -0.9 * sqrt(0.5))
	almost_equal(pose.positions[4], hips + foot)
	almost_equal(pose.orientations[1], Quaternion(Vector3.BACK, PI / 2))
	equal(pose.orientations[4], pose.orientations[3], "an end site turns with its parent")


func test_rotations_compose_in_the_order_of_the_channels() -> void:
	var orders: Dictionary[String, int] = {
		"Xrotation Yrotation Zrotation": EULER_ORDER_XYZ,
		"Xrotation Zrotation Yrotation": EULER_ORDER_XZY,
		"Yrotation Xrotation Zrotation": EULER_ORDER_YXZ,
		"Yrotation Zrotation Xrotation": EULER_ORDER_YZX,
		"Zrotation Xrotation Yrotation": EULER_ORDER_ZXY,
		"Zrotation Yrotation Xrotation": EULER_ORDER_ZYX,
	}
	for order: String in orders:
		var angles: Dictionary[String, float] = {"X": 20.0, "Y": -50.0, "Z": 130.0}
		var row: PackedStringArray = PackedStringArray()
		for channel: String in order.split(" "):
			row.append(str(angles[channel[0]]))
		var clip: BvhClip = _one_joint("3 " + order, " ".join(row))
		var radians: Vector3 = Vector3(20, -50, 130) * (PI / 180.0)
		var wanted: Basis = Basis.from_euler(radians, orders[order])
		almost_equal(clip.global_orientation(0, 0), wanted.get_rotation_quaternion(), 1e-6, order)


func test_one_axis_twice() -> void:
	var clip: BvhClip = _one_joint("3 Zrotation Xrotation Zrotation", "90 90 90")
	var turn: Quaternion = Quaternion(Vector3.BACK, PI / 2)
	var wanted: Quaternion = turn * Quaternion(Vector3.RIGHT, PI / 2) * turn
	almost_equal(clip.global_orientation(0, 0), wanted)


func test_half_way_between_frames() -> void:
	var clip: BvhClip = _clip(Samples.SIMPLE)
	var pose: BvhClip.Pose = clip.sample_at(0.25)
	almost_equal(pose.positions[0], Vector3(0.0075, 0.9, 0))
	almost_equal(pose.orientations[0], Quaternion(Vector3.BACK, PI / 4))
	almost_equal(pose.positions[2].distance_to(pose.positions[0]), 0.9, 1e-6, "bones keep length")
	almost_equal(clip.sample_at(0.5).positions, clip.sample_global(1).positions)


func test_ends_stay() -> void:
	var clip: BvhClip = _clip(Samples.SIMPLE)
	equal(clip.sample_at(-5.0).positions, clip.sample_global(0).positions)
	equal(clip.sample_at(99.0).positions, clip.sample_global(2).positions)
	equal(clip.sample_global(99).positions, clip.sample_global(2).positions)
	equal(clip.root_position(-1), clip.root_position(0))


func test_a_given_pose_is_filled() -> void:
	var clip: BvhClip = _clip(Samples.SIMPLE)
	var pose: BvhClip.Pose = BvhClip.Pose.new()
	equal(clip.sample_at(0.3, pose), pose)
	equal(pose.positions, clip.sample_at(0.3).positions)


func test_quaternions_never_jump() -> void:
	var rows: PackedStringArray = PackedStringArray()
	for degrees: int in range(0, 1441, 10):
		rows.append(str(wrapi(degrees, -180, 180)))
	var clip: BvhClip = _one_joint("1 Yrotation", "\n".join(rows))
	for frame: int in range(1, clip.frame_count):
		var before: Quaternion = clip.global_orientation(frame - 1, 0)
		is_true(before.dot(clip.global_orientation(frame, 0)) > 0.99)


func test_z_up_is_turned() -> void:
	var text: String = Samples.SIMPLE
	var clip: BvhClip = _clip(text)
	clip.prepare()
	clip.up_axis = BvhOptions.UpAxis.Z
	var turn: Quaternion = Quaternion(Vector3.RIGHT, -PI / 2)
	var y_up: BvhClip.Pose = _clip(text).sample_global(1)
	var z_up: BvhClip.Pose = clip.sample_global(1)
	for joint: int in clip.joints.size():
		almost_equal(z_up.positions[joint], turn * y_up.positions[joint])
		almost_equal(z_up.orientations[joint], turn * y_up.orientations[joint] * turn.inverse())


func test_position_channels_replace_the_offset_or_add_to_it() -> void:
	var path: String = "res://tests/data/bvh/joint_positions.bvh"
	var options: BvhOptions = BvhOptions.new()
	options.unit_metres = 1.0
	options.up_axis = BvhOptions.UpAxis.Y
	var pose: BvhClip.Pose = BvhParser.parse_file(path, options).clip.sample_global(0)
	almost_equal(
		pose.positions, [Vector3(5, 90, 7), Vector3(6, 150, 10), Vector3(6, 150, 40)], 1e-4
	)
	options.positions_add_offset = true
	pose = BvhParser.parse_file(path, options).clip.sample_global(0)
	almost_equal(
		pose.positions, [Vector3(5, 190, 7), Vector3(6, 300, 10), Vector3(6, 300, 60)], 1e-4
	)


func test_guesses_the_unit() -> void:
	var units: Dictionary[String, float] = {
		"metre": 1.0, "centimetre": 0.01, "millimetre": 0.001, "inch": 0.0254, "CMU": 0.0254 / 0.45
	}
	for unit: String in units:
		for height: float in [1.5, 1.8, 2.0]:
			var text: String = _person(height / units[unit])
			var clip: BvhClip = _clip(text)
			almost_equal(clip.unit_metres, units[unit], 1e-9, unit)
			equal(clip.up_axis, BvhOptions.UpAxis.Y, "narrow, but taller than deep")
			equal(BvhOptions.unit_name(clip.unit_metres), unit)
	var reason: String = _clip(_person(180.0)).unit_reason
	equal(
		reason,
		"guess: the rest pose spans 180.0 units, so 1.80 m, of all units the nearest to 1.7 m"
	)


func test_a_skeleton_without_size() -> void:
	var clip: BvhClip = _one_joint("1 Xrotation", "1")
	equal(clip.unit_metres, 0.01)
	contains(clip.unit_reason, "no size")
	equal(clip.up_axis, BvhOptions.UpAxis.Y)


func test_options_overrule_the_guess() -> void:
	var options: BvhOptions = BvhOptions.new()
	options.unit_metres = BvhOptions.parse_unit("inch")
	options.up_axis = BvhOptions.UpAxis.Z
	var clip: BvhClip = BvhParser.parse_text(Samples.SIMPLE, "x", options).clip
	equal(clip.unit_metres, 0.0254)
	equal(clip.up_axis, BvhOptions.UpAxis.Z)
	equal(clip.unit_reason, "as given")
	equal(clip.up_reason, "as given")
	almost_equal(clip.root_position(0), Vector3(0, 0, -90 * 0.0254))


func test_unit_names() -> void:
	equal(BvhOptions.parse_unit("CM"), 0.01)
	equal(BvhOptions.parse_unit("0.3"), 0.3)
	for bad: String in ["", "x", "-1", "0", "nan", "inf", "1e99"]:
		equal(BvhOptions.parse_unit(bad), 0.0, bad)
	equal(BvhOptions.unit_name(0.3), "0.3 m")


func _person(p_height: float) -> String:
	var text: String = "HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n"
	text += "End Site {OFFSET 0 %f 0.1}\nEnd Site {OFFSET 0 %f 0}\n}\n"
	return text % [p_height * 0.5, p_height * -0.5] + "MOTION\nFrames: 1\nFrame Time: 1\n0\n"


func _one_joint(p_channels: String, p_rows: String) -> BvhClip:
	var text: String = "HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\nCHANNELS %s\n}\nMOTION\n" % p_channels
	text += "Frames: %d\nFrame Time: 1\n%s\n" % [p_rows.split("\n").size(), p_rows]
	return _clip(text)


func _clip(p_text: String) -> BvhClip:
	var result: BvhParser.Result = BvhParser.parse_text(p_text, "clip.bvh")
	equal(result.error, "")
	return result.clip

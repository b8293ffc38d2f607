extends TestCase
## Frames of sensors become poses.


func test_a_frame_that_waited_while_newer_ones_came_is_a_pose_too() -> void:
	var feed: WornSensorFeed = WornSensorFeed.new()
	var profile: PersonProfile = PersonProfile.new()
	profile.calibration = Calibration.new()
	for mount: int in BodyMounts.COUNT:
		var id: String = BodyMounts.NAMES[mount]
		feed.add_sensor(mount, Quaternion.IDENTITY, 0.0, id)
		profile.map.assign(id, mount)
		profile.calibration.set_entry(id, mount, 0.0, Quaternion.IDENTITY)
	var pose: PoseSample = CalibrationGuide.countdown(ResetPose.Kind.N).pose_at(0.0)
	feed.measure(pose, 1000000)
	feed.measure(pose, 4000000)
	var frames: Array[SensorFrame] = feed.take_frames()
	var table: SuitTable = SuitTable.new()
	table.setup(feed.list_sensors(), profile)
	table.remember(frames[1])
	var found: PoseSample = table.pose(frames[0])
	not_null(found)
	var arm: int = Limbs.LEFT_LOWER_ARM
	almost_equal(found.orientation(arm), pose.orientation(arm), 1e-5)
	equal(found.details.measured.count(1), Limbs.COUNT - 1, "all but the waist")

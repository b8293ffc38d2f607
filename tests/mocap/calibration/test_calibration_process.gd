extends TestCase
## The guided calibration: its steps, its judgement, and that the old one stays in force.

const Wearer: GDScript = preload("wearer.gd")

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 7


func test_steps_and_their_times() -> void:
	var process: CalibrationProcess = CalibrationProcess.new()
	var wearer: Wearer = _wearer(0.0)
	var seen: PackedStringArray = []
	var note: Callable = func(p_phase: int) -> void: seen.append(str(p_phase))
	process.phase_changed.connect(note)
	var kind: CalibrationGuide.Kind = CalibrationGuide.Kind.T_TO_N
	equal(process.start(kind, wearer.feed.list_sensors(), wearer.mounts, null, 5.0), "")
	almost_equal(process.seconds_left, 3.0)
	contains(process.instruction(), "arms straight out")
	process.advance(7.5)
	almost_equal(process.seconds_left, 0.5)
	almost_equal(process.progress(), 0.25)
	process.advance(8.0)
	equal(process.phase, CalibrationProcess.Phase.HOLD)
	process.advance(10.1)
	equal(process.phase, CalibrationProcess.Phase.MOVE)
	contains(process.instruction(), "Bring both arms down")
	process.advance(13.0)
	contains(process.instruction(), "arms hanging")
	process.advance(15.0)
	equal(process.phase, CalibrationProcess.Phase.DONE)
	equal(", ".join(seen), "1, 2, 3, 2, 4")
	contains(process.result.error, "no sensor said anything")
	process.close()
	equal(process.phase, CalibrationProcess.Phase.IDLE)


func test_redone_while_playing_within_10_s() -> void:
	for kind: CalibrationGuide.Kind in [
		CalibrationGuide.Kind.T_POSE,
		CalibrationGuide.Kind.N_POSE,
		CalibrationGuide.Kind.T_TO_N,
		CalibrationGuide.Kind.QUICK
	]:
		is_true(CalibrationGuide.duration_s(kind) <= 10.0)
	equal(CalibrationGuide.duration_s(CalibrationGuide.Kind.QUICK), 1.0)


func test_cancelled_and_started_again() -> void:
	var wearer: Wearer = _wearer(0.0)
	var process: CalibrationProcess = wearer.process
	var sensors: Array[SensorInfo] = wearer.feed.list_sensors()
	process.start(CalibrationGuide.Kind.T_POSE, sensors, wearer.mounts, null, 0.0)
	process.advance(4.0)
	process.cancel()
	equal(process.phase, CalibrationProcess.Phase.IDLE)
	process.advance(100.0)
	is_null(process.result)
	not_null(wearer.calibrate(CalibrationGuide.Kind.T_TO_N).calibration)
	is_true(process.result.is_good(), ", ".join(process.result.advice))


func test_nothing_to_calibrate() -> void:
	var process: CalibrationProcess = CalibrationProcess.new()
	var kind: CalibrationGuide.Kind = CalibrationGuide.Kind.T_POSE
	contains(process.start(kind, [], PackedInt32Array(), null, 0.0), "no sensors")
	var feed: WornSensorFeed = WornSensorFeed.new()
	feed.add_sensor(0)
	contains(process.start(kind, feed.list_sensors(), PackedInt32Array([-1]), null, 0.0), "mount")
	equal(process.phase, CalibrationProcess.Phase.IDLE)


func test_who_moves_is_named() -> void:
	for mount: int in [BodyMounts.HEAD, 5, 12]:
		var wearer: Wearer = _wearer(0.0)
		wearer.motion.sways_deg[mount] = 2.0
		var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.T_POSE)
		is_false(result.is_good())
		var quality: CalibrationResult.PlaceQuality = result.find(mount)
		almost_equal(quality.movement_deg, 4.0, 0.4)
		equal(quality.grade(), "moved")
		var title: String = BodyMounts.title(mount)
		equal(result.advice[0], "%s moved 4° during the pose: again?" % title)
		for other: CalibrationResult.PlaceQuality in result.mounts:
			equal(other.mount == mount, other.movement_deg > 1.0)


func test_a_still_wearer_with_noisy_sensors_is_still() -> void:
	var wearer: Wearer = _wearer(0.0)
	wearer.feed.noise_deg = 1.0
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.T_TO_N)
	is_true(result.is_good(), ", ".join(result.advice))
	equal(result.word(), "good")
	for quality: CalibrationResult.PlaceQuality in result.mounts:
		is_true(quality.movement_deg < CalibrationResult.MOVED_DEG)


func test_silent_sensors_are_named() -> void:
	var wearer: Wearer = _wearer(0.0)
	wearer.feed.silent = [5]
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.T_POSE)
	contains(result.advice, "left forearm: sensor 00300006 says nothing")
	equal(result.find(5).grade(), "missing")
	is_false(result.calibration.entries.has("00300006"))
	is_true(result.calibration.entries.has("00300005"))


func test_arms_that_do_not_come_down() -> void:
	var wearer: Wearer = _wearer(0.0)
	wearer.motion.effort = 0.0
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.T_TO_N)
	contains(", ".join(result.advice), "the arms' movement was not seen")


func test_the_other_pose_tells_who_is_off() -> void:
	var wearer: Wearer = _wearer(0.0)
	wearer.motion.effort = 0.7
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.T_TO_N)
	equal(result.find(4).grade(), "off")
	almost_equal(result.find(4).residual_deg, 27.0, 0.2)
	almost_equal(result.find(BodyMounts.PELVIS).residual_deg, 0.0, 0.01)
	contains(", ".join(result.advice), "left upper arm was 27° away")


func test_arms_that_come_down_ahead_on_both_sides() -> void:
	# In the T-pose both arms point ahead by 15 degrees, which turns their axes against each other.
	var wearer: Wearer = _wearer(0.0)
	wearer.motion.facing = 1.0
	wearer.motion.ahead_deg = 15.0
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.T_TO_N)
	var off: float = angle_difference(1.0, deg_to_rad(result.find(0).heading_deg))
	almost_equal(rad_to_deg(off), 0.0, 1.0, "left and right cancel")
	# Arms that are off alike on both sides are taken for that, not for norths that are apart.
	almost_equal(result.find(5).heading_deg, result.find(9).heading_deg, 6.0)
	is_true(result.is_good(), ", ".join(result.advice))


func test_a_heading_that_drifts_between_the_poses_is_named() -> void:
	var wearer: Wearer = _wearer(0.0)
	wearer.feed.drifts_deg.resize(17)
	wearer.feed.drifts_deg[12] = 2.0
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.T_TO_N)
	contains(result.advice, "left shank turned by 10° between the poses: a step, or drift?")
	equal(result.find(12).grade(), "moved", "4 degrees within the pose")
	equal(result.find(13).grade(), "good")


func test_a_wearer_who_is_not_perfect() -> void:
	# Feet that stand apart by 8 degrees, arms that hang 7 degrees off, 6 degrees of lazy arms.
	var wearer: Wearer = _wearer(0.4)
	wearer.motion.facing = 2.0
	wearer.motion.effort = 0.93
	for mount: int in [4, 5, 6, 13]:
		var off: Quaternion = Quaternion(wearer.any_axis(), deg_to_rad(7.0))
		wearer.motion.faults[mount] = off
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.T_TO_N)
	is_true(result.is_good(), ", ".join(result.advice))
	var off_deg: float = absf(
		rad_to_deg(angle_difference(2.4, deg_to_rad(result.find(0).heading_deg)))
	)
	is_true(off_deg < 5.0, "front off by %f deg" % off_deg)


func test_drifting_headings_do_not_turn_the_axes() -> void:
	for drift: float in [-0.2, 0.2]:
		var wearer: Wearer = _wearer(NAN)
		for sensor: int in 17:
			wearer.feed.drifts_deg.append(drift if sensor % 2 == 0 else -drift)
		var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.FULL)
		is_true(result.is_good(), ", ".join(result.advice))
		var norths: PackedFloat32Array = wearer.feed._headings
		for sensor: int in 17:
			var quality: CalibrationResult.PlaceQuality = result.find(sensor)
			var off: float = angle_difference(deg_to_rad(quality.heading_deg), norths[sensor])
			# 33 s of drift by a fifth of a degree per second.
			is_true(absf(rad_to_deg(off)) < 6.6, "%d: %f deg" % [sensor, rad_to_deg(off)])


func test_exchanged_sensors_are_named_by_any_calibration_with_movements() -> void:
	var cases: Dictionary[CalibrationGuide.Kind, Array] = {
		CalibrationGuide.Kind.T_TO_N: [Vector2i(5, 9), Vector2i(4, 8), Vector2i(5, 12)],
		CalibrationGuide.Kind.FULL: [Vector2i(5, 9), Vector2i(11, 12), Vector2i(14, 15)]
	}
	for kind: CalibrationGuide.Kind in cases:
		for swap: Vector2i in cases[kind]:
			var wearer: Wearer = _wearer(0.4)
			wearer.motion.facing = 1.0
			wearer.mounts[swap.x] = swap.y
			wearer.mounts[swap.y] = swap.x
			var result: CalibrationResult = wearer.calibrate(kind)
			equal(result.exchanges(), [swap] as Array[Vector2i])
			equal(result.advice[0], FitCheck.describe(swap))
			is_false(result.is_good())
			var front: float = angle_difference(1.4, deg_to_rad(result.find(0).heading_deg))
			almost_equal(front, 0.0, 1e-3, "the others tell the front")


func test_arms_exchanged_as_a_whole() -> void:
	var wearer: Wearer = _wearer(0.4)
	for mount: int in [4, 5, 6]:
		wearer.mounts[mount] = BodyMounts.MIRRORS[mount]
		wearer.mounts[BodyMounts.MIRRORS[mount]] = mount
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.FULL)
	var wanted: Array[Vector2i] = [Vector2i(4, 8), Vector2i(5, 9), Vector2i(6, 10)]
	equal(result.exchanges(), wanted)


func test_movement_is_shown_live() -> void:
	var wearer: Wearer = _wearer(0.0)
	wearer.motion.sways_deg[5] = 5.0
	wearer.calibrate(CalibrationGuide.Kind.T_POSE)
	var live: PackedFloat32Array = wearer.process.live_deg
	equal(live.size(), 17)
	is_true(live[5] > 1.0)
	almost_equal(live[0], 0.0, 0.01)


func test_a_new_sensor_takes_part_in_a_quick_reset() -> void:
	var wearer: Wearer = _wearer(0.3)
	wearer.motion.facing = -1.0
	wearer.calibration = wearer.calibrate(CalibrationGuide.Kind.T_TO_N).calibration
	wearer.calibration.entries.erase("00300006")
	var result: CalibrationResult = wearer.calibrate(CalibrationGuide.Kind.QUICK)
	var poses: Array[PoseSample] = Wearer.clip_poses("01_01.bvh", 0.5, 5)
	is_true(wearer.worst_deg(result.calibration, poses, -1.0) < 0.05)


func _wearer(p_north: float) -> Wearer:
	var wearer: Wearer = Wearer.new()
	wearer.random = _random
	wearer.rate_hz = 40.0
	wearer.wear(PackedInt32Array(range(17)), p_north)
	return wearer

extends TestCase
## From anybody's motion: exchanged and slipped sensors are named, right ones are not.

const CLIPS: PackedStringArray = ["01_01.bvh", "01_03.bvh", "Boxing_Toes.bvh"]

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _faults: Dictionary[int, Quaternion] = {}


func before_each() -> void:
	_random.seed = 11


func test_no_false_alarm_on_any_clip_and_layout() -> void:
	for clip: String in CLIPS:
		for count: int in [17, 15, 11, 10, 6]:
			for pose: int in 2:
				var mounts: PackedInt32Array = SensorMap.layout(count)
				var watch: WearWatch = _watch(clip, mounts, mounts, pose as ResetPose.Kind)
				var parts: Array = [clip, count, ", ".join(watch.messages())]
				equal(watch.messages().size(), 0, "%s, %d sensors: %s" % parts)


func test_no_false_alarm_for_a_careless_wearer_with_noisy_drifting_sensors() -> void:
	for clip: String in CLIPS:
		for count: int in [17, 10]:
			var mounts: PackedInt32Array = SensorMap.layout(count)
			var feed: WornSensorFeed = WornSensorFeed.new()
			feed.random = _random
			feed.noise_deg = 0.7
			for mount: int in mounts:
				feed.add_sensor(mount, Quaternion(Vector3.UP, _random.randf_range(-3.0, 3.0)))
				feed.drifts_deg.append(_random.randf_range(-0.3, 0.3))
			_faults.clear()
			for mount: int in BodyMounts.COUNT:
				var axis: Vector3 = Vector3(_random.randfn(), _random.randfn(), _random.randfn())
				_faults[mount] = Quaternion(axis.normalized(), deg_to_rad(8.0))
			var suit: SuitSource = _calibrated(feed, mounts, ResetPose.Kind.T)
			_play(suit, feed, clip)
			var parts: Array = [clip, count, ", ".join(suit.watch.messages())]
			equal(suit.watch.messages().size(), 0, "%s, %d sensors: %s" % parts)


func test_exchanged_neighbours_and_sides_are_named() -> void:
	# How many of the three clips must tell.
	var goals: Dictionary[Vector2i, int] = {
		Vector2i(5, 9): 3,
		Vector2i(4, 5): 3,
		Vector2i(8, 9): 3,
		Vector2i(4, 8): 3,
		Vector2i(6, 10): 3,
		Vector2i(11, 12): 3,
		Vector2i(14, 15): 3,
		Vector2i(11, 14): 3,
		Vector2i(12, 15): 3,
		Vector2i(13, 16): 3,
		Vector2i(12, 13): 1,
		Vector2i(15, 16): 1,
	}
	for pose: int in 2:
		for swap: Vector2i in goals:
			var told: PackedInt32Array = SensorMap.layout(15)
			var worn: PackedInt32Array = told.duplicate()
			worn[told.find(swap.x)] = swap.y
			worn[told.find(swap.y)] = swap.x
			var found: int = 0
			for clip: String in CLIPS:
				var watch: WearWatch = _watch(clip, told, worn, pose as ResetPose.Kind)
				found += 1 if watch.swaps.has(swap) else 0
				var said: String = ", ".join(watch.messages())
				for other: Vector2i in watch.swaps:
					equal(other, swap, "%s: %s" % [clip, said])
			# Arms that hang and swing ahead do so on either side: after an N-pose only arms that
			# go to the side tell.
			var goal: int = mini(goals[swap], 1) if pose == 1 and swap.x < 11 else goals[swap]
			is_true(found >= goal, "%s: %d clips" % [FitCheck.describe(swap), found])


func test_a_sensor_that_turned_over_is_named() -> void:
	for mount: int in [14, 5, 12]:
		var mounts: PackedInt32Array = SensorMap.layout(17)
		var feed: WornSensorFeed = WornSensorFeed.new()
		for worn: int in mounts:
			feed.add_sensor(worn)
		var suit: SuitSource = _calibrated(feed, mounts, ResetPose.Kind.T)
		feed.wear(mount, mount, Quaternion(Vector3.RIGHT, PI))
		_play(suit, feed, "01_01.bvh")
		var title: String = BodyMounts.title(mount)
		contains(", ".join(suit.watch.messages()), "%s sensor seems loose or upside down" % title)
		equal(suit.watch.slipped, PackedInt32Array([mount]))
		# Calibrated again, all is well.
		suit.set_calibration(null)
		equal(suit.watch.messages().size(), 0)


func _watch(
	p_clip: String, p_told: PackedInt32Array, p_worn: PackedInt32Array, p_pose: ResetPose.Kind
) -> WearWatch:
	var feed: WornSensorFeed = WornSensorFeed.new()
	for mount: int in p_worn:
		feed.add_sensor(mount, Quaternion(Vector3.RIGHT, _random.randf_range(-3.0, 3.0)))
	var suit: SuitSource = _calibrated(feed, p_told, p_pose)
	_play(suit, feed, p_clip)
	return suit.watch


func _calibrated(
	p_feed: WornSensorFeed, p_told: PackedInt32Array, p_pose: ResetPose.Kind
) -> SuitSource:
	var suit: SuitSource = SuitSource.new(p_feed)
	var map: SensorMap = SensorMap.new()
	var sensors: Array[SensorInfo] = p_feed.list_sensors()
	for at: int in sensors.size():
		map.assign(sensors[at].id, p_told[at])
	suit.set_map(map)
	var motion: CalibrationMotion = CalibrationMotion.new()
	motion.faults = _faults
	motion.kind = CalibrationGuide.Kind.N_POSE if p_pose == 1 else CalibrationGuide.Kind.T_POSE
	suit.process.options.facing = CalibrationOptions.Facing.NORTH
	equal(suit.start_calibration(motion.kind, 0.0), "")
	var time: float = 0.0
	while suit.process.is_running():
		p_feed.measure(motion.pose_at(time), 1000000 + roundi(time * 1e6))
		time += 0.1
		suit.advance(time)
	suit.accept_calibration()
	is_true(suit.is_calibrated())
	return suit


func _play(p_suit: SuitSource, p_feed: WornSensorFeed, p_clip: String) -> void:
	var source: BvhSource = BvhSource.new()
	source.open("res://assets/motion/" + p_clip)
	for at: int in 25 * 20:
		var time: int = 100000000 + at * 50000
		p_feed.measure(source.pose_at(at / 20.0), time)
		p_suit.advance(time / 1e6)

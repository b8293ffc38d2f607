extends "part.gd"
## What calibration, filling and body trackers make of a clip that is worn as sensors by somebody
## who does all exactly as asked.

const Wearer: GDScript = preload("res://tests/mocap/calibration/wearer.gd")
const _EXACT_DEG: float = 0.05
const _TRACKER_DEG: float = 0.01
const _REDO_S: float = 10.0
const _POSES: int = 60
const _TRACKER: StringName = &"/bench/body_tracker"

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func measure() -> void:
	_random.seed = arguments.value("seed")
	for file: String in BenchArguments.clips(arguments):
		var source: BvhSource = report.open_clip(file)
		if source != null:
			_run_clip(source)
	for kind: CalibrationGuide.Kind in CalibrationGuide.Kind.values():
		var is_long: bool = kind in [CalibrationGuide.Kind.FULL, CalibrationGuide.Kind.FIT_CHECK]
		var seconds: float = CalibrationGuide.duration_s(kind)
		report.at_most(CalibrationGuide.NAMES[kind], "duration", seconds, "s", _REDO_S, not is_long)


func _run_clip(p_source: BvhSource) -> void:
	var poses: Array[PoseSample] = []
	for at: int in _POSES:
		poses.append(p_source.pose_at(at * p_source.rig.clip.duration() / _POSES))
	var name: String = p_source.rig.clip.source_name
	for kind: CalibrationGuide.Kind in [
		CalibrationGuide.Kind.T_POSE,
		CalibrationGuide.Kind.N_POSE,
		CalibrationGuide.Kind.T_TO_N,
		CalibrationGuide.Kind.FULL
	]:
		_run_kind(name, kind, poses)
	_run_tracker(name, p_source, poses)
	_run_fill(name, p_source, poses)


func _run_kind(p_clip: String, p_kind: CalibrationGuide.Kind, p_poses: Array[PoseSample]) -> void:
	var worst: float = 0.0
	for _round: int in arguments.value("rounds"):
		var wearer: Wearer = Wearer.new()
		wearer.random = _random
		wearer.feed.noise_deg = arguments.value("noise")
		wearer.motion.facing = _random.randf_range(-PI, PI)
		var norths: float = NAN if p_kind == CalibrationGuide.Kind.FULL else 0.0
		wearer.wear(PackedInt32Array(range(BodyMounts.COUNT)), norths)
		if p_kind < CalibrationGuide.Kind.T_TO_N:
			wearer.process.options.facing = CalibrationOptions.Facing.HEADING
			wearer.process.options.heading_deg = -rad_to_deg(wearer.motion.facing)
		var result: CalibrationResult = wearer.calibrate(p_kind)
		wearer.feed.noise_deg = 0.0
		var off: float = wearer.worst_deg(result.calibration, p_poses, wearer.motion.facing)
		worst = maxf(worst, off)
	var is_clean: bool = arguments.value("noise") <= 0.0
	var parts: Array = [p_clip, CalibrationGuide.NAMES[p_kind]]
	report.at_most("%s, %s" % parts, "worst limb", worst, "deg", _EXACT_DEG, is_clean)


func _run_tracker(p_clip: String, p_source: BvhSource, p_poses: Array[PoseSample]) -> void:
	var publisher: TrackerPublisher = TrackerPublisher.new(p_source.get_body(), _TRACKER)
	var back: TrackerSource = TrackerSource.new(_TRACKER)
	var worst: float = 0.0
	for pose: PoseSample in p_poses:
		var begin: int = Time.get_ticks_usec()
		publisher.publish(pose)
		back.advance(begin)
		var again: PoseSample = back.sample(begin)
		for limb: int in Limbs.COUNT:
			var off: float = Rotations.between_deg(again.orientation(limb), pose.orientation(limb))
			worst = maxf(worst, off)
	publisher.retire()
	report.at_most(p_clip + ", body tracker", "there and back", worst, "deg", _TRACKER_DEG)


func _run_fill(p_clip: String, p_source: BvhSource, p_poses: Array[PoseSample]) -> void:
	var body: BodySize = p_source.get_body()
	var bases: PackedVector3Array = body.joints()
	var tails: PackedVector3Array = body.tails()
	for count: int in [6, 10, 13, 17]:
		var filler: LimbFiller = LimbFiller.new()
		var off: Statistics = Statistics.new()
		for pose: PoseSample in p_poses:
			filler.clear()
			for mount: int in SensorMap.layout(count):
				filler.set_mount(mount, pose.orientation(BodyMounts.LIMBS[mount]))
			filler.fill()
			for limb: int in Limbs.COUNT:
				if filler.measured[limb] == 0:
					var along: Vector3 = tails[limb] - bases[limb]
					var got: Vector3 = filler.limbs[limb] * along
					off.add(rad_to_deg(got.angle_to(pose.orientation(limb) * along)))
		report.add("%s, %d sensors" % [p_clip, count], "filled limbs, mean", off.mean(), "deg")

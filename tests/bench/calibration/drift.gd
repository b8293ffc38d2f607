extends "part.gd"
## How far headings of sensors that drift are off after a while, and what is said of it meanwhile.

const DailyMotion: GDScript = preload("res://tests/bench/calibration/daily_motion.gd")
## What is done, in these cases.
const CASES: Dictionary[String, PackedStringArray] = {
	"clip": ["clip"],
	"stand": ["stand"],
	"work": ["work"],
	"mixed": DailyMotion.ALL,
	"twisted": ["twisted"],
	"rifle": ["rifle"],
}
const _RATE_HZ: float = 25.0
## How far sensors sit beside their places, m, how far wearers' sizes are off, as a part, and what
## accelerations are off, m/s²: always, and at random (standard deviations of each axis).
const _MISPLACED_M: float = 0.025
const _SIZE: float = 0.05
const _ACCELERATION_BIAS: float = 0.05
const _ACCELERATION_NOISE: float = 0.1
const _BEGIN_USEC: int = 1700000000000000

var _clips: Array[Array] = []


## What became of a run.
class Outcome:
	## Mean error of all mounts at the end, and what it would be if nothing were corrected, degrees.
	var off: Statistics = Statistics.new()
	var raw: Statistics = Statistics.new()
	## Whether something was said to be wrong.
	var is_alarmed: bool = false


func measure() -> void:
	for file: String in BenchArguments.clips(arguments):
		var source: BvhSource = report.open_clip(file)
		if source != null:
			_clips.append(DailyMotion.keep(source))
	for rate: float in numbers("rates"):
		for name: String in CASES:
			var wanted: PackedStringArray = arguments.list("motions")
			if wanted.is_empty() or wanted.has(name):
				_run_case(name, rate)


func _run_case(p_name: String, p_rate: float) -> void:
	var off: Statistics = Statistics.new()
	var raw: Statistics = Statistics.new()
	var alarms: int = 0
	for run: int in arguments.value("runs"):
		var outcome: Outcome = _run(p_name, p_rate, run)
		off.add(outcome.off.mean())
		raw.add(outcome.raw.mean())
		alarms += int(outcome.is_alarmed)
	var case_name: String = "%s, %s deg/min" % [p_name, String.num(p_rate, 2)]
	var goal: float = 3.0 if p_rate > 1.5 else 2.5
	report.add(case_name, "uncorrected", raw.mean(), "deg")
	if p_rate == 0.0:
		goal = raw.mean() + 0.3
	report.at_most(case_name, "mean of limbs", off.mean(), "deg", goal)
	report.add(case_name, "worst run", off.percentile(1.0), "deg")
	report.at_most(case_name, "runs with false alarms", alarms, "", 0.0)


func _run(p_name: String, p_rate: float, p_run: int) -> Outcome:
	var random: RandomNumberGenerator = generator(p_run)
	var feed: WornSensorFeed = WornSensorFeed.new()
	feed.noise_deg = 0.3
	feed.drift_sway = random.randf_range(0.0, 0.3)
	_sit(feed, p_run)
	var map: SensorMap = SensorMap.new()
	var calibration: Calibration = Calibration.new()
	for mount: int in BodyMounts.COUNT:
		var mounting: Quaternion = Rotations.from_vector(
			Vector3(random.randfn(), random.randfn(), random.randfn())
		)
		var heading: float = random.randf_range(-PI, PI)
		var id: String = BodyMounts.NAMES[mount]
		feed.add_sensor(mount, mounting, heading, id)
		var rate: float = p_rate * (1.0 if random.randf() < 0.5 else random.randf())
		feed.drifts_deg.append(rate / 60.0 * (1.0 if random.randf() < 0.5 else -1.0))
		map.assign(id, mount)
		var entry: Calibration.Entry = Calibration.Entry.new()
		entry.mount = mount
		entry.heading = heading
		entry.mounting = mounting
		calibration.entries[id] = entry
	var suit: SuitSource = SuitSource.new(feed)
	suit.set_map(map)
	suit.set_calibration(calibration)
	return _wear(suit, feed, DailyMotion.new(random, _clips_of(random), CASES[p_name]))


## Sensors sit some centimetres beside where people are told to put them, on wearers of another size
## than they said, and their accelerations are not right either.
func _sit(p_feed: WornSensorFeed, p_run: int) -> void:
	# Drawn apart: with or without accelerations the wearer is the same.
	var random: RandomNumberGenerator = generator(-1 - p_run)
	p_feed.random = random
	p_feed.has_rates = not arguments.value("orientations")
	p_feed.size = 1.0 + random.randfn() * _SIZE
	p_feed.acceleration_noise = _ACCELERATION_NOISE
	for _mount: int in BodyMounts.COUNT:
		p_feed.misplaced.append(_any(random) * _MISPLACED_M)
		p_feed.acceleration_biases.append(_any(random) * _ACCELERATION_BIAS)


static func _any(p_random: RandomNumberGenerator) -> Vector3:
	return Vector3(p_random.randfn(), p_random.randfn(), p_random.randfn())


## All clips, in any order.
func _clips_of(p_random: RandomNumberGenerator) -> Array[Array]:
	var clips: Array[Array] = _clips.duplicate()
	var first: int = p_random.randi() % maxi(clips.size(), 1)
	for _step: int in first:
		clips.append(clips.pop_front())
	return clips


func _wear(p_suit: SuitSource, p_feed: WornSensorFeed, p_motion: DailyMotion) -> Outcome:
	var outcome: Outcome = Outcome.new()
	var frames: int = roundi(arguments.value("minutes") * 60.0 * _RATE_HZ)
	for at: int in frames:
		var time_s: float = at / _RATE_HZ
		var pose: PoseSample = p_motion.pose_at(time_s)
		p_feed.measure(pose, _BEGIN_USEC + roundi(time_s * 1e6))
		p_suit.advance(time_s)
		if at % 25 == 0:
			outcome.is_alarmed = outcome.is_alarmed or not p_suit.watch.messages().is_empty()
		# The last 20 s count.
		if at > frames - 500 and at % 10 == 0:
			_compare(p_suit, p_feed, time_s, outcome)
	return outcome


func _compare(
	p_suit: SuitSource, p_feed: WornSensorFeed, p_time_s: float, r_outcome: Outcome
) -> void:
	var taken: PackedFloat64Array = p_suit.headings.corrections()
	for sensor: int in BodyMounts.COUNT:
		var drift: float = p_feed.heading(sensor, p_time_s) - p_feed.heading(sensor, 0.0)
		r_outcome.off.add(absf(rad_to_deg(drift - taken[sensor])))
		r_outcome.raw.add(absf(rad_to_deg(drift)))

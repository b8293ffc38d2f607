extends Bench
## What streams of other people's suits cost, and how exactly poses come through a bad network.
##
## Options: --bvh=FILE (default assets/motion/01_01.bvh), --seconds=8, --rate=240, --loss=0.05,
## --duplicates=0.05, --jitter=3 (ms), --seed=1, --only=KIND. A datagram comes 3 ms late at least;
## errors are against the clip at the time that the pose says, after the first 2 s. "core" is one
## person's share of one core at that rate.

const _GOAL_DEG: float = 0.1
const _GOAL_CORE: float = 10.0
const _COST_SECONDS: float = 2.0
const _SENDER: String = "127.0.0.1:50000"


func options() -> Dictionary:
	return {
		"bvh": "res://assets/motion/01_01.bvh",
		"seconds": [8.0, 3.001, 3600.0],
		"rate": [240.0, 1.0, 10000.0],
		"loss": 0.05,
		"duplicates": 0.05,
		"jitter": 3.0,
		"seed": 1,
		"only": "",
	}


func measure() -> void:
	var clip: BvhSource = report.open_clip(option("bvh"))
	if clip != null:
		for kind: String in ["vmc", "rokoko", "axis", "axis-text", "mocopi", "natnet", "webcam"]:
			if option("only") in ["", kind]:
				_measure(kind, clip)
		if option("only") in ["", "slime"]:
			_measure_slime(clip)


func _measure(p_kind: String, p_clip: BvhSource) -> void:
	var rate: float = option("rate")
	var cost: float = _cost_usec(p_kind, p_clip, rate)
	report.add(p_kind, "read a pose", cost, "us")
	var core: float = cost * rate / 1e4
	report.at_most(p_kind, "core", core, "%", _GOAL_CORE)
	for is_clean: bool in [true, false]:
		var name: String = p_kind + (", clean" if is_clean else ", lossy")
		var line: LossyLine = LossyLine.new(option("seed"))
		line.rate = rate
		line.loss = 0.0 if is_clean else option("loss")
		line.twice = 0.0 if is_clean else option("duplicates")
		line.jitter_usec = 0 if is_clean else roundi(option("jitter") * 1e3)
		var stream: PoseStream = PoseStream.new(_reader(p_kind, p_clip))
		line.run(p_clip, _writer(p_kind, p_clip), stream, option("seconds"))
		# Points have no twist, and lines of text no time.
		var has: bool = p_kind != "webcam" and (p_kind != "axis-text" or is_clean)
		report.add(name, "mean", line.errors.mean(), "deg")
		report.at_most(name, "p95", line.errors.percentile(0.95), "deg", _GOAL_DEG, has)
		report.add(name, "p99", line.errors.percentile(0.99), "deg")
		report.add(name, "worst", line.worst_deg(), "deg")
		report.add(name, "root worst", line.worst_root * 1000.0, "mm")


## Time to read one pose, µs: the median of all.
func _cost_usec(p_kind: String, p_clip: BvhSource, p_rate: float) -> float:
	var reader: StreamReader = _reader(p_kind, p_clip)
	var writer: StreamWriter = _writer(p_kind, p_clip)
	var times: Statistics = Statistics.new()
	for number: int in roundi(_COST_SECONDS * p_rate):
		var pose: PoseSample = p_clip.pose_at(number / p_rate)
		pose.time_usec = LossyLine.BEGIN_USEC + roundi(number * 1e6 / p_rate)
		var datagrams: Array[PackedByteArray] = writer.write(pose)
		var begin: int = Time.get_ticks_usec()
		for datagram: PackedByteArray in datagrams:
			reader.read(datagram, _SENDER)
		times.add(Time.get_ticks_usec() - begin)
	return times.percentile(0.5)


## SlimeVR's trackers, twelve sensors: raw orientations, which are to be calibrated.
func _measure_slime(p_clip: BvhSource) -> void:
	var rate: float = option("rate")
	var feed: SlimeFeed = SlimeFeed.new()
	var writer: SlimeWriter = SlimeWriter.new()
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = option("seed")
	var costs: Statistics = Statistics.new()
	var errors: Statistics = Statistics.new()
	for number: int in roundi(option("seconds") * rate):
		var usec: int = LossyLine.BEGIN_USEC + roundi(number * 1e6 / rate)
		var pose: PoseSample = p_clip.pose_at(number / rate)
		pose.time_usec = usec
		for datagram: PackedByteArray in writer.write(pose):
			var copies: int = 2 if random.randf() < option("duplicates") else 1
			for _copy: int in copies:
				if random.randf() >= option("loss") or number == 0:
					var begin: int = Time.get_ticks_usec()
					feed.take(datagram, _SENDER, usec + LossyLine.DELAY_USEC)
					costs.add(Time.get_ticks_usec() - begin)
		if number == 0:
			var answer: PackedByteArray = [SlimeDevice.Packet.HANDSHAKE]
			answer.append_array(SlimeFeed.ANSWER.to_ascii_buffer())
			writer.answer(answer)
		for frame: SensorFrame in feed.frames_until(usec + LossyLine.DELAY_USEC):
			var at_s: float = (frame.time_usec - LossyLine.DELAY_USEC - LossyLine.BEGIN_USEC) / 1e6
			var truth: PoseSample = p_clip.pose_at(at_s)
			var sensors: Array[SensorInfo] = feed.list_sensors()
			for sensor: int in frame.count():
				if frame.present[sensor] != 0 and at_s > 2.0:
					# They come in the order in which they were heard first.
					var mount: int = writer.mounts[sensors[sensor].id.get_slice("-", 1).to_int()]
					var turn: Quaternion = truth.orientation(BodyMounts.LIMBS[mount])
					errors.add(Rotations.between_deg(frame.orientation(sensor), turn))
	var cost: float = costs.percentile(0.5)
	report.add("slime", "read 12 sensors", cost, "us")
	report.at_most("slime", "core", cost * rate / 1e4, "%", _GOAL_CORE)
	report.add("slime, lossy", "mean", errors.mean(), "deg")
	var p95: float = errors.percentile(0.95)
	report.at_most("slime, lossy", "p95", p95, "deg", _GOAL_DEG)
	report.add("slime, lossy", "p99", errors.percentile(0.99), "deg")


static func _writer(p_kind: String, p_clip: BvhSource) -> StreamWriter:
	var size: BodySize = p_clip.get_body()
	match p_kind:
		"vmc":
			return VmcWriter.new(size)
		"rokoko":
			return RokokoWriter.new(size)
		"mocopi":
			return MocopiWriter.new(size)
		"natnet":
			return NatnetWriter.new(size)
		"webcam":
			return WebcamWriter.new(size)
	var axis: AxisWriter = AxisWriter.new(size)
	axis.is_text = p_kind == "axis-text"
	return axis


static func _reader(p_kind: String, p_clip: BvhSource) -> StreamReader:
	var reader: StreamReader = MotionStreams.reader_of(p_kind.trim_suffix("-text"))
	if reader is NatnetReader:
		# It asks for the version and for the names of the bones.
		var writer: NatnetWriter = NatnetWriter.new(p_clip.get_body())
		for request: int in [NatnetReader.CONNECT, NatnetReader.REQUEST_MODELDEF]:
			for answer: PackedByteArray in writer.answer(NatnetBytes.message(request)):
				reader.read(answer, _SENDER)
	return reader

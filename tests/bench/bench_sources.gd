extends SceneTree
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


func _initialize() -> void:
	var arguments: BenchArguments = (
		BenchArguments
		. parse(
			OS.get_cmdline_user_args(),
			{
				"bvh": "res://assets/motion/01_01.bvh",
				"seconds": 8.0,
				"rate": 240.0,
				"loss": 0.05,
				"duplicates": 0.05,
				"jitter": 3.0,
				"seed": 1,
				"only": "",
			}
		)
	)
	var fault: String = arguments.error
	if fault == "" and not (arguments.value("rate") >= 1.0 and arguments.value("seconds") > 3.0):
		fault = "--rate is 1 or more, --seconds more than 3"
	if fault != "":
		printerr(fault)
		quit(2)
		return
	var report: BenchReport = BenchReport.new("sources", arguments.value("json"))
	var clip: BvhSource = report.open_clip(arguments.value("bvh"))
	if clip != null:
		for kind: String in ["vmc", "rokoko", "axis", "axis-text", "mocopi", "natnet", "webcam"]:
			if arguments.value("only") in ["", kind]:
				_measure(kind, clip, arguments, report)
		if arguments.value("only") in ["", "slime"]:
			_measure_slime(clip, arguments, report)
	quit(report.finish())


func _measure(
	p_kind: String, p_clip: BvhSource, p_arguments: BenchArguments, p_report: BenchReport
) -> void:
	var rate: float = p_arguments.value("rate")
	var cost: float = _cost_usec(p_kind, p_clip, rate)
	p_report.add(p_kind, "read a pose", cost, "us")
	var core: float = cost * rate / 1e4
	p_report.add(p_kind, "core", core, "%", BenchReport.Goal.AT_MOST, _GOAL_CORE)
	for is_clean: bool in [true, false]:
		var name: String = p_kind + (", clean" if is_clean else ", lossy")
		var line: LossyLine = LossyLine.new(p_arguments.value("seed"))
		line.rate = rate
		line.loss = 0.0 if is_clean else p_arguments.value("loss")
		line.twice = 0.0 if is_clean else p_arguments.value("duplicates")
		line.jitter_usec = 0 if is_clean else roundi(p_arguments.value("jitter") * 1e3)
		var stream: PoseStream = PoseStream.new(_reader(p_kind, p_clip))
		line.run(p_clip, _writer(p_kind, p_clip), stream, p_arguments.value("seconds"))
		var goal: BenchReport.Goal = BenchReport.Goal.AT_MOST
		# Points have no twist, and lines of text no time.
		if p_kind == "webcam" or (p_kind == "axis-text" and not is_clean):
			goal = BenchReport.Goal.NONE
		p_report.add(name, "mean", line.errors.mean(), "deg")
		p_report.add(name, "p95", line.errors.percentile(0.95), "deg", goal, _GOAL_DEG)
		p_report.add(name, "p99", line.errors.percentile(0.99), "deg")
		p_report.add(name, "worst", line.worst_deg(), "deg")
		p_report.add(name, "root worst", line.worst_root * 1000.0, "mm")


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
func _measure_slime(p_clip: BvhSource, p_arguments: BenchArguments, p_report: BenchReport) -> void:
	var rate: float = p_arguments.value("rate")
	var feed: SlimeFeed = SlimeFeed.new()
	var writer: SlimeWriter = SlimeWriter.new()
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = p_arguments.value("seed")
	var costs: Statistics = Statistics.new()
	var errors: Statistics = Statistics.new()
	for number: int in roundi(p_arguments.value("seconds") * rate):
		var usec: int = LossyLine.BEGIN_USEC + roundi(number * 1e6 / rate)
		var pose: PoseSample = p_clip.pose_at(number / rate)
		pose.time_usec = usec
		for datagram: PackedByteArray in writer.write(pose):
			var copies: int = 2 if random.randf() < p_arguments.value("duplicates") else 1
			for _copy: int in copies:
				if random.randf() >= p_arguments.value("loss") or number == 0:
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
	p_report.add("slime", "read 12 sensors", cost, "us")
	p_report.add("slime", "core", cost * rate / 1e4, "%", BenchReport.Goal.AT_MOST, _GOAL_CORE)
	p_report.add("slime, lossy", "mean", errors.mean(), "deg")
	var p95: float = errors.percentile(0.95)
	p_report.add("slime, lossy", "p95", p95, "deg", BenchReport.Goal.AT_MOST, _GOAL_DEG)
	p_report.add("slime, lossy", "p99", errors.percentile(0.99), "deg")


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

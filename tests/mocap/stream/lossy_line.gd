class_name LossyLine
extends RefCounted
## A network between a [StreamWriter] and a [PoseStream] in simulated time: datagrams get lost, come
## twice, late and in another order. What comes out is compared with what went in.

## Time that every datagram needs at least, µs.
const DELAY_USEC: int = 3000
## When the simulation begins, µs of Unix time.
const BEGIN_USEC: int = 1_700_000_000_000_000
## Who sends.
const SENDER: String = "127.0.0.1:50000"

## Share of datagrams that get lost, and that come twice.
var loss: float = 0.05
var twice: float = 0.05
## Greatest further delay of one, µs.
var jitter_usec: int = 3000
## Samples a second.
var rate: float = 240.0
## Differences of what came out, degrees: all, and the worst of each limb.
var errors: Statistics = Statistics.new()
var worst: PackedFloat32Array = PackedFloat32Array()
## Greatest differences of the root and of where limbs are, m.
var worst_root: float = 0.0
var worst_place: float = 0.0
## Poses that came out.
var count: int = 0

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _waiting: Array[Array] = []


func _init(p_seed: int = 1) -> void:
	_random.seed = p_seed
	worst.resize(Limbs.COUNT)


## Sends a clip for so long, s, and samples whom it becomes 60 times a second. The first 2 s are
## not compared: clocks are compared in it.
func run(
	p_clip: BvhSource, p_writer: StreamWriter, p_stream: PoseStream, p_seconds: float
) -> StreamPerson:
	var person: StreamPerson = null
	var next_look: int = BEGIN_USEC
	for number: int in roundi(p_seconds * rate):
		var time_s: float = number / rate
		var usec: int = BEGIN_USEC + roundi(time_s * 1e6)
		var pose: PoseSample = p_clip.pose_at(time_s)
		pose.time_usec = usec
		for datagram: PackedByteArray in p_writer.write(pose):
			_post(datagram, usec)
		_deliver(p_stream, usec)
		p_stream.look(usec / 1e6)
		person = p_stream.people.values()[0] if not p_stream.people.is_empty() else null
		while usec >= next_look:
			next_look += 16667
			if person != null:
				var came: PoseSample = person.sample(usec)
				if came != null and time_s > 2.0:
					_compare(came, p_clip)
	return person


## Gives a reader datagrams with wrong bytes, and cut ones, and checks that what comes out is poses.
## Returns what does not hold, or an empty text.
static func fuzz(
	p_reader: StreamReader, p_datagrams: Array[PackedByteArray], p_rounds: int, p_seed: int = 1
) -> String:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = p_seed
	for number: int in p_rounds:
		var bytes: PackedByteArray = p_datagrams[number % p_datagrams.size()].duplicate()
		for _byte: int in random.randi_range(0, 6):
			bytes[random.randi() % bytes.size()] = random.randi() & 0xFF
		if random.randf() < 0.5:
			bytes = bytes.slice(0, random.randi_range(0, bytes.size()))
		for sample: StreamSample in p_reader.read(bytes, SENDER):
			if sample.pose == null or sample.pose.orientations.size() != 4 * Limbs.COUNT:
				return "round %d: a sample without a pose" % number
			if sample.pose.find_fault() != "":
				return "round %d: %s" % [number, sample.pose.find_fault()]
	return ""


## The greatest difference of any limb, degrees.
func worst_deg() -> float:
	var greatest: float = 0.0
	for error: float in worst:
		greatest = maxf(greatest, error)
	return greatest


func _post(p_datagram: PackedByteArray, p_usec: int) -> void:
	for _copy: int in 2 if _random.randf() < twice else 1:
		var late: int = _random.randi_range(0, jitter_usec)
		if _random.randf() >= loss:
			_waiting.append([p_usec + DELAY_USEC + late, p_datagram])


func _deliver(p_stream: PoseStream, p_usec: int) -> void:
	var due: Array[Array] = _waiting.filter(func(one: Array) -> bool: return one[0] <= p_usec)
	_waiting = _waiting.filter(func(one: Array) -> bool: return one[0] > p_usec)
	due.sort_custom(func(a: Array, b: Array) -> bool: return a[0] < b[0])
	for one: Array in due:
		p_stream.take(one[1], SENDER, one[0])


func _compare(p_came: PoseSample, p_clip: BvhSource) -> void:
	count += 1
	var truth: PoseSample = p_clip.pose_at((p_came.time_usec - DELAY_USEC - BEGIN_USEC) / 1e6)
	for limb: int in Limbs.COUNT:
		var off: float = Rotations.between_deg(p_came.orientation(limb), truth.orientation(limb))
		errors.add(off)
		worst[limb] = maxf(worst[limb], off)
	worst_root = maxf(worst_root, p_came.root.distance_to(truth.root))
	if p_came.details != null and p_came.details.positions.size() == Limbs.COUNT:
		var figure: BodySegments = BodySegments.new(p_clip.get_body())
		figure.solve(truth)
		for limb: int in Limbs.COUNT:
			var place: Vector3 = p_came.details.positions[limb]
			worst_place = maxf(worst_place, place.distance_to(figure.bases[limb]))

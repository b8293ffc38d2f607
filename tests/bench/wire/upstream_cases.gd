extends RefCounted
## What trainees send: people's motion by [SampleWriter], with all headers and what rides along.

## Bytes that IP (20), UDP (8) and sealing (18) add to each datagram.
const HEADERS: int = 46
const HZ: int = 60
## Ticks between two acknowledgements of snapshots, which ride along, and the bytes of one.
const _ACK_TICKS: int = 6
const _ACK_BYTES: int = 9
## Goals by the number of people, kbit/s, on every network.
const _GOALS: Dictionary[int, float] = {1: 30.0, 8: 130.0}
## Chance of a datagram to be lost, and how many samples leave between one and the acknowledgement
## of it. On a LAN none does: samples leave shortly before the server's tick, whose snapshot is back
## before the next one (19 of 20 times between two processes on a busy machine).
const _NETWORKS: Dictionary[String, Vector2] = {
	"LAN": Vector2(0.0, 0.0),
	"two samples on the way": Vector2(0.0, 2.0),
	"50 ms, 2 % loss": Vector2(0.02, 5.0),
	"100 ms, 5 % loss": Vector2(0.05, 7.0),
	"100 ms, 20 % loss": Vector2(0.2, 7.0),
}

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _lost: int = 0
var _sent: int = 0
var _arrived: int = 0
var _worst_deg: float = 0.0
var _encode_usec: float = 0.0
var _decode_usec: float = 0.0


## Measures them over clips; times are those of the processor.
func run(p_report: BenchReport, p_clips: Array[WireClip]) -> void:
	for people: int in _GOALS:
		for network: String in _NETWORKS:
			var rate: float = 0.0
			for clip: WireClip in p_clips:
				rate += _measure(clip, people, _NETWORKS[network]) / p_clips.size()
			var name: String = "upstream, %d people, %s" % [people, network]
			p_report.at_most(name, "all headers", rate, "kbit/s", _GOALS[people])
			p_report.add(name, "headers alone", HEADERS * HZ * 8 / 1000.0, "kbit/s")
			p_report.add(name, "samples that arrive", 100.0 * _arrived / _sent, "%")
			p_report.at_most(name, "samples lost beside datagrams", _lost, "", 0.0)
			p_report.at_most(
				name, "worst limb", _worst_deg, "deg", Protocol.MOTION_ERROR_DEG + 0.01
			)
			p_report.add(name, "write", _encode_usec, "us a datagram")
			p_report.add(name, "read", _decode_usec, "us a datagram")


## kbit/s of so many people who do a clip, at different moments of it.
func _measure(p_clip: WireClip, p_people: int, p_network: Vector2) -> float:
	_random.seed = 1
	_lost = 0
	_sent = 0
	_arrived = 0
	_encode_usec = 0.0
	_decode_usec = 0.0
	var writer: SampleWriter = SampleWriter.new()
	var reader: SampleReader = SampleReader.new()
	var acks: Array[PackedByteArray] = []
	var bytes: int = 0
	var ticks: int = p_clip.poses.size()
	for tick: int in ticks:
		var samples: Array[PoseSample] = []
		for person: int in p_people:
			samples.append(_sample_at(p_clip, person, tick))
		var begin: int = ThreadClock.get_usec()
		var datagrams: Array[PackedByteArray] = writer.write(samples)
		_encode_usec += float(ThreadClock.get_usec() - begin) / ticks
		_sent += samples.size()
		for datagram: PackedByteArray in datagrams:
			bytes += HEADERS + datagram.size() + (_ACK_BYTES if tick % _ACK_TICKS == 0 else 0)
			if _random.randf() >= p_network.x:
				begin = ThreadClock.get_usec()
				var got: Array[PoseSample] = reader.read(datagram)
				_decode_usec += float(ThreadClock.get_usec() - begin) / ticks
				_compare(got, samples)
		acks.append(reader.take_ack())
		if acks.size() > int(p_network.y):
			var ack: PackedByteArray = acks.pop_front()
			if _random.randf() >= p_network.x:
				writer.take_ack(ack)
	return bytes * 8.0 * HZ / ticks / 1000.0


func _compare(p_got: Array[PoseSample], p_sent: Array[PoseSample]) -> void:
	_lost += p_sent.size() - p_got.size()
	_arrived += p_got.size()
	for at: int in p_got.size():
		for limb: int in Limbs.COUNT:
			var off: Quaternion = WireClip.rotation_of(p_got[at].orientations, limb).inverse()
			off *= WireClip.rotation_of(p_sent[at].orientations, limb)
			var sine: float = Vector3(off.x, off.y, off.z).length()
			_worst_deg = maxf(_worst_deg, rad_to_deg(2.0 * asin(minf(sine, 1.0))))


## Somebody's sample, taken about when it is due: threads are a little late.
func _sample_at(p_clip: WireClip, p_person: int, p_tick: int) -> PoseSample:
	var pose: PoseSample = p_clip.poses[(p_tick + p_person * 53) % p_clip.poses.size()]
	var sample: PoseSample = PoseSample.new()
	sample.person = p_person
	sample.id = p_tick
	sample.orientations = pose.orientations
	sample.root = pose.root
	sample.time_usec = 1700000000000000 + roundi(p_tick * 1e6 / HZ) + _random.randi_range(-3, 3)
	if p_person > 0:
		sample.time_usec = 1700000000000000 + roundi(p_tick * 1e6 / HZ)
	sample.held_usec = _random.randi_range(60, 300)
	sample.sent_usec = sample.time_usec + sample.held_usec - 1690000000000000
	return sample

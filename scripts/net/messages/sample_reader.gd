class_name SampleReader
extends RefCounted
## Reads the datagrams of one client's [SampleWriter].

## What is wrong with the datagram that was read last, or an empty text.
var error: String = ""
## The message that it took along, or none.
var rider: PackedByteArray = PackedByteArray()

var _decoder: MotionDecoder = MotionDecoder.new()
var _has_news: bool = false


func _init() -> void:
	_decoder.configure(PackedInt32Array(Limbs.PARENTS), Protocol.MOTION_ERROR_DEG)


## The samples of a datagram. None (without an [member error]) where it came twice, or cannot be
## read without others that did not come.
func read(p_bytes: PackedByteArray) -> Array[PoseSample]:
	var samples: Array[PoseSample] = []
	error = ""
	rider = PackedByteArray()
	var outcome: MotionDecoder.Outcome = _decoder.decode(p_bytes)
	if outcome == MotionDecoder.BROKEN:
		error = "%d bytes that are no motion" % p_bytes.size()
	if outcome != MotionDecoder.OK:
		return samples
	_has_news = true
	rider = p_bytes.slice(_decoder.get_used())
	if not rider.is_empty() and rider[0] != Protocol.Message.ACK:
		error = "motion with a message %d behind it" % rider[0]
		rider = PackedByteArray()
		return samples
	for person: int in _decoder.get_people():
		var sample: PoseSample = _sample_of(person)
		error = sample.find_root_fault()
		if error != "":
			error = "motion that is no pose: " + error
			return []
		samples.append(sample)
	return samples


## Acknowledgement for the client of what has arrived; empty while there is nothing new. The sooner
## it hears it, the smaller its next samples are.
func take_ack() -> PackedByteArray:
	if not _has_news:
		return PackedByteArray()
	_has_news = false
	return _decoder.get_ack()


func _sample_of(p_person: int) -> PoseSample:
	var sample: PoseSample = PoseSample.new()
	sample.person = p_person
	sample.id = _decoder.get_sample(p_person)
	sample.time_usec = _decoder.get_time_usec(p_person)
	sample.held_usec = _decoder.get_held_usec(p_person)
	sample.sent_usec = _decoder.get_sent_usec()
	sample.root = _decoder.get_root(p_person)
	sample.orientations = _decoder.get_orientations(p_person)
	return sample

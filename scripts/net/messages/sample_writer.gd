class_name SampleWriter
extends RefCounted
## Turns the samples of a client's people into datagrams: as many people as there are in one, coded
## against what the server has acknowledged ([MotionEncoder]). Any thread may call it.

var _encoder: MotionEncoder = MotionEncoder.new()
## The message that the next datagram takes along.
var _rider: PackedByteArray = PackedByteArray()
var _mutex: Mutex = Mutex.new()


func _init() -> void:
	restart()


## Begins anew, for another server.
func restart() -> void:
	_mutex.lock()
	_encoder.configure(PackedInt32Array(Limbs.PARENTS), Protocol.MOTION_ERROR_DEG, randi())
	_rider.clear()
	_mutex.unlock()


## The datagrams of samples that are sent together: mostly one. What is no pose is left out.
func write(p_samples: Array[PoseSample]) -> Array[PackedByteArray]:
	_mutex.lock()
	var datagrams: Array[PackedByteArray] = _write(p_samples)
	_mutex.unlock()
	return datagrams


## Lets the next datagram take an acknowledgement of snapshots along. Returns false where the last
## one still waits: there is no motion, and it has to go alone.
func take_along(p_ack: PackedByteArray) -> bool:
	_mutex.lock()
	var is_free: bool = _rider.is_empty()
	_rider = p_ack if is_free else PackedByteArray()
	_mutex.unlock()
	return is_free


## Takes what the server has of the samples: see [method SampleReader.take_ack]. An empty one says
## nothing.
func take_ack(p_bytes: PackedByteArray) -> void:
	if not p_bytes.is_empty():
		_mutex.lock()
		_encoder.take_ack(p_bytes)
		_mutex.unlock()


func _write(p_samples: Array[PoseSample]) -> Array[PackedByteArray]:
	var datagrams: Array[PackedByteArray] = []
	if p_samples.is_empty():
		return datagrams
	var first: PoseSample = p_samples[0]
	_encoder.begin(first.time_usec, first.held_usec, first.sent_usec)
	for sample: PoseSample in p_samples:
		_encoder.put(sample.person, sample.id, sample.time_usec, sample.root, sample.orientations)
	var bytes: PackedByteArray = _encoder.finish()
	if bytes.is_empty() and p_samples.size() > 1:
		# They do not fit into one.
		var half: int = p_samples.size() / 2
		return _write(p_samples.slice(0, half)) + _write(p_samples.slice(half))
	if bytes.is_empty():
		return datagrams
	if bytes.size() + _rider.size() <= Protocol.MAX_DATAGRAM:
		bytes.append_array(_rider)
		_rider = PackedByteArray()
	datagrams.append(bytes)
	return datagrams

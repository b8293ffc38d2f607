class_name MotionSender
extends RefCounted
## Samples all people of a client in one thread and sends the samples at once, in one datagram
## (thesis section 7.4.2).

var _link: ClientLink = null
var _sampler: MotionSampler = MotionSampler.new()
var _writer: SampleWriter = SampleWriter.new()
# Shared with the sampling thread and guarded.
var _mutex: Mutex = Mutex.new()
var _sends: bool = false
var _server_ahead_usec: int = 0
var _knows_server: bool = false


## Begins to sample, so many times a second. Samples go out while [method set_sending] says so.
func start(p_rate: float, p_link: ClientLink) -> void:
	_link = p_link
	_link.set_motion_ack_taker(_writer.take_ack)
	_sampler.start(p_rate, _send)


## Ends the thread.
func stop() -> void:
	if _link != null:
		_link.set_motion_ack_taker(Callable())
	_sampler.stop()


## Samples a source from now on, as the client's person of this number.
func add(p_person: int, p_source: MotionSource) -> void:
	_sampler.add_source(p_person, p_source)


## Samples it no longer.
func remove(p_person: int) -> void:
	_sampler.remove_source(p_person)


## Samples those that need the physics world: see [method MotionSampler.sample_in_world].
func sample_in_world() -> void:
	_sampler.sample_in_world(Time.get_ticks_usec() + unix_ahead())


## Begins anew, for a server that has none of the samples.
func restart() -> void:
	_writer.restart()


## Whether samples are sent.
func set_sending(p_sends: bool) -> void:
	_mutex.lock()
	_sends = p_sends
	_knows_server = _knows_server and p_sends
	_mutex.unlock()


## Says how far the server's clock is ahead of this program's, µs, and when a sample is to be taken
## so that it comes in time for a tick: µs of Unix time.
func keep_in_step(p_server_ahead_usec: int, p_due_usec: int) -> void:
	_mutex.lock()
	_knows_server = true
	_server_ahead_usec = p_server_ahead_usec
	_mutex.unlock()
	_sampler.set_phase(p_due_usec)


## The samples of a person since the last call, oldest first.
func take_samples(p_person: int) -> Array[PoseSample]:
	return _sampler.take_samples(p_person)


## Sends an acknowledgement of snapshots: with the next samples, or alone where there are none.
func send_ack(p_bytes: PackedByteArray) -> void:
	_mutex.lock()
	var sends: bool = _sends
	_mutex.unlock()
	if not sends or not _writer.take_along(p_bytes):
		_link.send_fast(p_bytes)


## Stats of a person for a report.
func stats(p_person: int) -> Dictionary:
	return _sampler.stats(p_person)


## Unix time minus this program's clock, µs.
static func unix_ahead() -> int:
	return int(Time.get_unix_time_from_system() * 1e6) - Time.get_ticks_usec()


## Runs in the thread that took the samples.
func _send(p_samples: Array[PoseSample]) -> void:
	_mutex.lock()
	var sends: bool = _sends
	var ahead: int = _server_ahead_usec
	var knows: bool = _knows_server
	_mutex.unlock()
	if not sends:
		return
	var now: int = Time.get_ticks_usec()
	for sample: PoseSample in p_samples:
		sample.held_usec = maxi(now + unix_ahead() - sample.time_usec, 0)
		sample.sent_usec = now + ahead if knows else 0
	for bytes: PackedByteArray in _writer.write(p_samples):
		_link.send_fast(bytes)

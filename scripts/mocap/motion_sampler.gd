class_name MotionSampler
extends RefCounted
## Samples [MotionSource]s at exact times in a thread of its own, however slow the display is. Those
## that need the physics world are sampled in step with it: see [method sample_in_world].
##
## The samples of a moment go to a callable together and at once, in the thread that took them, and
## wait here for the display of the own bodies. The times can be locked to another clock, so that
## samples reach the server shortly before its ticks. While it runs nobody else may ask the sources
## for samples. It must be stopped: a running thread keeps it alive.

## Maximum of a source's samples that wait for [method take_samples]; beyond it the oldest are
## dropped.
const MAX_WAITING: int = 64
## A due time that is further off than this many periods is reset: the machine slept, or its clock
## was set.
const MAX_PERIODS: int = 16
## Part of a period by which a sample's time yields to the requested phase.
const SLEW: float = 0.05
## Maximum sleep of the thread, µs.
const _MAX_SLEEP_USEC: int = 5000

var _deliver: Callable = Callable()
var _period_usec: float = 1e6 / 60.0
var _thread: Thread = null
# Held while sources are asked: nobody is taken away meanwhile.
var _asking: Mutex = Mutex.new()
var _lanes: Dictionary[int, Lane] = {}
# All below is shared with the thread and guarded.
var _mutex: Mutex = Mutex.new()
var _stops: bool = false
var _phase_usec: float = -1.0
var _lateness: Statistics = Statistics.new()


## One source and its last poses.
class Lane:
	var source: MotionSource = null
	var waiting: Array[PoseSample] = []
	var taken: int = 0


## Begins to sample at this rate, per second. [param p_deliver] is called with the samples of each
## moment ([code]Array[PoseSample][/code], at least one) in the sampling thread: what it does must
## be safe there. [member PoseSample.person] is the number of the source.
func start(p_rate: float, p_deliver: Callable) -> void:
	stop()
	_deliver = p_deliver
	_period_usec = 1e6 / p_rate
	_stops = false
	_thread = Thread.new()
	_thread.start(_run, Thread.PRIORITY_HIGH)


## Ends it and waits for the thread; harmless if it does not run. The sources stay.
func stop() -> void:
	if _thread == null:
		return
	_mutex.lock()
	_stops = true
	_mutex.unlock()
	_thread.wait_to_finish()
	_thread = null


## Whether it runs.
func is_running() -> bool:
	return _thread != null


## Samples a source from now on, under a number.
func add_source(p_number: int, p_source: MotionSource) -> void:
	var lane: Lane = Lane.new()
	lane.source = p_source
	_asking.lock()
	_lanes[p_number] = lane
	_asking.unlock()


## Stops sampling a source. When this returns nobody asks the source any more.
func remove_source(p_number: int) -> void:
	_asking.lock()
	_lanes.erase(p_number)
	_asking.unlock()


## Samples the sources that need the physics world, for a moment (Unix time, µs). Call it in each
## physics frame, from the main thread.
func sample_in_world(p_time_usec: int) -> void:
	if _thread != null:
		_take(p_time_usec, 0.0, true)


## Pulls the times of the samples to a requested one (Unix time, µs) and to all that are whole
## periods from it.
func set_phase(p_due_usec: int) -> void:
	_mutex.lock()
	_phase_usec = p_due_usec
	_mutex.unlock()


## The samples of a source since the last call, oldest first. They may be read but not changed.
func take_samples(p_number: int) -> Array[PoseSample]:
	var samples: Array[PoseSample] = []
	_mutex.lock()
	var lane: Lane = _lanes.get(p_number)
	if lane != null:
		samples = lane.waiting
		lane.waiting = []
	_mutex.unlock()
	return samples


## Stats of a source for a report: samples, and how late the thread was, ms.
func stats(p_number: int) -> Dictionary:
	_mutex.lock()
	var lane: Lane = _lanes.get(p_number)
	var result: Dictionary = {
		"samples": lane.taken if lane != null else 0,
		"late_ms_p50": _lateness.percentile(0.5) / 1000.0,
		"late_ms_p99": _lateness.percentile(0.99) / 1000.0,
	}
	_mutex.unlock()
	return result


## When the next sample is due after one, given the phase that is wanted (negative: any), µs.
static func next_due(p_due_usec: float, p_period_usec: float, p_phase_usec: float) -> float:
	var next: float = p_due_usec + p_period_usec
	if p_phase_usec < 0.0:
		return next
	var off: float = fposmod(p_phase_usec - next + p_period_usec / 2.0, p_period_usec)
	off -= p_period_usec / 2.0
	return next + clampf(off, -SLEW * p_period_usec, SLEW * p_period_usec)


func _run() -> void:
	var due: float = _now()
	while true:
		var wait: float = due - _now()
		if absf(wait) > MAX_PERIODS * _period_usec:
			due = _now()
		elif wait > 0.0:
			OS.delay_usec(clampi(ceili(wait), 1, _MAX_SLEEP_USEC))
		else:
			_take(roundi(due), -wait, false)
			_mutex.lock()
			due = next_due(due, _period_usec, _phase_usec)
			_mutex.unlock()
		_mutex.lock()
		var stops: bool = _stops
		_mutex.unlock()
		if stops:
			return


## The mutex lets the two threads deliver one after the other.
func _take(p_due_usec: int, p_late_usec: float, p_is_in_world: bool) -> void:
	var samples: Array[PoseSample] = []
	var sent: Array[PoseSample] = []
	_asking.lock()
	for number: int in _lanes:
		var source: MotionSource = _lanes[number].source
		if source.needs_world() != p_is_in_world:
			continue
		var sample: PoseSample = source.sample(p_due_usec)
		if sample != null:
			sample.person = number
			samples.append(sample)
			if source.is_sent():
				sent.append(sample)
	if not sent.is_empty():
		_deliver.call(sent)
	if not samples.is_empty():
		_keep(samples, p_late_usec)
	_asking.unlock()


func _keep(p_samples: Array[PoseSample], p_late_usec: float) -> void:
	_mutex.lock()
	for sample: PoseSample in p_samples:
		var lane: Lane = _lanes[sample.person]
		lane.waiting.append(sample)
		if lane.waiting.size() > MAX_WAITING:
			lane.waiting.pop_front()
		lane.taken += 1
	# The stats are those of the first minutes: enough to judge a machine by.
	if _lateness.count() < 20000:
		_lateness.add(p_late_usec)
	_mutex.unlock()


## Unix time, µs.
static func _now() -> float:
	return Time.get_unix_time_from_system() * 1e6

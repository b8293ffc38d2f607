extends TestCase
## Sampling in a thread of its own: at exact times, in phase with another clock.

const PERIOD: float = 1e6 / 120.0

var _sampler: MotionSampler = MotionSampler.new()
var _mutex: Mutex = Mutex.new()
var _delivered: Array[PoseSample] = []
var _threads: Dictionary[int, bool] = {}


func after_each() -> void:
	_sampler.stop()


## A source that has nothing to say at first.
class Shy:
	extends MotionSource
	var asked: int = 0

	func _read(_p_time_usec: int) -> PoseSample:
		asked += 1
		return null if asked <= 3 else PoseSample.new()


func test_samples_come_from_another_thread_at_even_times() -> void:
	_start(_clip(), 120.0)
	is_true(_sampler.is_running())
	await _until(40)
	_sampler.stop()
	is_false(_sampler.is_running())
	for i: int in range(1, _delivered.size()):
		equal(_delivered[i].id, _delivered[i - 1].id + 1)
		var step: float = _delivered[i].time_usec - _delivered[i - 1].time_usec
		# A machine that was held up begins anew.
		if step < PERIOD * MotionSampler.MAX_PERIODS:
			almost_equal(step, PERIOD, 2.0)
		equal(_delivered[i].find_fault(), "")
	is_false(_threads.has(OS.get_main_thread_id()))
	is_true(_sampler.stats(0)["samples"] >= 40)


## A source that asks the physics world, as far as it may.
class Walker:
	extends MotionSource
	var threads: Dictionary[int, bool] = {}

	func needs_world() -> bool:
		return true

	func _read(_p_time_usec: int) -> PoseSample:
		threads[OS.get_thread_caller_id()] = true
		return PoseSample.new()


func test_what_needs_the_world_is_sampled_where_that_may_be_asked() -> void:
	var walker: Walker = Walker.new()
	_start(_clip(), 120.0)
	_sampler.add_source(1, walker)
	for tick: int in 5:
		_sampler.sample_in_world(1000000 + 16667 * tick)
	await _until(20)
	equal(walker.threads.keys(), [OS.get_main_thread_id()])
	var times: Array = _sampler.take_samples(1).map(
		func(sample: PoseSample) -> int: return sample.time_usec
	)
	equal(times, [1000000, 1016667, 1033334, 1050001, 1066668])
	is_true(_sampler.stats(0)["samples"] >= 15, "the others go on in their thread")
	_sampler.stop()


func test_every_sample_can_be_taken_here_once() -> void:
	_start(_clip(), 120.0)
	await _until(20)
	_sampler.stop()
	var taken: Array[PoseSample] = _sampler.take_samples(0)
	equal(taken.size(), mini(_delivered.size(), MotionSampler.MAX_WAITING))
	is_true(taken.back() == _delivered.back())
	equal(_sampler.take_samples(0).size(), 0)


func test_times_are_drawn_to_the_phase_that_is_wanted() -> void:
	var due: float = 1000.0
	for phase: float in [5000.0, 123456.0, 8000.0]:
		for _step: int in 30:
			var next: float = MotionSampler.next_due(due, PERIOD, phase)
			almost_equal(next - due, PERIOD, MotionSampler.SLEW * PERIOD + 1e-6)
			due = next
		almost_equal(fposmod(due - phase + 1.0, PERIOD), 1.0, 1e-3)
	almost_equal(MotionSampler.next_due(1000.0, PERIOD, -1.0), 1000.0 + PERIOD, 1e-6)


func test_the_running_sampler_finds_the_phase() -> void:
	var phase: int = int(Time.get_unix_time_from_system() * 1e6) + 4000
	_sampler.set_phase(phase)
	_start(_clip(), 120.0)
	await _until(40)
	_sampler.stop()
	var off: float = fposmod(_delivered.back().time_usec - phase + PERIOD / 2.0, PERIOD)
	almost_equal(off - PERIOD / 2.0, 0.0, 5.0)


func test_a_source_without_motion_is_asked_again() -> void:
	_start(Shy.new(), 200.0)
	await _until(3)
	_sampler.stop()
	equal(_delivered[0].id, 0)


func test_it_can_be_stopped_twice_and_started_again() -> void:
	_sampler.stop()
	for _round: int in 3:
		_start(Shy.new(), 240.0)
	_sampler.stop()
	_sampler.stop()
	is_false(_sampler.is_running())


func test_several_sources_are_sampled_at_one_moment() -> void:
	var together: Array[Array] = []
	var take: Callable = func(samples: Array[PoseSample]) -> void:
		_mutex.lock()
		together.append(samples)
		_mutex.unlock()
		_take(samples)
	_sampler.add_source(2, _clip())
	_sampler.add_source(5, _clip())
	_sampler.start(120.0, take)
	await _until(20)
	_sampler.remove_source(2)
	var before: int = together.size()
	await _until(_delivered.size() + 5)
	_sampler.stop()
	for at: int in together.size():
		var numbers: Array = together[at].map(func(one: PoseSample) -> int: return one.person)
		equal(numbers, [2, 5] if at < before else [5])
		equal(together[at][0].time_usec, together[at][-1].time_usec)
	equal(_sampler.take_samples(2).size(), 0)
	is_true(_sampler.take_samples(5).size() > 5)


func _start(p_source: MotionSource, p_rate: float) -> void:
	_sampler.add_source(0, p_source)
	_sampler.start(p_rate, _take)


func _take(p_samples: Array[PoseSample]) -> void:
	_mutex.lock()
	_delivered.append_array(p_samples)
	_threads[OS.get_thread_caller_id()] = true
	_mutex.unlock()


func _until(p_count: int) -> void:
	var count: int = 0
	while count < p_count:
		await get_tree().process_frame
		_mutex.lock()
		count = _delivered.size()
		_mutex.unlock()


static func _clip() -> BvhSource:
	var source: BvhSource = BvhSource.new()
	source.open("res://assets/motion/01_01.bvh")
	return source

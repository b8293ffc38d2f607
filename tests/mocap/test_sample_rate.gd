extends TestCase
## Samples a second.

const BEGIN_USEC: int = 1_700_000_000_000_000

var _rate: SampleRate = SampleRate.new()


func before_each() -> void:
	_rate = SampleRate.new()


func test_even_samples_have_their_rate() -> void:
	for number: int in 100:
		_rate.add(BEGIN_USEC + number * 10000)
		is_false(_rate.is_known)
	_rate.add(BEGIN_USEC + 1000000)
	is_true(_rate.is_known)
	almost_equal(_rate.hz, 100.0, 1e-6)


func test_who_falls_silent_has_none() -> void:
	for number: int in 101:
		_rate.add(number * 10000)
	almost_equal(_rate.hz, 100.0, 1e-6)
	_rate.look(2000000)
	equal(_rate.hz, 0.0)


func test_it_begins_anew_after_a_clock_was_set() -> void:
	for number: int in 101:
		_rate.add(BEGIN_USEC + number * 10000)
	_rate.clear()
	_rate.add(5)
	is_false(_rate.is_known)
	equal(_rate.hz, 0.0)

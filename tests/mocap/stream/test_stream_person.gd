extends TestCase
## Samples of one person of a stream: which are taken, and what is counted.

const BEGIN: int = 1_700_000_000_000_000


func test_what_comes_twice_or_late_is_counted_and_left_out() -> void:
	var person: StreamPerson = StreamPerson.new("X", "1.2.3.4:5", "Eve")
	for counter: int in [1, 2, 2, 4, 3, 5, 9]:
		equal(person.take(_sample(counter), BEGIN + counter * 10000), "")
	var stats: Dictionary = person.stats()
	equal(stats["samples"], 5)
	equal(stats["twice"], 2)
	equal(stats["lost"], 4)
	equal(person.get_newest().details.counter, 9)


func test_a_sender_that_counts_anew_is_followed() -> void:
	var person: StreamPerson = StreamPerson.new()
	for counter: int in [5000, 5001, 1, 2, 3]:
		person.take(_sample(counter), BEGIN + person.stats()["samples"] * 10000)
	equal(person.stats()["samples"], 5)
	person.take(_sample(2), BEGIN + 5_000_000)
	equal(person.stats()["samples"], 6, "after a pause")


func test_a_pose_that_is_none_is_refused() -> void:
	var person: StreamPerson = StreamPerson.new()
	var sample: StreamSample = _sample(1)
	sample.pose.set_orientation(3, Quaternion(NAN, 0.0, 0.0, 1.0))
	contains(person.take(sample, BEGIN), "Head")
	sample = _sample(2)
	sample.pose.root = Vector3(1e9, 0.0, 0.0)
	not_equal(person.take(sample, BEGIN), "")
	equal(person.stats()["faulty"], 2)
	is_null(person.sample(BEGIN))


func _sample(p_counter: int) -> StreamSample:
	var sample: StreamSample = StreamSample.new()
	sample.counter = p_counter
	sample.pose = PoseSample.new()
	sample.pose.details = MotionDetails.new()
	for limb: int in Limbs.COUNT:
		sample.pose.set_orientation(limb, Quaternion.IDENTITY)
	return sample

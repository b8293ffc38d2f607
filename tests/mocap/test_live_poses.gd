extends TestCase
## Poses of a live source between those that it measured.

const BEGIN_USEC: int = 1700000000000000

var _poses: LivePoses = LivePoses.new()


func before_each() -> void:
	_poses = LivePoses.new()


func test_asked_at_any_rate_it_tells_the_motion_as_it_was() -> void:
	var told: int = 0
	var pushed: int = 0
	for step: int in 600:
		var now: int = BEGIN_USEC + roundi(step * 1e6 / 60.0)
		while BEGIN_USEC + pushed * 10000 <= now:
			_poses.push(_pose(BEGIN_USEC + pushed * 10000))
			pushed += 1
		var pose: PoseSample = _poses.at(now)
		if pose == null or step < 5:
			continue
		told += 1
		is_true(now - pose.time_usec <= 12500, "%d µs back" % (now - pose.time_usec))
		almost_equal(pose.orientation(4), _pose(pose.time_usec).orientation(4), 1e-5)
		almost_equal(pose.root, _pose(pose.time_usec).root, 1e-4)
	equal(told, 595)


func test_a_late_source_is_guessed_on_for_a_while_only() -> void:
	for number: int in 10:
		_poses.push(_pose(BEGIN_USEC + number * 10000))
	var guesses: int = 0
	for step: int in 60:
		var pose: PoseSample = _poses.at(BEGIN_USEC + 90000 + step * 16667)
		guesses += 1 if pose != null else 0
		if pose != null:
			is_true(pose.time_usec <= BEGIN_USEC + 90000 + 50000)
	is_true(guesses >= 3 and guesses <= 6, str(guesses))
	_poses.push(_pose(BEGIN_USEC + 2000000))
	_poses.push(_pose(BEGIN_USEC + 2010000))
	not_null(_poses.at(BEGIN_USEC + 2020000))


func test_poses_that_come_at_once_after_a_hold_up_are_not_flung() -> void:
	# Moments are those of arrival: the second pose was measured 16 ms after the first.
	for tail_usec: int in [200, 3000]:
		_poses.clear()
		for number: int in 3:
			_poses.push(_pose(BEGIN_USEC + number * 16667))
		var squeezed: PoseSample = _pose(BEGIN_USEC + 3 * 16667)
		squeezed.time_usec = BEGIN_USEC + 2 * 16667 + tail_usec
		_poses.push(squeezed)
		for step: int in 60:
			var pose: PoseSample = _poses.at(squeezed.time_usec + step * 2000)
			if pose != null:
				var fault: String = "%s after %d ms" % [pose.root, step * 2]
				is_true(pose.root.distance_to(squeezed.root) < 0.12, fault)
	_poses.clear()
	for number: int in 2:
		var first: PoseSample = _pose(BEGIN_USEC + number * 16667)
		first.time_usec = BEGIN_USEC + number * 200
		_poses.push(first)
	for step: int in 60:
		var pose: PoseSample = _poses.at(BEGIN_USEC + step * 2000)
		is_true(pose == null or pose.root.x < 0.02, "held: nothing tells how fast it is")


func test_a_clock_that_was_set_back_does_not_end_it() -> void:
	for number: int in 10:
		_poses.push(_pose(BEGIN_USEC + number * 10000))
	not_null(_poses.at(BEGIN_USEC + 95000))
	for number: int in 10:
		_poses.push(_pose(BEGIN_USEC - 60000000 + number * 10000))
	not_null(_poses.at(BEGIN_USEC - 60000000 + 95000))


func test_nothing_before_the_first() -> void:
	is_null(_poses.at(BEGIN_USEC))
	_poses.push(_pose(BEGIN_USEC))
	equal(_poses.at(BEGIN_USEC + 5000).time_usec, BEGIN_USEC)
	is_null(_poses.at(BEGIN_USEC + 6000))


## An arm that turns evenly, hips that travel.
func _pose(p_time_usec: int) -> PoseSample:
	var pose: PoseSample = PoseSample.new()
	var passed: float = (p_time_usec - BEGIN_USEC) / 1e6
	for limb: int in Limbs.COUNT:
		pose.set_orientation(limb, Quaternion(Vector3.UP, passed * 3.0 if limb == 4 else 0.0))
	pose.root = Vector3(passed, 1.0, 0.0)
	pose.time_usec = p_time_usec
	return pose

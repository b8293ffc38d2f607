extends TestCase
## Headset and hands of recorded people make a body that resembles theirs, and one that could be.

const Scene: GDScript = preload("headset_scene.gd")

var _scene: Scene = null
var _source: XrBodySource = null
var _figure: BodySegments = null
var _time: int = 0


func test_recorded_people_are_resembled() -> void:
	# Limits of the mean distance from the truth, m: of limbs that are not measured. The second clip
	# climbs and leans over a bar: a head does not tell where the hips are then. The third goes
	# down to the floor.
	var limits: Dictionary[String, Array] = {
		"01_01.bvh": [0.12, 0.09, 0.25],
		"01_03.bvh": [0.4, 0.18, 0.6],
		"Boxing_Toes.bvh": [0.25, 0.15, 0.5],
	}
	for clip: String in limits:
		_begin(clip)
		var sums: PackedFloat32Array = [0.0, 0.0, 0.0]
		var steps: int = mini(roundi(_scene.period() * _scene.rate), 1500)
		for _step: int in steps:
			_advance()
			sums[0] += _off(Limbs.HIPS) / steps
			sums[1] += (_off(Limbs.LEFT_LOWER_ARM) + _off(Limbs.RIGHT_LOWER_ARM)) / 2.0 / steps
			sums[2] += (_off(Limbs.LEFT_FOOT) + _off(Limbs.RIGHT_FOOT)) / 2.0 / steps
		for part: int in 3:
			var parts: Array = [clip, ["hips", "elbows", "feet"][part], sums[part]]
			is_true(sums[part] < limits[clip][part], "%s: %s are off by %f m" % parts)


func test_head_and_hands_are_where_they_are_measured() -> void:
	_begin("01_01.bvh")
	var away: int = 0
	for _step: int in 600:
		var sample: PoseSample = _advance()
		is_true(_off(Limbs.HEAD) < 0.04)
		almost_equal(sample.orientation(3), _scene.truth.orientation(3), 1e-3)
		for hand: int in [Limbs.LEFT_HAND, Limbs.RIGHT_HAND]:
			away += 1 if _off(hand) > 0.03 else 0
	is_true(away < 60, "in %d of 1200 cases a hand is out of reach" % away)


func test_joints_stay_in_their_range_and_nothing_jumps() -> void:
	for clip: String in ["01_01.bvh", "01_03.bvh", "Boxing_Toes.bvh"]:
		_begin(clip)
		var last: PackedVector3Array = PackedVector3Array()
		for step: int in 1500:
			var sample: PoseSample = _advance()
			equal(sample.find_fault(), "")
			for mount: int in BodyMounts.COUNT:
				if JointRange.knows(mount):
					var above: int = BodyMounts.LIMBS[BodyMounts.PARENTS[mount]]
					var excess: float = JointRange.excess(
						mount,
						sample.orientation(above),
						sample.orientation(BodyMounts.LIMBS[mount])
					)
					var parts: Array = [clip, BodyMounts.title(mount), excess, step]
					is_true(excess < 0.02, "%s: %s is %f rad beyond its range at %d" % parts)
			if not last.is_empty():
				var way: float = _figure.bases[0].distance_to(last[0])
				is_true(way < 0.12, "%s: the hips jump by %f m at %d" % [clip, way, step])
			last = _figure.bases.duplicate()


func test_feet_do_not_slide_on_the_ground() -> void:
	_begin("01_01.bvh")
	var slides: Statistics = Statistics.new()
	var last: PackedVector3Array = [Vector3.INF, Vector3.INF]
	for _step: int in 1800:
		var sample: PoseSample = _advance()
		for side: int in 2:
			var ball: Vector3 = _figure.tails[Limbs.FEET[side]]
			var is_on_ground: bool = ball.y < 0.03 and sample.root.y < 0.92
			if is_on_ground and last[side].is_finite():
				slides.add(Vector2(ball.x - last[side].x, ball.z - last[side].z).length() * 60.0)
			last[side] = ball if is_on_ground else Vector3.INF
	is_true(slides.count() > 500)
	is_true(slides.percentile(0.9) < 0.1, "p90 %f m/s" % slides.percentile(0.9))


func test_crouching_bends_the_knees_ahead() -> void:
	_stand(1.75)
	for step: int in 120:
		_hold(Vector3(0.0, 1.638 - minf(step * 0.01, 0.5), 0.0))
	for side: int in 2:
		var knee: Vector3 = _figure.bases[11 + 3 * side]
		var hip: Vector3 = _figure.bases[10 + 3 * side]
		# The wearer looks along -Z.
		is_true(knee.z < hip.z - 0.1, "knee %s, hip %s" % [knee, hip])
		is_true(_figure.bases[12 + 3 * side].y < 0.12)
	is_true(_figure.bases[0].y < 0.65, "hips at %f" % _figure.bases[0].y)


func test_sitting() -> void:
	_stand(1.75)
	_source.is_seated = true
	for _step: int in 120:
		_hold(Vector3(0.0, 1.18, 0.0))
	for side: int in 2:
		var knee: Vector3 = _figure.bases[11 + 3 * side]
		is_true(knee.z < _figure.bases[0].z - 0.3, "thighs point ahead: %s" % knee)
		is_true(absf(_figure.bases[12 + 3 * side].y - 0.07) < 0.06, "feet on the floor")
	is_true(absf(_figure.bases[0].y - 0.45) < 0.1, "hips at %f" % _figure.bases[0].y)


func test_height_is_measured_by_who_stands_up() -> void:
	_source = XrBodySource.new()
	_stand_at(1.2)
	for _step: int in 120:
		_hold(Vector3(0.0, 1.2, 0.0))
	almost_equal(_source.get_body().height, 1.2 / BodySize.EYE_HEIGHT, 0.03)
	for _step: int in 120:
		_hold(Vector3(0.0, 1.7, 0.0))
	almost_equal(_source.get_body().height, 1.7 / BodySize.EYE_HEIGHT, 0.03)
	is_true(_source.measured_times() >= 2)
	for _step: int in 120:
		_hold(Vector3(0.0, 1.1, 0.0))
	almost_equal(_source.get_body().height, 1.7 / BodySize.EYE_HEIGHT, 0.03, "who crouches")
	contains(XrBodySource.new(9.0).error, "between 0.8 and 2.5 m tall")


func test_trackers_pin_what_they_are_worn_on() -> void:
	_stand(1.75)
	var at: Dictionary[int, Transform3D] = {
		XrFrame.Pin.WAIST: Transform3D(Basis(Vector3.RIGHT, 0.3), Vector3(0.0, 1.0, -0.12)),
		XrFrame.Pin.LEFT_FOOT: Transform3D(Basis(Vector3.UP, 2.0), Vector3(-0.1, 0.1, -0.06)),
		XrFrame.Pin.RIGHT_FOOT: Transform3D(Basis(Vector3.UP, 1.0), Vector3(0.1, 0.1, -0.06)),
	}
	for step: int in 60:
		_hold(Vector3(0.0, 1.638, 0.0), at)
	var hips: Vector3 = _figure.bases[0]
	var foot: Vector3 = _figure.bases[12]
	almost_equal(foot, Vector3(-0.1, 0.068, 0.0), 0.03)
	# A knee comes up, the hips go to the side.
	at[XrFrame.Pin.LEFT_FOOT].origin += Vector3(0.0, 0.25, -0.2)
	at[XrFrame.Pin.WAIST].origin += Vector3(0.06, -0.02, 0.0)
	for step: int in 60:
		_hold(Vector3(0.0, 1.63, 0.0), at)
	almost_equal(_figure.bases[12], foot + Vector3(0.0, 0.25, -0.2), 0.03)
	almost_equal(_figure.bases[0], hips + Vector3(0.06, -0.02, 0.0), 0.04)


func test_without_hands_arms_hang() -> void:
	_stand(1.75)
	for step: int in 60:
		_hold(Vector3(0.0, 1.638, 0.0))
	for side: int in 2:
		var hand: Vector3 = _figure.bases[6 + 3 * side]
		is_true(hand.y < 1.0 and hand.y > 0.6, "a hand at %s" % hand)
		# Left is at -X of somebody who looks along -Z.
		is_true(hand.x * (side * 2.0 - 1.0) > 0.12, "a hand at %s" % hand)


func test_a_lost_headset_says_so() -> void:
	_source = XrBodySource.new()
	is_null(_source.sample(1000))
	contains(_source.error, "the headset is not tracked: put it on")


func _begin(p_clip: String) -> void:
	_scene = Scene.new(p_clip)
	_source = XrBodySource.new(_scene.size().height)
	_figure = BodySegments.new(_scene.size())


func _advance() -> PoseSample:
	_scene.advance()
	_source.push(_scene.frame)
	var sample: PoseSample = _source.sample(_scene.now_usec())
	_figure.solve(sample)
	return sample


func _off(p_limb: int) -> float:
	return _figure.bases[p_limb].distance_to(_scene.figure.bases[p_limb])


func _stand(p_height: float) -> void:
	_source = XrBodySource.new(p_height)
	_stand_at(p_height * BodySize.EYE_HEIGHT)


func _stand_at(p_eyes: float) -> void:
	_time = 1_000_000
	_hold(Vector3(0.0, p_eyes, 0.0))


func _hold(p_eyes: Vector3, p_pins: Dictionary[int, Transform3D] = {}) -> void:
	_time += 16_667
	var frame: XrFrame = XrFrame.new()
	frame.time_usec = _time
	frame.head.origin = p_eyes
	frame.has_head = true
	frame.has_place = true
	for pin: int in p_pins:
		frame.pins[pin] = p_pins[pin]
		frame.has_pins[pin] = 1
	_source.push(frame)
	var sample: PoseSample = _source.sample(_time)
	_figure = BodySegments.new(_source.get_body())
	_figure.solve(sample)

extends Bench
## How far the washout filter is from its formulas and the published table; what a step costs.
##
## Options: --rounds=5 (medians of the cost). Formulas: greatest difference as a part of the
## greatest value, of a step of 2 m/s² and of sines of 0.1 to 5 Hz after 60 s. Table: a car brakes
## with 3 m/s² for 4 s, scale 0.5, damping 1, third pole 0.25 rad/s (docs/motion-platform.md).

const _STEP_S: float = 1.0 / 250.0
const _AT_REST: Vector3 = Vector3(0.0, 9.81, 0.0)
const _SINES_HZ: PackedFloat64Array = [0.1, 0.2, 0.5, 1.0, 2.0, 5.0]
const _COST_CALLS: int = 50_000
# Frequency in rad/s: travel m, speed m/s, tilt degrees, share felt in the first 0.3 s, %.
const _PUBLISHED: Dictionary[float, Vector4] = {
	2.5: Vector4(0.174, 0.23, 8.8, 51.0),
	4.0: Vector4(0.074, 0.14, 8.8, 34.0),
	6.0: Vector4(0.031, 0.09, 8.8, 19.0),
}


func options() -> Dictionary:
	return {"rounds": [5, 1, 1000]}


func measure() -> void:
	_compare_steps(report)
	_compare_sines(report)
	_compare_table(report)
	_come_to_rest(report)
	_time_steps(report, option("rounds"))


func _compare_steps(p_report: BenchReport) -> void:
	for frequency: float in _PUBLISHED:
		var cueing: MotionCueing = _filter(frequency)
		var greatest: float = 0.0
		var worst: float = 0.0
		for number: int in roundi(10.0 / _STEP_S):
			var force: Vector3 = _AT_REST + (Vector3(2.0, 0, 0) if number > 0 else Vector3.ZERO)
			cueing.step(force, Vector3.ZERO, _STEP_S)
			# A jump between two samples counts as one in the middle.
			var expected: float = _step_position((number - 0.5) * _STEP_S, frequency, 0.25)
			greatest = maxf(greatest, absf(expected))
			worst = maxf(worst, absf(cueing.get_filtered_position().x - expected))
		_add_error(p_report, "step, %.1f rad/s" % frequency, worst / greatest)


func _compare_sines(p_report: BenchReport) -> void:
	for hz: float in _SINES_HZ:
		var turn: float = TAU * hz
		# s / ((s + 4)² (s + 0.25)) x 0.5, and s / (s + 1)² x 0.5, at s = i turn.
		var travel: Vector2 = _over(
			Vector2(0.0, 0.5 * turn),
			_times(_times(Vector2(4.0, turn), Vector2(4.0, turn)), Vector2(0.25, turn))
		)
		var angle: Vector2 = _over(
			Vector2(0.0, 0.5 * turn), _times(Vector2(1.0, turn), Vector2(1.0, turn))
		)
		var cueing: MotionCueing = _filter(4.0)
		var worst: Vector2 = Vector2.ZERO
		for number: int in roundi((60.0 + 3.0 / hz) / _STEP_S):
			var time: float = number * _STEP_S
			var value: float = sin(turn * time)
			cueing.step(_AT_REST + Vector3(value, 0, 0), Vector3(0.0, value, 0.0), _STEP_S)
			if time > 60.0:
				var moved: float = travel.length() * sin(turn * time + travel.angle())
				var turned: float = angle.length() * sin(turn * time + angle.angle())
				worst.x = maxf(worst.x, absf(cueing.get_filtered_position().x - moved))
				worst.y = maxf(worst.y, absf(cueing.get_filtered_attitude().y - turned))
		_add_error(p_report, "sine, %.1f Hz, travel" % hz, worst.x / travel.length())
		_add_error(p_report, "sine, %.1f Hz, rotation" % hz, worst.y / angle.length())


func _compare_table(p_report: BenchReport) -> void:
	var names: PackedStringArray = ["travel", "speed", "tilt", "felt in the first 0.3 s"]
	var units: PackedStringArray = ["m", "m/s", "deg", "%"]
	for frequency: float in _PUBLISHED:
		var found: PackedFloat64Array = _brake(frequency)
		var case: String = "braking, %.1f rad/s" % frequency
		for column: int in names.size():
			var published: float = _PUBLISHED[frequency][column]
			p_report.add(case, names[column], found[column], units[column])
			p_report.within(
				case,
				names[column] + ", from the table",
				100.0 * (found[column] / published - 1.0),
				"%",
				5.0
			)
		var exact: float = 0.0
		for number: int in 4000:
			exact = maxf(exact, 1.5 * _step_position(number * 0.001, frequency, 0.25))
		p_report.add(case, "travel by the formula", exact, "m")
		p_report.add(case, "most that is missing until tilt is there", found[4], "m/s²")


func _brake(p_frequency: float) -> PackedFloat64Array:
	var cueing: MotionCueing = _filter(p_frequency)
	var found: PackedFloat64Array = [0.0, 0.0, 0.0, 0.0, 0.0]
	var early: int = 0
	for number: int in roundi(12.0 / _STEP_S):
		var time: float = number * _STEP_S
		var brakes: bool = number > 0 and time < 4.0 + 0.5 * _STEP_S
		var force: Vector3 = _AT_REST + Vector3(0.0, 0.0, 3.0 if brakes else 0.0)
		cueing.step(force, Vector3.ZERO, _STEP_S)
		var tilt: float = cueing.get_tilt().x
		found[0] = maxf(found[0], absf(cueing.get_filtered_position().z))
		found[1] = maxf(found[1], absf(cueing.get_filtered_velocity().z))
		found[2] = maxf(found[2], absf(rad_to_deg(tilt)))
		var felt: float = cueing.get_filtered_acceleration().z - 9.81 * sin(tilt)
		if number > 0 and time <= 0.3:
			found[3] += felt / 1.5 * 100.0
			early += 1
		if brakes:
			found[4] = maxf(found[4], 1.5 - felt)
	found[3] /= early
	return found


func _come_to_rest(p_report: BenchReport) -> void:
	for name: String in MotionPlatform.PRESETS:
		var cueing: MotionCueing = MotionCueing.new()
		MotionPlatform.preset(name).apply(cueing)
		WashoutParameters.new().apply(cueing)
		var random: RandomNumberGenerator = RandomNumberGenerator.new()
		random.seed = 11
		for _second: int in 60:
			var force: Vector3 = _AT_REST
			var turn: Vector3 = Vector3.ZERO
			for axis: int in 3:
				force[axis] += random.randf_range(-8.0, 8.0)
				turn[axis] = random.randf_range(-1.0, 1.0)
			for _step: int in 250:
				cueing.step(force, turn, _STEP_S)
		for _step: int in roundi(30.0 / _STEP_S):
			cueing.step(_AT_REST, Vector3.ZERO, _STEP_S)
		var off: float = cueing.get_position().length() * 1000.0
		p_report.at_most(name, "neutral after 30 s", off, "mm", 1.0)


func _time_steps(p_report: BenchReport, p_rounds: int) -> void:
	var motion: SeatMotion = SeatMotion.new()
	for number: int in 60:
		motion.push_state(number / 60.0, Transform3D(Basis.IDENTITY, Vector3(number, 0.0, 0.0)))
	var cueing: MotionCueing = _filter(4.0)
	var sender: PlatformSender = PlatformSender.new()
	# To this machine, where nobody listens.
	var fault: String = sender.open("127.0.0.1", 9, PlatformSender.FORMAT_OWN, 250.0, cueing)
	if fault != "":
		p_report.leave_out("sender", fault)
	var wheel: ForceWheel = ForceWheel.new()
	wheel.open("")
	var calls: Dictionary[String, Callable] = {
		"filter, a step": _step.bind(cueing),
		"motion of a seat, an estimate": _estimate.bind(motion),
		"sender, a state in": _push.bind(sender),
		"wheel, forces in": _steer.bind(wheel),
	}
	for name: String in calls:
		var times: Statistics = Statistics.new()
		for _round: int in p_rounds:
			var begin: int = Time.get_ticks_usec()
			for number: int in _COST_CALLS:
				calls[name].call(number)
			times.add(float(Time.get_ticks_usec() - begin) / _COST_CALLS)
		p_report.add("cost, from a script", name, times.percentile(0.5), "us")
	p_report.add("sender, 250 Hz", "latest datagram", sender.get_latest() * 1000.0, "ms")


static func _step(_number: int, p_cueing: MotionCueing) -> void:
	p_cueing.step(_AT_REST, Vector3.ONE, _STEP_S)


static func _estimate(_number: int, p_motion: SeatMotion) -> void:
	p_motion.estimate(0.93)


static func _push(p_number: int, p_sender: PlatformSender) -> void:
	p_sender.push_state(p_number / 60.0, Transform3D.IDENTITY, p_number)


static func _steer(_number: int, p_wheel: ForceWheel) -> void:
	p_wheel.set_spring(0.5, 0.0, 0.0)
	p_wheel.apply()


func _filter(p_frequency: float) -> MotionCueing:
	var parameters: WashoutParameters = WashoutParameters.new()
	parameters.horizontal_frequency = p_frequency
	parameters.enter_time = 0.01
	var cueing: MotionCueing = MotionCueing.new()
	MotionPlatform.preset("large_hexapod").apply(cueing)
	parameters.apply(cueing)
	return cueing


func _add_error(p_report: BenchReport, p_case: String, p_part: float) -> void:
	p_report.at_most(p_case, "from the formula", p_part * 100.0, "%", 1.0)


## Position after a unit step through s / ((s + frequency)² (s + pole)), by partial fractions.
static func _step_position(p_time: float, p_frequency: float, p_pole: float) -> float:
	if p_time <= 0.0:
		return 0.0
	var apart: float = p_frequency - p_pole
	var slow: float = exp(-p_pole * p_time) / (apart * apart)
	return slow - exp(-p_frequency * p_time) * (1.0 / (apart * apart) + p_time / apart)


# Complex numbers as vectors.
static func _times(p_a: Vector2, p_b: Vector2) -> Vector2:
	return Vector2(p_a.x * p_b.x - p_a.y * p_b.y, p_a.x * p_b.y + p_a.y * p_b.x)


static func _over(p_a: Vector2, p_b: Vector2) -> Vector2:
	return _times(p_a, Vector2(p_b.x, -p_b.y)) / p_b.length_squared()

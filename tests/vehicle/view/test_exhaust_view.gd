extends TestCase
## The flaps on the exhausts bounce with the engine's revolutions.

const STEP: float = 1.0 / 60.0


func test_flaps_open_with_revolutions_and_load() -> void:
	var idle: Vector2 = _mean_and_swing(700.0, 0.05)
	var full: Vector2 = _mean_and_swing(2500.0, 1.0)
	is_true(idle.x > 0.01, "at idle they open a little: %.2f rad" % idle.x)
	is_true(full.x > idle.x + 0.4, "%.2f rad at idle, %.2f at full load" % [idle.x, full.x])
	is_true(idle.y > 0.02, "they bounce at idle: %.3f rad" % idle.y)
	is_true(full.y > 0.02, "they bounce at full load: %.3f rad" % full.y)


func test_they_are_shut_when_the_engine_is_off() -> void:
	var view: ExhaustView = _make()
	var state: VehicleState = _state(2500.0, 1.0)
	_run(view, state, 1.0)
	state.engine_on = false
	_run(view, state, 1.0)
	almost_equal(view.angles[0], 0.0, 0.001)
	almost_equal(view.angles[1], 0.0, 0.001)


func test_they_never_leave_their_stops() -> void:
	var view: ExhaustView = _make()
	for rpm: float in [0.0, 700.0, 5000.0, 1200.0]:
		var state: VehicleState = _state(rpm, 1.0)
		for _step: int in 120:
			view.advance(state, STEP)
			is_true(view.angles[0] >= 0.0 and view.angles[0] < ExhaustView.FARTHEST + 1e-4)


func test_one_that_falls_shut_says_so() -> void:
	var view: ExhaustView = _make()
	var heard: Array[int] = []
	view.flap_shut.connect(func(side: int) -> void: heard.append(side))
	var state: VehicleState = _state(2500.0, 1.0)
	_run(view, state, 1.0)
	heard.clear()
	state.engine_on = false
	_run(view, state, 1.0)
	is_true(heard.has(0) and heard.has(1))


## Mean angle and standard deviation.
func _mean_and_swing(p_rpm: float, p_load: float) -> Vector2:
	var view: ExhaustView = _make()
	var state: VehicleState = _state(p_rpm, p_load)
	_run(view, state, 1.0)
	var stats: Vector2 = Vector2.ZERO
	for _step: int in 300:
		view.advance(state, STEP)
		stats += Vector2(view.angles[0], view.angles[0] * view.angles[0]) / 300.0
	return Vector2(stats.x, sqrt(maxf(stats.y - stats.x * stats.x, 0.0)))


func _make() -> ExhaustView:
	var model: Node3D = Node3D.new()
	for name: String in ["FlapLeft", "FlapRight"]:
		var flap: Node3D = Node3D.new()
		flap.name = name
		model.add_child(flap)
	add_child(model)
	var view: ExhaustView = ExhaustView.new()
	view.configure(model, 2600.0)
	return view


static func _state(p_rpm: float, p_load: float) -> VehicleState:
	var state: VehicleState = VehicleState.new()
	state.engine_on = true
	state.rpm = p_rpm
	state.load = p_load
	return state


static func _run(p_view: ExhaustView, p_state: VehicleState, p_seconds: float) -> void:
	for _step: int in roundi(p_seconds / STEP):
		p_view.advance(p_state, STEP)

extends Bench
## What the visualizer of a vehicle costs a client: main thread a frame, its belts, how far links
## and teeth are out of step after a kilometre.
##
## Options: --vehicles=10, --frames=600. Where it runs with a display (the engine itself, not
## [code]./run bench[/code]), it is measured as well what is drawn of a tank, shadows included.

const _VIEW: PackedScene = preload("res://scenes/vehicle/tank/tank_view.tscn")
const _STEP: float = 1.0 / 60.0
## Goals: of the main thread a vehicle and frame, ms; of both belts, us; in step, mm; of what is
## drawn of one, shadows included.
const _GOAL_MS: float = 0.4
const _GOAL_BELT_USEC: float = 10.0
const _GOAL_PHASE_MM: float = 10.0
const _GOAL_DRAWS: float = 70.0
const _GOAL_PRIMITIVES: float = 150000.0
## How far away the eye is, m: near, and where strips take the links' place.
const _NEAR_M: float = 12.0
const _FAR_M: float = 41.0

var _views: Array[VehicleView] = []


func options() -> Dictionary:
	return {"vehicles": [10, 1, 100], "frames": 600}


func measure() -> void:
	_add_ground()
	for number: int in option("vehicles") as int:
		_add_view(Vector3(number * 12.0 - 60.0, 0.0, 0.0))
	await physics_frame
	await physics_frame
	_measure_frames("near", _NEAR_M, _GOAL_MS)
	_measure_frames("beyond 40 m", _FAR_M, _GOAL_MS)
	_measure_belts()
	_measure_phase()
	if DisplayServer.get_name() != "headless":
		await _measure_drawing()


func _add_ground() -> void:
	var ground: Block = Block.new()
	ground.surface = SurfaceLayers.Layer.SAND
	ground.size = Vector3(600.0, 1.0, 600.0)
	ground.position.y = -0.5
	root.add_child(ground)


func _add_view(p_at: Vector3) -> void:
	var view: VehicleView = _VIEW.instantiate()
	root.add_child(view)
	view.set_process(false)
	view.position = p_at
	view.state.engine_on = true
	view.state.rpm = 2100.0
	view.state.load = 0.7
	_views.append(view)


## All drive on, each in its own way: dust, prints, antennas, everything is busy.
func _measure_frames(p_name: String, p_away: float, p_goal: float) -> void:
	var took: Statistics = Statistics.new()
	for frame: int in option("frames") as int:
		for number: int in _views.size():
			_move(_views[number], number, frame)
		var begin: int = ThreadClock.get_usec()
		for view: VehicleView in _views:
			view.advance(_STEP, p_away)
		took.add(float(ThreadClock.get_usec() - begin) / _views.size() / 1000.0)
	report.at_most("a tank, " + p_name, "main thread a frame", took.mean(), "ms", p_goal)


func _move(p_view: VehicleView, p_number: int, p_frame: int) -> void:
	var angle: float = p_frame * 0.004 + p_number
	p_view.rotation.y = angle
	p_view.position -= p_view.basis.z * 7.0 * _STEP
	p_view.state.left_speed = 6.8
	p_view.state.right_speed = 7.2
	p_view.state.turret_yaw = sin(angle * 3.0)
	p_view.state.hatch = 0.5 + 0.5 * sin(angle)


func _measure_belts() -> void:
	var belt: TrackBelt = _views[0].sides[0].belt
	var lifts: PackedFloat32Array = [0.02, 0.0, -0.03, 0.05, 0.0, 0.01, -0.02, 0.04]
	var rounds: int = 5000
	var begin: int = ThreadClock.get_usec()
	for number: int in rounds:
		belt.lay(number * 0.013, lifts)
	var lay: float = float(ThreadClock.get_usec() - begin) / rounds
	report.at_most("belts", "both sides", lay * 2.0, "us", _GOAL_BELT_USEC)


func _measure_phase() -> void:
	var view: VehicleView = _views[0]
	view.advance(_STEP, _NEAR_M)
	var worst: float = 0.0
	for _count: int in 1000:
		view.sides[0].advance(60.0, _STEP, view.ground.lifts.slice(0, 8))
		worst = maxf(worst, _phase_error(view, 0))
	report.at_most("link to cog", "over 1 km", worst * 1000.0, "mm", _GOAL_PHASE_MM)


static func _phase_error(p_view: VehicleView, p_side: int) -> float:
	var sprocket: Node3D = p_view.find_part(["Cog_L", "Cog_R"][p_side])
	var middle: Vector2 = Vector2(sprocket.position.z, sprocket.position.y)
	var radius: float = p_view.tracks.sprocket_radius()
	var step: float = TAU / p_view.tracks.teeth
	var tooth: Vector3 = sprocket.basis * Vector3.BACK
	var worst: float = 0.0
	for place: Vector2 in p_view.sides[p_side].belt.get_outline():
		var from_middle: Vector2 = place - middle
		if from_middle.x > 0.1 and from_middle.length() <= radius:
			var off: float = from_middle.angle() - atan2(tooth.y, tooth.z)
			worst = maxf(worst, absf(wrapf(off, -step / 2.0, step / 2.0)) * radius)
	return worst


## What a tank adds to what is drawn, with the sun's shadows in one map.
func _measure_drawing() -> void:
	for view: VehicleView in _views.slice(1):
		view.free()
	_views.resize(1)
	var view: VehicleView = _views[0]
	view.transform = Transform3D.IDENTITY
	var sun: DirectionalLight3D = DirectionalLight3D.new()
	sun.shadow_enabled = true
	sun.directional_shadow_mode = DirectionalLight3D.SHADOW_ORTHOGONAL
	sun.rotation = Vector3(-0.8, 0.6, 0.0)
	root.add_child(sun)
	var camera: Camera3D = Camera3D.new()
	root.add_child(camera)
	camera.make_current()
	for away: float in [_NEAR_M, _FAR_M]:
		camera.look_at_from_position(Vector3(-0.6, 0.35, -0.7) * away, Vector3.UP)
		view.visible = false
		var without: Vector2 = await _count()
		view.visible = true
		for _frame: int in 20:
			view.advance(_STEP, away)
		var drawn: Vector2 = await _count() - without
		var name: String = "a tank at %d m" % roundi(away)
		report.at_most(name, "draws", drawn.x, "", _GOAL_DRAWS)
		report.at_most(name, "primitives", drawn.y, "", _GOAL_PRIMITIVES)


func _count() -> Vector2:
	for _frame: int in 4:
		await RenderingServer.frame_post_draw
	return Vector2(
		RenderingServer.get_rendering_info(
			RenderingServer.RENDERING_INFO_TOTAL_DRAW_CALLS_IN_FRAME
		),
		RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_TOTAL_PRIMITIVES_IN_FRAME)
	)

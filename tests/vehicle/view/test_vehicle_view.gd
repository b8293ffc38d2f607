extends TestCase
## What is seen of a tank follows its state and the ground, whatever the rate of pictures.

const STEP: float = 1.0 / 60.0

var _view: VehicleView = null


func test_turret_gun_and_hatches_follow_the_state() -> void:
	_make()
	_view.state.turret_yaw = 0.7
	_view.state.gun_pitch = 0.2
	_view.state.hatch = 1.0
	_run(0.1)
	almost_equal(_view.find_part("Turret").rotation.y, 0.7, 1e-4)
	var ahead: Vector3 = _view.find_part("Muzzle").global_position
	ahead -= _view.find_part("Gun").global_position
	almost_equal(ahead.normalized().y, sin(0.2), 0.02, "the gun points up")
	is_true(ahead.x < -1.0, "anticlockwise from above is to the left of -Z")
	almost_equal(_view.find_part("HatchCommander").rotation.x, TurretView.HATCH_ANGLE, 1e-4)
	almost_equal(_view.find_part("HatchLoader").rotation.x, 0.0, 1e-4)


func test_a_shot_throws_the_barrel_back_and_it_returns() -> void:
	_make()
	var barrel: Node3D = _view.find_part("Barrel")
	var rest: float = barrel.position.z
	_view.show_shot()
	var farthest: float = 0.0
	for step: int in 20:
		_view.advance(STEP, 5.0)
		farthest = maxf(farthest, barrel.position.z - rest)
	is_true(farthest > 0.25 and farthest <= 0.301, "recoil %.3f m" % farthest)
	_run(1.5)
	almost_equal(barrel.position.z, rest, 0.002)


func test_links_and_teeth_are_in_step_after_a_kilometre() -> void:
	_make()
	_view.state.left_speed = 12.5
	_view.state.right_speed = -6.25
	_run(80.0)
	for side: int in 2:
		var track: TrackView = _view.sides[side]
		almost_equal(track.way, [1000.0, -500.0][side], 0.01)
		is_true(_phase_error(side) < 0.010, "off by %.1f mm" % (_phase_error(side) * 1000.0))


func test_a_belt_goes_around_its_wheels_and_hangs() -> void:
	_add_ground(Vector3(20.0, 1.0, 20.0), Vector3(0.0, -0.5, 0.0))
	_make()
	await physics_frames(2)
	_run(0.5)
	var belt: TrackBelt = _view.sides[0].belt
	is_true(belt.get_sag() > 0.01 and belt.get_sag() < 0.12, "sag %.3f m" % belt.get_sag())
	almost_equal(belt.get_pitch(), 0.16, 0.001, "pitch")
	var lowest: float = 1.0
	for place: Vector2 in belt.get_outline():
		lowest = minf(lowest, place.y)
	almost_equal(lowest, _view.tracks.outer, 0.005, "the pads are on the ground")


func test_from_afar_a_strip_runs_in_place_of_the_links() -> void:
	_make()
	_view.advance(STEP, 39.0)
	is_false(_view.sides[0].is_strip)
	_view.advance(STEP, 41.0)
	is_true(_view.sides[0].is_strip)
	is_true(_view.sides[1].is_strip)
	_view.advance(STEP, 20.0)
	is_false(_view.sides[0].is_strip)


func test_where_little_is_drawn_the_strip_is_nearer() -> void:
	var before: QualityTier = Quality.tier
	Quality.tier = QualityTier.low()
	_make()
	_view.advance(STEP, 20.0)
	is_true(_view.sides[0].is_strip)
	Quality.tier = before
	_view.follow_quality()
	_view.advance(STEP, 20.0)
	is_false(_view.sides[0].is_strip)


func test_wheels_follow_a_step_in_the_ground() -> void:
	# Its edge is below the vehicle's middle: the wheels ahead stand on it.
	_add_ground(Vector3(20.0, 1.0, 20.0), Vector3(0.0, -0.5, 0.0))
	_add_ground(Vector3(20.0, 0.1, 10.0), Vector3(0.0, 0.05, -5.0))
	_make()
	await physics_frames(2)
	_run(0.5)
	var count: int = _view.sides[0].feet.size()
	equal(_view.ground.lifts.size(), 2 * count)
	almost_equal(_view.ground.lifts[0], 0.0, 0.01, "the rearmost wheel")
	almost_equal(_view.ground.lifts[count - 1], 0.1, 0.01, "the foremost wheel")


func test_wheels_hang_where_no_ground_is() -> void:
	_make()
	await physics_frames(2)
	_run(0.5)
	for wheel: int in _view.ground.lifts.size():
		equal(_view.ground.touching[wheel], 0)
		almost_equal(_view.ground.lifts[wheel], -_view.travel.y, 0.001)


func test_a_person_has_room_in_the_hatch() -> void:
	_make()
	var middle: Vector3 = _view.find_part("CommanderHatchMiddle").global_position
	# No part of the turret's mesh within 0.29 m of the axis, from half a metre below the ring.
	var turret: MeshInstance3D = _view.find_part("Turret") as MeshInstance3D
	for point: Vector3 in turret.mesh.get_faces():
		var place: Vector3 = turret.to_global(point) - middle
		if place.y < -0.5:
			continue
		is_true(Vector2(place.x, place.z).length() > 0.295, "%s is in the way" % place)
	var highest: float = _view.find_part("LadderLeft5").global_position.y
	is_true(highest > _view.find_part("LadderLeft1").global_position.y + 2.0)


func _phase_error(p_side: int) -> float:
	var track: TrackView = _view.sides[p_side]
	var side: String = ["L", "R"][p_side]
	var sprocket: Node3D = _view.find_part("Cog_%s" % side)
	var middle: Vector2 = Vector2(sprocket.position.z, sprocket.position.y)
	var radius: float = _view.tracks.sprocket_radius()
	var step: float = TAU / _view.tracks.teeth
	# One tooth of the mesh points along its own +Z.
	var tooth: Vector3 = sprocket.basis * Vector3.BACK
	var angle: float = atan2(tooth.y, tooth.z)
	var worst: float = 0.0
	for place: Vector2 in track.belt.get_outline():
		var from_middle: Vector2 = place - middle
		if from_middle.x < 0.1 or from_middle.length() > radius:
			continue
		var off: float = wrapf(from_middle.angle() - angle, -step / 2.0, step / 2.0)
		worst = maxf(worst, absf(off) * radius)
	is_true(worst > 0.0, "links lie on the sprocket")
	return worst


func _make() -> void:
	var scene: PackedScene = load("res://scenes/vehicle/tank/tank_view.tscn")
	_view = scene.instantiate()
	add_child(_view)
	_view.set_process(false)


func _run(p_seconds: float) -> void:
	for step: int in roundi(p_seconds / STEP):
		_view.advance(STEP, 5.0)


func _add_ground(p_size: Vector3, p_middle: Vector3) -> void:
	var ground: Block = Block.new()
	ground.size = p_size
	ground.position = p_middle
	add_child(ground)

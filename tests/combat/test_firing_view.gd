extends TestCase
## What is seen of shots and hits: recoil, tracers, marks.

var _range: FiringRange = null
var _view: FiringView = null


func before_each() -> void:
	_range = FiringRange.new(self)
	await _range.settle()
	_view = FiringView.create(_range.shells)
	_range.tank.add_child(_view)


func after_each() -> void:
	_range.free_all()


func test_a_shot_moves_the_barrel_and_is_seen_until_it_hits() -> void:
	var scene: PackedScene = load("res://scenes/vehicle/tank/tank_view.tscn")
	var shown: VehicleView = scene.instantiate()
	_range.tank.add_child(shown)
	_range.ground.add_box(
		Vector3(80.0, 60.0, 1.0), Transform3D(Basis.IDENTITY, Vector3(0.0, 20.0, -400.0))
	)
	_range.command(&"fire")
	equal(_view.tracers.count(), 1)
	is_true(shown.turret.since_shot < 1.0)
	await _range.ground.run(0.1)
	equal(_view.tracers.count(), 1)
	await _range.ground.run(0.4)
	equal(_range.hits.size(), 1)
	equal(_view.tracers.count(), 0)
	equal(_view.marks.made, 1)


func test_every_fifth_round_shines_and_stops_where_it_hits() -> void:
	_range.ground.add_box(
		Vector3(80.0, 60.0, 1.0), Transform3D(Basis.IDENTITY, Vector3(0.0, 20.0, -300.0))
	)
	_range.command(&"fire_coax", [1.0])
	var most: int = 0
	for _tick: int in 120:
		await _range.ground.run(1.0 / 60.0)
		most = maxi(most, _view.tracers.count())
	is_true(most >= 1 and most <= 2, "%d tracers" % most)
	_range.command(&"fire_coax", [0.0])
	await _range.ground.run(1.5)
	equal(_view.tracers.count(), 0)


func test_there_is_no_mark_on_what_moves() -> void:
	var ball: Ammunition = _range.coax.ammunition[0]
	var crate: RigidBody3D = _range.add_crate(Vector3(0.0, 0.4, -20.0))
	await _range.ground.run(0.5)
	_range.shells.struck.emit(crate.position + Vector3(0.0, 0.4, 0.0), Vector3.UP, &"wood", ball)
	equal(_view.marks.made, 0)
	_range.shells.struck.emit(Vector3(5.0, 0.0, -20.0), Vector3.UP, &"sand", ball)
	equal(_view.marks.made, 1)
	# A normal that is none, as a forged event may have.
	_range.shells.struck.emit(Vector3(5.0, 0.0, -20.0), Vector3.ZERO, &"sand", ball)
	equal(_view.marks.made, 1)


func test_marks_and_tracers_are_bounded() -> void:
	var dart: Ammunition = _range.gun.ammunition[0]
	for number: int in 500:
		_view.marks.make(Vector3(number, 0.0, 0.0), Vector3.UP, 1.0)
		_view.tracers.add(dart, Vector3.ZERO, Vector3.UP * 1000.0)
	equal(_view.tracers.count(), Tracers.MAX_SHOWN)
	await _range.ground.run(0.1)
	_view.tracers.add(dart, Vector3(NAN, 0.0, 0.0), Vector3.UP)
	equal(_view.tracers.count(), Tracers.MAX_SHOWN)


func test_axes_face_the_way_that_is_asked_for() -> void:
	for way: Vector3 in [
		Vector3.UP, Vector3.DOWN, Vector3.RIGHT, Vector3.BACK, Vector3(0, 0.6, 0.8)
	]:
		var axes: Basis = ImpactMarks.upward(way)
		almost_equal(axes.y, way, 1e-5)
		almost_equal(axes.determinant(), 1.0, 1e-5)


func test_what_was_fired_is_seen_when_the_vehicle_is_gone() -> void:
	_view.free()
	FiringView.begin(_range.shells)
	var player: EffectPlayer = EffectPlayer.of(_range.tank)
	is_false(_range.tank.is_ancestor_of(player))
	var view: FiringView = null
	for child: Node in player.get_children():
		view = child as FiringView if child is FiringView else view
	_range.command(&"fire")
	_range.shells.struck.emit(
		Vector3(5.0, 0.0, -20.0), Vector3.UP, &"sand", _range.gun.ammunition[0]
	)
	equal(view.tracers.count(), 1)
	equal(player.playing("muzzle_flash"), 1)
	equal(player.playing("impact"), 1)
	_range.tank.free()
	await process_frames(3)
	is_true(is_instance_valid(view), "marks and tracers are still there")
	equal(view.marks.made, 1)
	equal(player.playing("impact"), 1)
	view._process(ImpactMarks.LASTING_S + 1.0)
	await process_frames(2)
	is_false(is_instance_valid(view), "and go when they have faded")


func test_each_material_has_its_impact() -> void:
	var player: EffectPlayer = EffectPlayer.of(_view)
	var dart: Ammunition = _range.gun.ammunition[0]
	var cases: Dictionary[StringName, String] = {
		&"wood": "impact_wood",
		&"metal": "impact_metal",
		&"glass": "impact_glass",
		&"person": "impact_soft",
		&"sand": "impact",
		&"unheard_of": "impact",
	}
	for surface: StringName in cases:
		var before: int = player.playing(cases[surface])
		_range.shells.struck.emit(Vector3(5.0, 0.0, -20.0), Vector3.UP, surface, dart)
		is_true(player.playing(cases[surface]) > before, surface)
	is_true(player.playing("sparks") >= 1)
	is_true(player.playing("debris") >= 1)

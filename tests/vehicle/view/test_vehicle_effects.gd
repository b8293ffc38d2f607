extends TestCase
## What surrounds a vehicle: dust, fumes, prints, antennas, lamps, damage.

const STEP: float = 1.0 / 60.0

var _view: VehicleView = null


func test_dust_rises_where_tracks_run_on_sand() -> void:
	await _make_on(SurfaceLayers.Layer.SAND)
	_run(0.3)
	almost_equal(_dust(0), 0.0, 0.001, "standing")
	_drive(3.0, 1.0)
	var slow: float = _dust(0)
	is_true(slow > 0.05, "slow: %.2f" % slow)
	_drive(9.0, 1.0)
	is_true(_dust(0) > slow + 0.3, "fast: %.2f, slow: %.2f" % [_dust(0), slow])
	equal(_view.effects.dust[0].surface, &"sand")


func test_none_rises_on_concrete() -> void:
	await _make_on(SurfaceLayers.Layer.CONCRETE)
	_drive(10.0, 1.0)
	equal(_view.effects.dust[0].surface, &"concrete")
	almost_equal(_dust(0), 0.0, 0.001)
	almost_equal(_dust(1), 0.0, 0.001)
	equal(_view.effects.marks.laid, 0, "and no prints stay")


func test_none_rises_where_no_wheel_touches() -> void:
	await _make_on(SurfaceLayers.Layer.SAND)
	_view.position.y = 1.5
	_drive(9.0, 0.5)
	almost_equal(_dust(0), 0.0, 0.001)


func test_only_the_side_that_touches_is_dusty() -> void:
	await _make_on(SurfaceLayers.Layer.SAND, Vector3(10.0, 1.0, 400.0), Vector3(-5.0, -0.5, 0.0))
	_drive(9.0, 0.5)
	is_true(_dust(0) > 0.5, "left: %.2f" % _dust(0))
	almost_equal(_dust(1), 0.0, 0.001, "right")


func test_a_track_that_spins_in_place_throws_up_dust() -> void:
	await _make_on(SurfaceLayers.Layer.SAND)
	_view.state.left_speed = 4.0
	_run(0.5)
	is_true(_dust(0) > 0.3, "%.2f" % _dust(0))


func test_dust_has_the_colour_of_its_ground() -> void:
	await _make_on(SurfaceLayers.Layer.SAND)
	_drive(9.0, 1.0)
	for node: Node in _view.find_children("*", "LayeredEffect", true, false):
		var shown: LayeredEffect = node as LayeredEffect
		if shown.effect != "track_dust":
			continue
		var motion: ShaderMaterial = shown.parts[0].process_material as ShaderMaterial
		var sand: Color = ContactMaterial.named(&"sand").dust_color
		almost_equal(motion.get_shader_parameter(&"earth"), Vector3(sand.r, sand.g, sand.b), 1e-4)
		almost_equal(motion.get_shader_parameter(&"speed"), 9.0, 0.5)


func test_prints_stay_behind_in_sand_and_their_number_is_bounded() -> void:
	await _make_on(SurfaceLayers.Layer.SAND, Vector3(100.0, 1.0, 2000.0))
	_drive(12.0, 1.0)
	var laid: int = _view.effects.marks.laid
	almost_equal(laid, 2.0 * 12.0 / TrackMarks.PIECE_M, 8.0, "12 m on two sides")
	_drive(12.0, 20.0)
	var marks: TrackMarks = _view.effects.marks
	is_true(marks.laid > TrackMarks.PIECES, "%d laid" % marks.laid)
	var found: Array[Node] = _view.find_children("*", "MultiMeshInstance3D", true, false)
	var most: int = 0
	for node: Node in found:
		most = maxi(most, (node as MultiMeshInstance3D).multimesh.instance_count)
	equal(most, TrackMarks.PIECES)


func test_a_teleport_leaves_no_print_across_the_world() -> void:
	await _make_on(SurfaceLayers.Layer.SAND)
	_drive(5.0, 1.0)
	var laid: int = _view.effects.marks.laid
	_view.position.x += 60.0
	_view.state.left_speed = 5.0
	_run(STEP)
	equal(_view.effects.marks.laid, laid)


func test_fumes_follow_revolutions_and_load() -> void:
	await _make_on(SurfaceLayers.Layer.SAND)
	var state: VehicleState = _view.state
	_run(0.2)
	almost_equal(_view.effects.fumes.amount, 0.0, 0.001, "engine off")
	state.engine_on = true
	state.rpm = 700.0
	_run(3.0)
	var idle: float = _view.effects.fumes.amount
	var pale: float = _view.effects.fumes.darkness
	state.rpm = 2500.0
	state.load = 1.0
	_run(3.0)
	is_true(_view.effects.fumes.amount > idle + 0.3)
	is_true(_view.effects.fumes.darkness > pale + 0.2)


func test_a_sudden_load_smokes_most() -> void:
	await _make_on(SurfaceLayers.Layer.SAND)
	_view.state.engine_on = true
	_view.state.rpm = 900.0
	_run(2.0)
	_view.state.load = 1.0
	_run(0.1)
	var sudden: float = _view.effects.fumes.darkness
	_run(5.0)
	is_true(sudden > _view.effects.fumes.darkness + 0.2)


func test_antennas_bend_back_when_it_starts_and_come_to_rest() -> void:
	await _make_on(SurfaceLayers.Layer.SAND)
	var speed: float = 0.0
	var most: float = 0.0
	for step: int in 60:
		speed += 3.0 * STEP
		_step(speed)
		most = maxf(most, _view.effects.antennas.sway.y)
	is_true(most > 0.01, "to the rear: %.3f" % most)
	_view.state.left_speed = 0.0
	for step: int in 60 * 12:
		_step(speed)
	is_true(_view.effects.antennas.sway.length() < 0.004, "at rest again")


func test_lamps_shine_when_they_are_on() -> void:
	await _make_on(SurfaceLayers.Layer.SAND)
	_run(STEP)
	is_false(_view.effects.lamps.is_lit())
	_view.state.lamps = true
	_run(STEP)
	is_true(_view.effects.lamps.is_lit())
	var beams: Array[Node] = _view.find_children("*", "SpotLight3D", true, false)
	equal(beams.size(), 2)
	is_true((beams[0] as SpotLight3D).visible)


func test_what_is_hit_smokes_and_what_is_knocked_out_burns() -> void:
	await _make_on(SurfaceLayers.Layer.SAND)
	var damage: DamageView = _view.effects.damage
	_run(0.1)
	is_false(damage.is_smoking())
	_view.state.damage = VehicleState.Damage.DAMAGED
	_run(3.0)
	is_true(damage.is_smoking())
	is_false(damage.is_burning())
	almost_equal(damage.scorch, DamageView.SCORCH[1], 1e-3)
	_view.state.damage = VehicleState.Damage.KNOCKED_OUT
	_run(3.0)
	is_true(damage.is_burning())
	almost_equal(damage.scorch, 1.0, 1e-3)
	_view.state.damage = VehicleState.Damage.WHOLE
	_run(0.1)
	is_false(damage.is_smoking() or damage.is_burning())
	almost_equal(damage.scorch, 0.0, 1e-3)


func test_one_that_burns_leaves_others_whole() -> void:
	await _make_on(SurfaceLayers.Layer.SAND)
	var other: VehicleView = _instantiate()
	_view.state.damage = VehicleState.Damage.KNOCKED_OUT
	_run(3.0)
	var hull: MeshInstance3D = other.find_part("Hull") as MeshInstance3D
	var shared: ShaderMaterial = hull.mesh.surface_get_material(0) as ShaderMaterial
	is_true(hull.material_override == null)
	is_true(shared.get_shader_parameter(&"scorch") in [null, 0.0])


func _dust(p_side: int) -> float:
	return _view.effects.dust[p_side].amount


func _make_on(
	p_surface: SurfaceLayers.Layer,
	p_size: Vector3 = Vector3(100.0, 1.0, 400.0),
	p_middle: Vector3 = Vector3(0.0, -0.5, 0.0)
) -> void:
	var ground: Block = Block.new()
	ground.surface = p_surface
	ground.size = p_size
	ground.position = p_middle
	add_child(ground)
	_view = _instantiate()
	await physics_frames(2)


func _instantiate() -> VehicleView:
	var scene: PackedScene = load("res://scenes/vehicle/tank/tank_view.tscn")
	var view: VehicleView = scene.instantiate()
	add_child(view)
	view.set_process(false)
	return view


func _drive(p_speed: float, p_seconds: float) -> void:
	for _count: int in roundi(p_seconds / STEP):
		_step(p_speed)


func _step(p_speed: float) -> void:
	_view.state.left_speed = p_speed
	_view.state.right_speed = p_speed
	_view.position.z -= p_speed * STEP
	_view.advance(STEP, 5.0)


func _run(p_seconds: float) -> void:
	for _count: int in maxi(roundi(p_seconds / STEP), 1):
		_view.advance(STEP, 5.0)

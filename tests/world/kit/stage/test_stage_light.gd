extends TestCase
## A stage's light burns by day and more at dusk; its beam is a cone along -Z.


func test_it_burns_less_by_day() -> void:
	var light: StageLight = StageLight.new()
	light.strength = 2.0
	light.by_day = 0.5
	almost_equal(light.get_strength_now(), 1.0, 1e-4)
	light.set_lamp_strength(1.0)
	almost_equal(light.get_strength_now(), 2.0, 1e-4)
	light.set_lamp_strength(7.0)
	almost_equal(light.get_strength_now(), 2.0, 1e-4)
	light.set_lamp_strength(-7.0)
	almost_equal(light.get_strength_now(), 1.0, 1e-4)
	light.free()


func test_the_worlds_lamps_reach_it() -> void:
	var light: StageLight = StageLight.new()
	add_child(light)
	get_tree().call_group(WorldSky.LAMPS, &"set_lamp_strength", 1.0)
	almost_equal(light.get_strength_now(), light.strength, 1e-4)
	light.free()


func test_the_beam_opens_by_its_angle() -> void:
	var box: AABB = StageLight.make_beam(deg_to_rad(45.0), 10.0).get_aabb()
	almost_equal(box.position.z, -10.2, 0.01)
	almost_equal(box.size.x, 2.0 * 10.1, 0.2)
	is_true(box.end.z < -0.1, "it begins behind its lens: %s" % box)


func test_its_tube_throws_no_shadow_on_what_it_lights() -> void:
	var light: StageLight = StageLight.new()
	var mesh: BlockMesh = BlockMesh.new()
	light.build(mesh, &"")
	var lamp: SpotLight3D = light.make_light()
	var front: float = INF
	for point: Vector3 in mesh.get_points():
		front = minf(front, point.z)
	is_true(lamp.position.z < front, "the tube ends at %s, behind %s" % [front, lamp.position.z])
	lamp.free()
	light.free()

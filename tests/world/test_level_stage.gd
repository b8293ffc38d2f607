extends TestCase
## The stage: where its people start, who they are shown as, and what its screen shows.

var _stage: Level = null


func before_each() -> void:
	_stage = LevelStore.instantiate("stage")
	add_child(_stage)
	await physics_frames(2)


func after_each() -> void:
	_stage.free()


func test_performers_stand_on_the_podium_and_face_the_audience() -> void:
	var podium: StagePodium = _stage.get_node(^"Static/StagePodium1")
	var points: Array[SpawnPoint] = _stage.get_spawn_points()
	var on_it: int = 0
	for point: SpawnPoint in points:
		var above: Vector3 = podium.to_local(point.global_position)
		if absf(above.y - podium.size.y) < 0.01:
			on_it += 1
			almost_equal(point.global_basis.z, Vector3.BACK, 1e-3)
		else:
			almost_equal(point.global_basis.z, Vector3.FORWARD, 1e-3)
	is_true(on_it >= 4 and points.size() - on_it >= 8, "%d of %d" % [on_it, points.size()])
	# The first who comes performs.
	almost_equal(podium.to_local(points[0].global_position).y, podium.size.y, 0.01)


func test_people_without_an_avatar_are_shown_as_performers() -> void:
	equal(_stage.default_avatar, "show")
	equal(_stage._get_configuration_warnings(), PackedStringArray())
	_stage.default_avatar = "elvis"
	contains(_stage._get_configuration_warnings()[0], "There is no avatar 'elvis'")


func test_the_screens_camera_films_who_stands_on_the_podium() -> void:
	var screen: CameraScreen = _stage.get_node(^"Static/CameraScreen1")
	var camera: FilmCamera = screen.find_camera()
	for point: SpawnPoint in _stage.get_spawn_points():
		var hips: Vector3 = point.global_position + Vector3.UP
		equal(camera.choose([hips]), 0 if point.global_position.y > 1.0 else -1, point.name)


func test_no_mesh_gets_more_lights_than_compatibility_has() -> void:
	var lighting: int = 0
	for node: Node in _stage.find_children("*", "StaticBody3D"):
		if node is StageLight and node.is_lighting:
			lighting += 1
	is_true(lighting >= 5 and lighting <= 8, "%d lights" % lighting)

extends TestCase
## Roads are solid, their kerbs have gaps, paint is on the road and nowhere else.

var _road: Road = null


func before_each() -> void:
	_road = Road.new()
	_road.size = Vector2(6.0, 12.0)
	add_child(_road)


func after_each() -> void:
	_road.free()


func test_it_is_solid_to_its_edges_and_kerbs_beside_it() -> void:
	_road.left_gaps = [Vector2(4.0, 7.0)]
	await physics_frames(2)
	almost_equal(_height_at(0.0, -6.0), _road.height, 0.001)
	almost_equal(_height_at(2.95, -11.95), _road.height, 0.001)
	var kerb: float = _road.height + Road.KERB_M.y
	almost_equal(_height_at(3.1, -5.5), kerb, 0.001, "the right kerb has no gap")
	almost_equal(_height_at(-3.1, -3.9), kerb, 0.001, "the left one before its gap")
	is_true(is_nan(_height_at(-3.1, -5.5)), "the gap")
	almost_equal(_height_at(-3.1, -7.1), kerb, 0.001, "behind its gap")
	is_true(is_nan(_height_at(0.0, 0.1)), "before its end")
	is_true(is_nan(_height_at(0.0, -12.1)), "behind its end")


func test_gaps_leave_the_rest() -> void:
	var left: PackedVector2Array = Road.pieces_between([Vector2(6, 8), Vector2(-1, 2)], 10.0)
	equal(left, PackedVector2Array([Vector2(2, 6), Vector2(8, 10)]))
	equal(Road.pieces_between([], 5.0), PackedVector2Array([Vector2(0, 5)]))
	equal(Road.pieces_between([Vector2(0, 9)], 5.0), PackedVector2Array())
	equal(
		Road.pieces_between([Vector2(1, 4), Vector2(2, 3)], 5.0),
		PackedVector2Array([Vector2(0, 1), Vector2(4, 5)])
	)


func test_paint_lies_on_the_road() -> void:
	_road.has_left_kerb = false
	_road.has_right_kerb = false
	var plain: int = _triangles(Road.Markings.NONE)
	var seen: Array[int] = [plain]
	for markings: Road.Markings in [
		Road.Markings.MIDDLE, Road.Markings.MIDDLE_AND_SIDES, Road.Markings.CROSSING
	]:
		for width: float in [1.0, 3.3, 6.0, 30.0]:
			_road.size = Vector2(width, 12.0)
			is_true(_triangles(markings) > plain, "%s, %.1f m" % [markings, width])
			var area: AABB = AABB(
				Vector3(-width / 2.0, 0.0, -12.0), Vector3(width, _road.height + 0.01, 12.0)
			)
			for point: Vector3 in _mesh().get_points():
				if not area.grow(0.001).has_point(point):
					fail("%s, %.1f m wide: paint at %s" % [markings, width, point])
					break
	_road.surface = Road.Surface.GRAVEL
	_road.size = Vector2(6.0, 12.0)
	equal(_triangles(Road.Markings.CROSSING), plain, "gravel cannot be painted")


func test_what_does_not_fit_warns() -> void:
	equal(_road._get_configuration_warnings(), PackedStringArray())
	_road.right_gaps = [Vector2(3.0, 14.0)]
	contains(_road._get_configuration_warnings()[0], "within the length")
	_road.right_gaps = []
	_road.surface = Road.Surface.DIRT
	contains(_road._get_configuration_warnings()[0], "Only asphalt is painted")
	_road.markings = Road.Markings.NONE
	_road.rotation.x = 0.2
	contains(_road._get_configuration_warnings()[0], "level ground")


func _triangles(p_markings: Road.Markings) -> int:
	_road.markings = p_markings
	return _mesh().get_triangle_count()


func _mesh() -> BlockMesh:
	var mesh: BlockMesh = KitBlock.make_mesh(false)
	mesh.set_finest(100.0)
	_road.build(mesh, KitBlock.OUTSIDE)
	return mesh


func _height_at(p_x: float, p_z: float) -> float:
	var query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		Vector3(p_x, 2.0, p_z), Vector3(p_x, -1.0, p_z)
	)
	var hit: Dictionary = _road.get_world_3d().direct_space_state.intersect_ray(query)
	return hit["position"].y if not hit.is_empty() else NAN

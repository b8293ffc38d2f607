extends TestCase
## The camera enters nobody's mesh: not that of whom it follows, nor that of somebody beside.

const _PERSON: PackedScene = preload("res://scenes/actor/person.tscn")
## Every so many-th point of the mesh is looked at.
const _THIN: int = 7
## From where on something is drawn, m: no point of the mesh may be nearer.
const _NEAR_M: float = 0.05
## A point with mesh within this width in all six directions is in a body, m.
const _BEAM_M: float = 0.05

var _camera: OrbitCamera = null
var _person: Ragdoll = null
var _view: ActorView = null
var _points: PackedVector3Array = []
var _hips: Vector3 = Vector3.ZERO


func before_each() -> void:
	_camera = OrbitCamera.new()
	add_child(_camera)
	_person = _PERSON.instantiate()
	add_child(_person)
	_view = ActorView.new(_person, _person.get_joints())
	var skeleton: Skeleton3D = _person.get_skeleton()
	var surface: SkinnedSurface = SkinnedSurface.new(RestSkeleton.new(skeleton))
	_hips = skeleton.get_bone_global_pose(skeleton.find_bone(&"Hips")).origin
	_points.clear()
	var count: int = 0
	for limb: PackedVector3Array in surface.points:
		for point: Vector3 in limb:
			count += 1
			if count % _THIN == 0:
				_points.append(point)


func after_each() -> void:
	_person.free()
	_camera.free()


func test_it_stays_out_of_whom_it_follows() -> void:
	_camera.has_head = true
	_camera.head = _view.head()
	_camera.target = _hips
	equal(_find_cameras_in_mesh([0.5, 0.8, 1.3]), [])


func test_it_stays_out_of_somebody_beside() -> void:
	_camera.target = Vector3(0.0, 1.1, 1.2)
	equal(_find_cameras_in_mesh([1.0, 1.2, 1.4]), [])


func test_without_bodies_it_is_where_it_was_put() -> void:
	for far: float in [0.5, 2.0, 7.0]:
		equal(_camera.set_from_text("20,10,%s" % far), "")
		_camera.snap()
		_camera._process(0.016)
		almost_equal(_camera.position.distance_to(_camera.target), far, 1e-3)


func test_the_check_sees_a_camera_in_a_body() -> void:
	is_true(_is_in_mesh(_hips + Vector3.UP * 0.3), "chest")
	is_true(_is_in_mesh(_view.head() * Vector3(0.0, 0.08, 0.02)), "head")
	is_false(_is_in_mesh(Vector3(0.0, 1.2, 1.5)))


func _find_cameras_in_mesh(p_distances: Array[float]) -> Array[String]:
	_view.hull.append_to(_camera.capsule_ends, _camera.capsule_radii)
	var found: Array[String] = []
	for far: float in p_distances:
		for azimuth: int in range(0, 360, 45):
			for elevation: int in [-80, -50, -20, 10, 40, 80]:
				equal(_camera.set_from_text("%d,%d,%s" % [azimuth, elevation, far]), "")
				_camera.snap()
				_camera._process(0.016)
				if _is_in_mesh(_camera.position):
					found.append("%d,%d,%s" % [azimuth, elevation, far])
	return found


func _is_in_mesh(p_eye: Vector3) -> bool:
	var walls: Dictionary[int, bool] = {}
	for point: Vector3 in _points:
		var way: Vector3 = point - p_eye
		if way.length_squared() < _NEAR_M * _NEAR_M:
			return true
		var axis: int = way.abs().max_axis_index()
		var aside: Vector3 = way
		aside[axis] = 0.0
		if aside.length_squared() < _BEAM_M * _BEAM_M:
			walls[axis * 2 + int(way[axis] > 0.0)] = true
	return walls.size() == 6

extends TestCase
## Views of a level: a client's camera goes to them and comes back, and they never take over.

var _own: OrbitCamera = null
var _view: ObserverCamera = null


func before_each() -> void:
	_own = OrbitCamera.new()
	_own.fov = 60.0
	add_child(_own)
	_own.make_current()
	_view = ObserverCamera.new()
	_view.name = "GateView"
	_view.position = Vector3(30.0, 5.0, -4.0)
	_view.fov = 40.0
	_view.current = true
	add_child(_view)


func after_each() -> void:
	if is_instance_valid(_view):
		_view.free()
	_own.free()


func test_it_does_not_take_over() -> void:
	is_true(_own.current)
	is_false(_view.current)
	equal(_view.get_title(), "Gate View")


func test_there_and_back() -> void:
	_own._process(0.1)
	var before: Vector3 = _own.position
	_own.fixed = _view
	_own._process(0.1)
	equal([_own.global_position, _own.fov], [_view.position, 40.0])
	_own.fixed = null
	_own._process(0.0)
	almost_equal(_own.position, before, 0.01)
	equal(_own.fov, 60.0)


func test_a_view_that_goes_with_its_level() -> void:
	_own.fixed = _view
	_view.free()
	_own._process(0.1)
	is_true(_own.position.distance_to(_own.target) < 10.0)


func test_a_level_knows_its_views() -> void:
	var level: Level = Level.new()
	level.add_child(ObserverCamera.new())
	level.get_child(0).name = "First"
	add_child(level)
	equal(level.get_cameras().size(), 1)
	level.free()

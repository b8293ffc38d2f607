extends TestCase
## What is out of sight is not drawn, and neither is a shadow that falls on nothing that is.

## Two cells side by side along X; each has a part, which is a square of shadows too, and neither
## sees the other.
const CELL_M: float = 24.0

var _level: Node3D = null
var _surfaces: LevelSurfaces = null
var _visibility: LevelVisibility = null
var _sun: DirectionalLight3D = null


func before_each() -> void:
	_level = Node3D.new()
	add_child(_level)
	_sun = DirectionalLight3D.new()
	_level.add_child(_sun)
	_shine(Vector3.UP)
	_surfaces = LevelSurfaces.new()
	_surfaces.bake = _bake()
	for cell: int in 2:
		var from: Vector3 = Vector3(CELL_M * cell + 2.0, 0.0, 2.0)
		var mesh: BlockMesh = KitBlock.make_mesh(false)
		mesh.box(from, from + Vector3(20.0, 6.0, 20.0), 0, 0)
		_surfaces.shown.append(_add_instance())
		_surfaces.shadows.append(_add_instance())
		_surfaces.reach.add_part(mesh)
	_surfaces.reach.gather()
	equal(_surfaces.reach.get_caster_count(), 2)
	_level.add_child(_surfaces)
	_visibility = LevelVisibility.new()
	_visibility.surfaces = _surfaces
	_visibility.sun = LevelVisibility.find_sun(_level)
	_surfaces.add_child(_visibility)
	_visibility.set_process(false)


func after_each() -> void:
	_level.free()


func test_parts_are_shown_where_they_are_seen() -> void:
	_visibility.look_from([_middle(0)])
	equal(_shown(_surfaces.shown), [true, false])
	_visibility.look_from([_middle(1)])
	equal(_shown(_surfaces.shown), [false, true])
	_visibility.look_from([Vector3(0.0, 500.0, 0.0)])
	equal(_shown(_surfaces.shown), [true, true], "where no cell is, all is shown")
	_visibility.look_from([_middle(0), _middle(1)])
	equal(_shown(_surfaces.shown), [true, true], "another camera sees the other part")
	_visibility.look_from([_middle(0)])
	_visibility.is_active = false
	_visibility.look_from([_middle(0)])
	equal(_shown(_surfaces.shown), [true, true])


func test_shadows_are_thrown_where_they_fall_on_what_is_drawn() -> void:
	_visibility.look_from([_middle(0)])
	equal(_shown(_surfaces.shadows), [true, false], "from above they fall on their own place")
	_shine(Vector3(1.0, 0.6, 0.0))
	_visibility.look_from([_middle(0)])
	equal(_shown(_surfaces.shadows), [true, true], "the other stands between it and the sun")
	_shine(Vector3(-1.0, 0.3, 0.0))
	_visibility.look_from([_middle(0)])
	equal(_shown(_surfaces.shadows), [true, false])
	_shine(Vector3(-1.0, 0.01, 0.0))
	_visibility.look_from([_middle(0)])
	equal(_shown(_surfaces.shadows), [true, true], "a low sun throws them without end")


func test_shadows_that_the_camera_does_not_see_are_not_thrown() -> void:
	var camera: Camera3D = _open_camera()
	var prop: Node3D = _prop(Vector3(40.0, 0.5, 12.0))
	var crate: MeshInstance3D = _add_crate(prop)
	var eye: Vector3 = Vector3(25.0, 3.0, 12.0)
	camera.look_at_from_position(eye, eye + Vector3.RIGHT)
	_visibility.look_from([eye], camera)
	equal(_shown(_surfaces.shadows), [false, true])
	equal(crate.cast_shadow, GeometryInstance3D.SHADOW_CASTING_SETTING_ON)
	camera.look_at_from_position(eye, eye + Vector3.LEFT)
	_visibility.look_from([eye], camera)
	equal(_shown(_surfaces.shadows), [true, false])
	equal(crate.cast_shadow, GeometryInstance3D.SHADOW_CASTING_SETTING_OFF)
	_visibility.look_from([eye])
	equal(_shown(_surfaces.shadows), [true, true], "no camera, no bounds")
	equal(crate.cast_shadow, GeometryInstance3D.SHADOW_CASTING_SETTING_ON)


func test_a_prop_that_comes_into_a_picture_that_stays_throws_its_shadow() -> void:
	var camera: Camera3D = _open_camera()
	var prop: Node3D = _prop(Vector3(10.0, 0.5, 12.0))
	var crate: MeshInstance3D = _add_crate(prop)
	var eye: Vector3 = Vector3(25.0, 3.0, 12.0)
	camera.look_at_from_position(eye, eye + Vector3.RIGHT)
	camera.make_current()
	_visibility._process(1.0)
	equal(crate.cast_shadow, GeometryInstance3D.SHADOW_CASTING_SETTING_OFF)
	prop.position.x = 40.0
	_visibility._process(1.0)
	equal(crate.cast_shadow, GeometryInstance3D.SHADOW_CASTING_SETTING_ON)


func test_shadows_that_may_fall_on_anything_are_all_thrown() -> void:
	equal(LevelVisibility.find_sun(_level), _sun)
	var spot: SpotLight3D = SpotLight3D.new()
	spot.shadow_enabled = true
	for other: Node3D in [Terrain.new(), spot, DirectionalLight3D.new(), StageLight.new()]:
		_level.add_child(other)
		equal(LevelVisibility.find_sun(_level), null, other.get_class())
		other.free()
	_visibility.sun = null
	_visibility.look_from([_middle(0)])
	equal(_shown(_surfaces.shadows), [true, true])


func test_props_that_somebody_has_hidden_stay_hidden() -> void:
	var prop: Node3D = _prop(Vector3(3.0, 0.5, 5.0))
	prop.visible = false
	_visibility.look_from([_middle(0)])
	is_false(prop.visible)
	_visibility.look_from([_middle(1)])
	_visibility.look_from([_middle(0)])
	is_false(prop.visible)
	prop.visible = true
	_visibility.look_from([_middle(1)])
	_visibility.is_active = false
	_visibility.look_from([_middle(1)])
	is_true(prop.visible)


func test_props_may_go_and_come() -> void:
	_prop(Vector3(3.0, 0.5, 5.0)).free()
	var first: Node3D = _prop(Vector3(3.0, 0.5, 5.0))
	_visibility.look_from([_middle(1)])
	is_false(first.visible)
	first.free()
	var second: Node3D = _prop(Vector3(3.0, 0.5, 5.0))
	_visibility.look_from([_middle(0)])
	is_true(second.visible)
	_visibility.look_from([_middle(1)])
	is_false(second.visible)


func test_props_are_shown_where_their_cell_is_seen() -> void:
	var near: Node3D = _prop(Vector3(3.0, 0.5, 5.0))
	var far: Node3D = _prop(Vector3(41.0, 0.5, 5.0))
	var between: Node3D = _prop(Vector3(24.8, 0.5, 5.0))
	var outside: Node3D = _prop(Vector3(-50.0, 0.5, 5.0))
	_visibility.look_from([_middle(0)])
	is_true(near.visible)
	is_false(far.visible)
	is_true(between.visible, "some of it is in the cell that is seen")
	is_true(outside.visible, "nothing is known of where it is")
	_visibility.look_from([_middle(1)])
	is_false(near.visible)
	is_true(far.visible)


func _bake() -> LevelBake:
	var bake: LevelBake = LevelBake.new()
	bake.cell_size = CELL_M
	bake.cell_counts = Vector3i(2, 1, 1)
	bake.seen_parts = PackedByteArray([1, 0, 0, 1])
	bake.seen_cells = PackedByteArray([1, 0, 0, 1])
	return bake


func _middle(p_cell: int) -> Vector3:
	return Vector3(CELL_M * (p_cell + 0.5), 1.7, 5.0)


func _shine(p_towards: Vector3) -> void:
	var up: Vector3 = Vector3.UP if absf(p_towards.y) < 0.9 else Vector3.RIGHT
	_sun.basis = Basis.looking_at(-p_towards, up)


func _add_instance() -> MeshInstance3D:
	var instance: MeshInstance3D = MeshInstance3D.new()
	_surfaces.add_child(instance)
	return instance


func _prop(p_at: Vector3) -> Node3D:
	var prop: Node3D = Node3D.new()
	prop.position = p_at
	prop.add_to_group(KitBlock.PROPS_GROUP)
	_level.add_child(prop)
	return prop


func _shown(p_meshes: Array[MeshInstance3D]) -> Array[bool]:
	var shown: Array[bool] = []
	for mesh: MeshInstance3D in p_meshes:
		shown.append(mesh.visible)
	return shown


## A camera in a level in which every cell sees every part, with short shadows.
func _open_camera() -> Camera3D:
	var camera: Camera3D = Camera3D.new()
	_level.add_child(camera)
	_surfaces.bake.seen_parts = PackedByteArray([1, 1, 1, 1])
	_surfaces.bake.seen_cells = PackedByteArray([1, 1, 1, 1])
	_sun.directional_shadow_max_distance = 60.0
	return camera


func _add_crate(p_prop: Node3D) -> MeshInstance3D:
	var crate: MeshInstance3D = MeshInstance3D.new()
	crate.mesh = BoxMesh.new()
	p_prop.add_child(crate)
	return crate

extends TestCase
## What LevelCheck says of levels that are broken in one way each, and of those of ours.

const CRATE: PackedScene = preload("res://scenes/world/props/crate.tscn")
const SCENE: String = "user://test_level_check.tscn"

var _level: Level = null


func before_each() -> void:
	_level = Level.new()
	_level.static_root = _below(_level, Node3D.new(), "Static")
	_level.props_root = _below(_level, Node3D.new(), "Props")
	_add_block("Floor", Vector3(0.0, -0.5, 0.0), Vector3(20.0, 1.0, 20.0))
	_add_point("Point", Vector3.ZERO)
	add_child(_level)


func after_each() -> void:
	_level.free()
	for path: String in [SCENE, Level.bake_path_of(SCENE)]:
		if FileAccess.file_exists(path):
			DirAccess.remove_absolute(path)


func test_a_sound_level_has_no_fault() -> void:
	_add_crate("Crate", Vector3(3.0, 0.25, 3.0))
	_add_area("Area", Vector3(4.0, 1.0, -4.0))
	_add_path("Path", [Vector3(1.0, 0.0, 1.0), Vector3(-7.0, 0.0, 7.0)])
	await _expect([])


func test_tops_that_lie_in_each_other() -> void:
	var tiles: SurfaceLayers.Layer = SurfaceLayers.Layer.TILES
	_add_block("Tile", Vector3(3.0, 0.0, 0.0), Vector3(1.0, 0.004, 1.0), tiles)
	# Beside one another, far enough above, and alike: these are sound.
	_add_block("Beside", Vector3(11.0, -0.5, 0.0), Vector3(2.0, 1.0, 2.0), tiles)
	_add_block("Plate", Vector3(-3.0, 0.005, 0.0), Vector3(1.0, 0.01, 1.0), tiles)
	_add_block("Alike", Vector3(-6.0, -0.1, 0.0), Vector3(1.0, 0.2, 1.0))
	var across: Road = Road.new()
	across.position = Vector3(-2.0, 0.0, 8.0)
	across.rotation.y = PI / 2.0
	_below(_level.static_root, across, "Across")
	var along: Road = Road.new()
	along.position = Vector3(-5.0, 0.002, 9.5)
	along.has_left_kerb = false
	# In a group, where it has the same number among its siblings as the other may have.
	var group: Node3D = Node3D.new()
	_below(_level.static_root, group, "Group")
	for number: int in across.get_index():
		_below(group, Node3D.new(), "Empty%d" % number)
	_below(group, along, "Along")
	equal(along.get_index(), across.get_index())
	var kind: LevelFault.Kind = LevelFault.Kind.FLICKERS
	await _expect(
		[
			[kind, "Static/Tile", "lies in that of 'Floor'"],
			[kind, "Static/Group/Along", "that of 'Across'"]
		]
	)


func test_a_block_whose_top_lies_in_terrain() -> void:
	var terrain: Terrain = Terrain.new()
	terrain.has_hills = false
	_below(_level.static_root, terrain, "Terrain")
	terrain.set_field(HeightField.create(101, 101, 0.5))
	await _expect([[LevelFault.Kind.FLICKERS, "Static/Floor", "lies in the ground of 'Terrain'"]])
	_level.static_root.get_node(^"Floor").position.y -= 0.1
	await _expect([])


func test_no_spawn_point() -> void:
	_level.get_spawn_points()[0].free()
	await _expect([[LevelFault.Kind.NO_SPAWN_POINT, "", "add a SpawnPoint"]])


func test_a_spawn_point_in_a_wall() -> void:
	_add_point("Other", Vector3(5.0, 0.0, 5.0))
	_add_block("Wall", Vector3(5.0, 1.0, 5.2), Vector3(2.0, 2.0, 0.3))
	var kind: LevelFault.Kind = LevelFault.Kind.SPAWN_POINT_IN_WALL
	await _expect([[kind, "Other", "stands in 'Wall'"]])


func test_spawn_points_in_the_air_and_below_the_ground() -> void:
	_level.get_spawn_points()[0].position.y = 0.4
	_add_point("Outside", Vector3(30.0, 0.0, 0.0))
	var kind: LevelFault.Kind = LevelFault.Kind.SPAWN_POINT_IN_AIR
	var walk: LevelFault.Kind = LevelFault.Kind.UNREACHABLE
	await _expect(
		[
			[kind, "Point", "0.40 m above the ground: set its height to 0.00 m"],
			[kind, "Outside", "there is no ground below it"],
			[walk, "Outside", "nobody can walk away"],
		]
	)


func test_a_prop_in_a_wall() -> void:
	_add_block("Wall", Vector3(5.0, 1.0, 5.0), Vector3(2.0, 2.0, 0.3))
	_add_crate("Crate", Vector3(5.0, 0.25, 5.3))
	_add_crate("Beside", Vector3(5.0, 0.25, 5.41))
	await _expect([[LevelFault.Kind.PROP_IN_WALL, "Props/Crate", "stands in 'Wall'"]])


func test_what_is_not_solid() -> void:
	_below(_level.static_root, StaticBody3D.new(), "Empty")
	var shown: MeshInstance3D = MeshInstance3D.new()
	shown.mesh = BoxMesh.new()
	shown.position.y = 0.5
	_below(_level.static_root, shown, "Box")
	var kind: LevelFault.Kind = LevelFault.Kind.NO_COLLISION
	await _expect(
		[
			[kind, "Static/Empty", "add a CollisionShape3D"],
			[kind, "Static/Box", "seen but not solid"],
		]
	)


func test_scaling_is_found_where_it_is() -> void:
	var group: Node3D = _below(_level.static_root, Node3D.new(), "Group")
	group.scale = Vector3(2.0, 1.0, 1.0)
	var block: Block = Block.new()
	block.position = Vector3(3.0, 0.5, 3.0)
	_below(group, block, "Block")
	var kind: LevelFault.Kind = LevelFault.Kind.SCALED
	await _expect([[kind, "Static/Group/Block", "(2.00, 1.00, 1.00) through 'Group'"]])


func test_too_many_bodies() -> void:
	for index: int in BuildCheck.MAX_BODIES + 1:
		var place: Vector2 = Vector2(index % 25, index / 25) * 0.7
		_add_crate("Crate%d" % index, Vector3(place.x - 9.0, 0.25, place.y - 6.0))
	var text: String = "%d bodies move" % (BuildCheck.MAX_BODIES + 1)
	await _expect([[LevelFault.Kind.TOO_MANY_BODIES, "", text]])


func test_light_that_is_not_baked_or_of_other_blocks() -> void:
	_level.scene_file_path = SCENE
	var kind: LevelFault.Kind = LevelFault.Kind.NOT_BAKED
	await _expect([[kind, "", "its light is not baked"]])
	var bake: LevelBake = LevelBake.new()
	bake.source_hash = LevelBake.hash_of(SurfacePart.gather(_level))
	equal(bake.save_file(Level.bake_path_of(SCENE)), OK)
	await _expect([])
	_add_block("New", Vector3(3.0, 0.5, 3.0), Vector3.ONE)
	await _expect([[kind, "", "blocks have changed"]])


func test_spawn_points_that_do_not_reach_one_another() -> void:
	_add_point("Second", Vector3(2.0, 0.0, 0.0))
	_add_point("Behind", Vector3(-8.0, 0.0, 0.0))
	_add_block("Wall", Vector3(-5.0, 1.5, 0.0), Vector3(0.3, 3.0, 20.0))
	var kind: LevelFault.Kind = LevelFault.Kind.UNREACHABLE
	var words: Array = [
		[kind, "Behind", "cannot walk to the other spawn points"], [kind, "", "nobody can get to"]
	]
	await _expect(words)
	# A doorway is enough.
	_level.get_node(^"Static/Wall").free()
	_add_block("Left", Vector3(-5.0, 1.5, -5.5), Vector3(0.3, 3.0, 9.0))
	_add_block("Right", Vector3(-5.0, 1.5, 4.5), Vector3(0.3, 3.0, 11.0))
	await _expect([[kind, "Behind", "cannot walk"], [kind, "", "nobody"]], "shut: 0 m wide")
	_level.get_node(^"Static/Right").position.z += 1.0
	await _expect([], "1 m wide")


func test_areas_and_waypoints_that_nobody_reaches() -> void:
	_add_block("Tower", Vector3(6.0, 2.0, 6.0), Vector3(3.0, 4.0, 3.0))
	_add_area("Area", Vector3(6.0, 5.0, 6.0))
	_add_path("Path", [Vector3(1.0, 0.0, 1.0), Vector3(6.0, 4.0, 6.0)])
	var kind: LevelFault.Kind = LevelFault.Kind.UNREACHABLE
	var area: Array = [kind, "Area", "nobody can walk into this area"]
	var path: Array = [kind, "Path", "waypoint 1 at (6.0, 4.0, 6.0)"]
	await _expect([area, path])
	# Steps of 0.17 m lead up.
	var stairs: Stairs = Stairs.new()
	stairs.steps = 24
	stairs.rise = 4.0 / 24.0
	stairs.going = 0.28
	stairs.landing = 0.0
	stairs.position = Vector3(-2.2, 0.0, 6.0)
	stairs.rotation.y = -PI / 2.0
	_below(_level.static_root, stairs, "Stairs")
	await _expect([])


func test_a_house_without_a_way_up() -> void:
	var house: House = House.new()
	house.position = Vector3(-4.0, 0.0, 4.0)
	_below(_level.static_root, house, "House")
	_level.get_spawn_points()[0].position = Vector3(0.0, 0.0, 8.0)
	await _expect([], "as it is")
	var plan: HousePlan = house.plan()
	is_true(plan.has_stairs())
	# The stairs are walled up: nobody gets to the floor above and to the roof.
	var steps: Vector2 = plan.stairs_rect().get_center()
	var middle: Vector3 = house.transform * Vector3(steps.x, 1.4, -steps.y)
	_add_block("Plug", middle, Vector3(2.0, 2.6, 2.0))
	var faults: Array[LevelFault] = await _run()
	is_true(faults.size() >= 1)
	for fault: LevelFault in faults:
		equal([fault.kind, fault.path], [LevelFault.Kind.UNREACHABLE, ^"Static/House"])


func test_levels_of_ours() -> void:
	for name: String in LevelStore.names():
		var level: Level = LevelStore.instantiate(name)
		add_child(level)
		await physics_frames(2)
		var check: LevelCheck = LevelCheck.new(level)
		check.run()
		for fault: LevelFault in check.faults:
			var is_hint: bool = fault.severity == LevelFault.Severity.HINT
			is_true(is_hint, "%s: %s" % [name, fault.describe()])
			is_true(fault.kind != LevelFault.Kind.NOT_BAKED, "%s: %s" % [name, fault.text])
		level.free()


## Runs it and compares what it found with rows of kind, node and words, whatever their order.
func _expect(p_wanted: Array, p_note: String = "") -> void:
	var faults: Array[LevelFault] = await _run()
	var lines: PackedStringArray = []
	for fault: LevelFault in faults:
		lines.append(fault.describe())
	equal(faults.size(), p_wanted.size(), p_note + "; " + "; ".join(lines))
	for row: Array in p_wanted:
		var fits: Callable = func(fault: LevelFault) -> bool:
			var is_it: bool = fault.kind == row[0] and String(fault.path) == row[1]
			return is_it and fault.text.contains(row[2])
		is_true(faults.any(fits), "%s %s" % [row, "; ".join(lines)])


func _run() -> Array[LevelFault]:
	await physics_frames(2)
	var check: LevelCheck = LevelCheck.new(_level)
	check.run()
	return check.faults


func _below(p_parent: Node, p_node: Node3D, p_name: String) -> Node3D:
	p_node.name = p_name
	p_parent.add_child(p_node)
	return p_node


func _add_block(
	p_name: String,
	p_at: Vector3,
	p_size: Vector3,
	p_surface: SurfaceLayers.Layer = SurfaceLayers.Layer.CONCRETE
) -> void:
	var block: Block = Block.new()
	block.size = p_size
	block.surface = p_surface
	block.position = p_at
	_below(_level.static_root, block, p_name)


func _add_point(p_name: String, p_at: Vector3) -> void:
	var point: SpawnPoint = SpawnPoint.new()
	point.position = p_at
	_below(_level, point, p_name)


func _add_crate(p_name: String, p_at: Vector3) -> void:
	var crate: RigidBody3D = CRATE.instantiate()
	crate.position = p_at
	crate.freeze = true
	_below(_level.props_root, crate, p_name)


func _add_area(p_name: String, p_at: Vector3) -> void:
	var area: Area3D = Area3D.new()
	area.position = p_at
	var shape: CollisionShape3D = CollisionShape3D.new()
	var box: BoxShape3D = BoxShape3D.new()
	box.size = Vector3(2.0, 2.1, 2.0)
	shape.shape = box
	area.add_child(shape)
	_below(_level, area, p_name)


func _add_path(p_name: String, p_points: PackedVector3Array) -> void:
	var path: Path3D = Path3D.new()
	path.curve = Curve3D.new()
	for point: Vector3 in p_points:
		path.curve.add_point(point)
	_below(_level, path, p_name)

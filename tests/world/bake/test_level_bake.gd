extends TestCase
## What is baked of a level: light that is there where it should be, a file that comes back as it
## was written, and files that are no such thing.

const PATH: String = "user://test_level_bake.bake"
const FIELDS: Array[String] = [
	"keys",
	"counts",
	"source_hash",
	"light",
	"grid",
	"grid_origin",
	"grid_spacing",
	"grid_counts",
	"cell_origin",
	"cell_size",
	"cell_counts",
	"seen_parts",
	"seen_cells",
]

static var _baked: LevelBake = null

var _level: Node3D = null


func before_each() -> void:
	_level = Node3D.new()
	_level.add_to_group(KitBlock.LEVEL_GROUP)
	add_child(_level)
	_add("Ground", Vector3(0.0, -0.5, 0.0), Vector3(30.0, 1.0, 30.0))
	_add("Floor", Vector3(0.0, 0.05, 0.0), Vector3(6.0, 0.1, 6.0))
	_add("Roof", Vector3(0.0, 3.2, 0.0), Vector3(7.0, 0.2, 7.0))
	for side: float in [-1.0, 1.0]:
		_add("Side%d" % int(side), Vector3(3.2 * side, 1.6, 0.0), Vector3(0.4, 3.2, 6.8))
		_add("End%d" % int(side), Vector3(0.0, 1.6, 3.2 * side), Vector3(6.0, 3.2, 0.4))
	var lamp: StreetLamp = StreetLamp.new()
	lamp.position = Vector3(10.0, 0.0, 10.0)
	_level.add_child(lamp)


func after_each() -> void:
	_level.free()
	DirAccess.remove_absolute(PATH)


func test_a_closed_room_is_dark_and_the_open_is_not() -> void:
	var bake: LevelBake = _bake()
	is_true(bake.fits(SurfacePart.gather(_level)))
	var room: float = _sky_near(bake, Vector3(0.6, 0.1, 0.6))
	var open: float = _sky_near(bake, Vector3(-10.0, 0.0, -10.0))
	is_true(room < 0.05, "%f" % room)
	is_true(open > 0.85, "%f" % open)


func test_light_in_the_air() -> void:
	var bake: LevelBake = _bake()
	var grid: LightGrid = LightGrid.new()
	is_true(grid.set_points(bake.grid, bake.grid_counts))
	var day: PackedVector3Array = []
	day.resize(5)
	var night: PackedVector3Array = day.duplicate()
	day[WorldLight.Source.SKY] = Vector3.ONE
	night[WorldLight.Source.LAMPS] = Vector3.ONE
	is_true(_air(bake, grid, Vector3(-8.0, 1.5, -8.0), day) > 0.5)
	is_true(_air(bake, grid, Vector3(0.0, 1.5, 0.0), day) < 0.1)
	var lamp: float = _air(bake, grid, Vector3(10.5, 2.0, 10.5), night)
	is_true(lamp > 0.2, "%f" % lamp)
	is_true(_air(bake, grid, Vector3(-10.0, 1.5, -10.0), night) < 0.1 * lamp)


func test_what_is_seen_from_where() -> void:
	var bake: LevelBake = _bake()
	var open: int = bake.cell_at(Vector3(-13.0, 1.5, -13.0))
	var other: int = bake.cell_at(Vector3(13.0, 1.5, -13.0))
	var count: int = bake.cell_counts.x * bake.cell_counts.y * bake.cell_counts.z
	equal(bake.seen_cells[open * count + other], 1)
	equal(bake.seen_cells[other * count + open], 1)
	equal(bake.cell_at(Vector3(0.0, 500.0, 0.0)), -1)


func test_files_of_another_version_are_refused() -> void:
	equal(_bake().save_file(PATH), OK)
	var bytes: PackedByteArray = FileAccess.get_file_as_bytes(PATH)
	for version: int in [0, LevelBake.VERSION - 1, LevelBake.VERSION + 1]:
		bytes.encode_u32(8, version)
		var why: String = LevelBake.new().read(bytes)
		is_true(why.contains("version %d" % version), why)


func test_small_cells_lie_in_the_cells() -> void:
	var bake: LevelBake = _bake()
	equal(bake.divisions, 2)
	equal(bake.small_cell_at(bake.cell_origin), 0)
	equal(bake.small_cell_at(bake.cell_origin + Vector3.UP * bake.cell_size * 0.6), 1)
	equal(bake.small_cell_at(bake.cell_origin - Vector3.ONE), -1)


func test_a_file_comes_back_as_it_was_written() -> void:
	var bake: LevelBake = _bake()
	equal(bake.save_file(PATH), OK)
	var read: LevelBake = LevelBake.load_file(PATH)
	equal(read.error, "")
	for field: String in FIELDS:
		equal(read.get(field), bake.get(field), field)


func test_files_that_are_damaged_are_refused() -> void:
	equal(_bake().save_file(PATH), OK)
	var good: PackedByteArray = FileAccess.get_file_as_bytes(PATH)
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = 4
	for round: int in 100:
		var bytes: PackedByteArray = good.duplicate()
		if round % 4 == 0:
			bytes.resize(dice.randi_range(0, bytes.size() - 1))
		else:
			bytes[dice.randi_range(0, bytes.size() - 1)] ^= 1 << dice.randi_range(0, 7)
		is_true(LevelBake.new().read(bytes) != "", "round %d" % round)


func test_files_with_a_right_hash_and_wrong_sizes_are_refused() -> void:
	for field: String in ["light", "grid", "seen_parts", "seen_cells"]:
		var wrong: LevelBake = _copy()
		var bytes: PackedByteArray = wrong.get(field)
		bytes.resize(bytes.size() - 1)
		wrong.set(field, bytes)
		_refuses(wrong, field)
	for counts: Vector3i in [Vector3i(-1, -1, 4), Vector3i(100000, 1, 1), Vector3i(3, 0, 3)]:
		var wrong: LevelBake = _copy()
		wrong.cell_counts = counts
		_refuses(wrong, str(counts))
	var odd: LevelBake = _copy()
	odd.grid_origin = Vector3(NAN, 0.0, 0.0)
	_refuses(odd, "not finite")
	contains(LevelBake.load_file("user://is_not_there.bake").error, "is_not_there.bake")
	contains(LevelBake.new().read("something else".to_utf8_buffer()), "no baked level")


func test_light_of_another_level_does_not_fit() -> void:
	var bake: LevelBake = _bake()
	_add("More", Vector3(8.0, 1.0, -8.0), Vector3.ONE)
	is_false(bake.fits(SurfacePart.gather(_level)))


func _bake() -> LevelBake:
	if _baked == null:
		var baker: LevelBaker = LevelBaker.new()
		baker.prepare(_level)
		baker.run()
		almost_equal(baker.progress(), 1.0, 0.0)
		_baked = baker.bake
	return _baked


func _copy() -> LevelBake:
	var copy: LevelBake = LevelBake.new()
	for field: String in FIELDS:
		copy.set(field, _bake().get(field))
	return copy


func _refuses(p_bake: LevelBake, p_what: String) -> void:
	equal(p_bake.save_file(PATH), OK)
	is_true(LevelBake.load_file(PATH).error != "", p_what)


## Light of the sky at the vertex that is nearest to a point and looks up.
func _sky_near(p_bake: LevelBake, p_point: Vector3) -> float:
	var nearest: float = INF
	var found: float = 0.0
	var parts: Array[SurfacePart] = SurfacePart.gather(_level)
	for index: int in parts.size():
		var light: PackedByteArray = p_bake.light_of(index)
		var arrays: Array = parts[index].mesh.make_arrays()
		var points: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
		var normals: PackedVector3Array = arrays[Mesh.ARRAY_NORMAL]
		for vertex: int in points.size():
			var distance: float = points[vertex].distance_to(p_point)
			if normals[vertex].y > 0.9 and distance < nearest:
				nearest = distance
				found = 2.0 * pow(light[vertex * LevelBake.LIGHT_SIZE] / 255.0, 3.0)
	return found


func _air(
	p_bake: LevelBake, p_grid: LightGrid, p_place: Vector3, p_strengths: PackedVector3Array
) -> float:
	return p_grid.mean_at((p_place - p_bake.grid_origin) / p_bake.grid_spacing, p_strengths).x


func _add(p_name: String, p_place: Vector3, p_size: Vector3) -> void:
	var block: Block = Block.new()
	block.name = p_name
	block.size = p_size
	block.position = p_place
	_level.add_child(block)

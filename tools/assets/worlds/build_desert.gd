extends SceneTree
## Makes scenes/world/desert/desert.tscn and its meshes from desert_layout.json and desert.height:
##
## godot --headless --path . -s tools/assets/worlds/build_desert.gd
##
## Rocks, wrecks, ruins, a checkpoint, a camp and a telegraph line are meshes with baked light and
## shapes of their own, each a StaticBody3D below Static that can be moved in the editor (its light
## is then that of the old place).

const FOLDER: String = "res://scenes/world/desert/"
const LAYOUT: String = "res://tools/assets/worlds/desert_layout.json"
const MATERIAL: String = "res://assets/world/materials/desert_surface.tres"
const TOWN: String = "res://scenes/world/town/town_blocks.tscn"
## Colours that faces choose from, sRGB: see SolidMaker.Tint.
const TINTS: PackedColorArray = [
	Color(1.0, 1.0, 1.0),
	Color(0.50, 0.47, 0.45),
	Color(0.62, 0.64, 0.46),
	Color(1.0, 0.88, 0.66),
	Color(0.72, 0.22, 0.17),
	Color(0.93, 0.91, 0.86),
	Color(0.60, 0.56, 0.44),
	Color(0.62, 0.55, 0.48),
	Color(1.0, 0.95, 0.88),
	Color(1.0, 0.88, 0.78),
	Color(0.66, 0.66, 0.66),
	Color(0.24, 0.23, 0.22)
]
## Towards the suns of the baked light.
const SUNS: Array[Vector3] = [
	Vector3(0.9659, 0.2588, 0.0), Vector3(0.0, 0.9063, 0.4226), Vector3(-0.9659, 0.2588, 0.0)
]
## Distance of the points of the ground that throws back light, m.
const GROUND_M: float = 4.0

var _layout: Dictionary = {}
var _field: HeightField = null
var _level: Level = null
var _static: Node3D = null
var _names: PackedStringArray = []
var _meshes: Array[BlockMesh] = []
var _places: Array[Vector3] = []
## Parts whose faces are their shape; the others have boxes.
var _is_rock: Array[bool] = []
var _casts: Array[bool] = []


func _initialize() -> void:
	_layout = JSON.parse_string(FileAccess.get_file_as_string(LAYOUT))
	_field = HeightFile.read(FOLDER + "desert.height").field
	_save_material()
	_add_rocks()
	_add_wrecks()
	_add_ruins()
	_add_checkpoint()
	_add_camp()
	_add_telegraph()
	_make_level()
	_bake()
	_add_spawns()
	_add_props()
	_add_lamps()
	var packed: PackedScene = PackedScene.new()
	packed.pack(_level)
	ResourceSaver.save(packed, FOLDER + "desert.tscn")
	print("desert: %d parts, %d vertices" % [_meshes.size(), _count()])
	quit()


func _count() -> int:
	var sum: int = 0
	for mesh: BlockMesh in _meshes:
		sum += mesh.get_vertex_count()
	return sum


func _ground(p_x: float, p_z: float) -> Vector3:
	return Vector3(p_x, _field.height_at(p_x, p_z), p_z)


func _spot(p_pair: Array) -> Vector3:
	return _ground(p_pair[0], p_pair[1])


## A part at a place; what is built next stands there.
func _begin(p_name: String, p_place: Vector3, p_is_rock: bool = false) -> BlockMesh:
	var mesh: BlockMesh = BlockMesh.new()
	mesh.set_layer_edges(PackedFloat32Array(SurfaceLayers.EDGE_M))
	mesh.set_dust(0.35, 0.0)
	mesh.set_finest(1.2)
	_names.append(p_name)
	_meshes.append(mesh)
	_places.append(p_place)
	_is_rock.append(p_is_rock)
	_casts.append(true)
	return mesh


## Where a thing stands in a part: upright on the ground below, or lying on its slope.
func _stand(p_part: Vector3, p_at: Vector3, p_turn: float, p_leans: bool) -> Transform3D:
	var basis: Basis = Basis(Vector3.UP, p_turn)
	if p_leans:
		var up: Vector3 = _field.normal_at(p_at.x, p_at.z)
		basis = Basis(Quaternion(Vector3.UP, up)) * basis
	return Transform3D(basis, p_at - p_part)


func _add_rocks() -> void:
	var number: int = 0
	for rock: Dictionary in (_layout["mesas"] as Array) + (_layout["needles"] as Array):
		number += 1
		var place: Vector3 = _spot(rock["at"])
		# The slope of debris is part of the ground: stand on its foot.
		place.y -= float(rock["height"]) * 0.18
		var mesh: BlockMesh = _begin("Rock%d" % number, place, true)
		mesh.set_dust(0.22, 0.0)
		var seed: int = int(rock["seed"])
		var tint: int = SolidMaker.Tint.PALE_ROCK if seed % 3 > 0 else SolidMaker.Tint.RED_ROCK
		var maker: RockMaker = RockMaker.new()
		maker.mesa(mesh, rock["radius"], rock["height"], seed, tint)
		_add_boulders(maker, mesh, place, rock["radius"], seed, tint)


func _add_boulders(
	p_maker: RockMaker,
	p_mesh: BlockMesh,
	p_place: Vector3,
	p_radius: float,
	p_seed: int,
	p_tint: int
) -> void:
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = p_seed + 500
	for number: int in roundi(4.0 + p_radius * 0.7):
		var turn: float = dice.randf() * TAU
		var reach: float = p_radius * (1.15 + 0.9 * dice.randf() * dice.randf()) + 1.5
		var at: Vector3 = _ground(p_place.x + cos(turn) * reach, p_place.z + sin(turn) * reach)
		var size: float = 0.5 + 2.6 * pow(dice.randf(), 3.0)
		if _field.paint_at(at.x, at.z, HeightField.Paint.ROAD) < 0.05:
			p_maker.boulder(p_mesh, at - p_place, size, p_seed * 31 + number, p_tint)


func _add_wrecks() -> void:
	var kinds: Array[Array] = [
		["Tank", -96.0, 26.0, 0.8],
		["Tank", 72.0, -62.0, -1.9],
		["Tank", -14.0, 148.0, 2.7],
		["Lorry", -58.0, -2.0, 1.35],
		["Lorry", 26.0, -26.5, -0.4],
		["Lorry", -178.0, 4.0, 2.3],
		["Car", 8.0, -6.0, 1.2],
		["Car", 64.0, -9.5, -1.4],
		["Car", -118.0, 20.0, 0.5],
		["Car", -50.0, 12.0, 2.4]
	]
	var number: int = 0
	for row: Array in kinds:
		number += 1
		var place: Vector3 = _ground(row[1], row[2])
		var mesh: BlockMesh = _begin("%s%d" % [row[0], number], place)
		mesh.set_finest(0.8)
		mesh.set_dust(0.55, 0.2)
		var stand: Transform3D = _stand(place, place, row[3], true)
		stand.origin.y -= 0.10
		mesh.set_place(stand)
		var maker: WreckMaker = WreckMaker.new(mesh, number)
		match row[0]:
			"Tank":
				maker.tank()
			"Lorry":
				maker.lorry()
			_:
				maker.car()


func _add_ruins() -> void:
	var number: int = 0
	for ruin: Dictionary in _layout["ruins"]:
		number += 1
		var place: Vector3 = _spot(ruin["at"])
		var mesh: BlockMesh = _begin("Ruin%d" % number, place)
		mesh.set_finest(0.9)
		var least: float = place.y
		for corner: Vector2 in [Vector2(4, 3), Vector2(-4, 3), Vector2(4, -3), Vector2(-4, -3)]:
			var turned: Vector2 = corner.rotated(-float(ruin["turn"]))
			least = minf(least, _ground(place.x + turned.x, place.z + turned.y).y)
		var stand: Transform3D = _stand(place, place, ruin["turn"], false)
		stand.origin.y = least - place.y - 0.05
		mesh.set_place(stand)
		CampMaker.new(mesh, int(ruin["seed"])).ruin()


func _add_checkpoint() -> void:
	var middle: Vector3 = _spot(_layout["checkpoint"])
	var mesh: BlockMesh = _begin("Checkpoint", middle)
	mesh.set_finest(0.8)
	var maker: CampMaker = CampMaker.new(mesh, 77)
	var east: float = -0.16
	var things: Array[Array] = [
		["hut", Vector2(2.0, 7.0), PI],
		["beam", Vector2(0.0, 4.6), PI / 2.0],
		["barrier", Vector2(-9.0, 2.0), 0.25],
		["barrier", Vector2(-4.5, -2.4), -0.2],
		["barrier", Vector2(9.0, -2.2), 0.1],
		["barrier", Vector2(13.0, 1.9), -0.15],
		["hedgehog", Vector2(-13.0, 5.6), 0.4],
		["hedgehog", Vector2(-13.5, -5.8), 1.2],
		["hedgehog", Vector2(-10.8, -7.2), 2.2],
		["hedgehog", Vector2(-10.4, 7.4), 2.0],
		["drum", Vector2(4.4, 6.2), 0.0],
		["drum", Vector2(5.0, 6.6), 0.0],
		["drum", Vector2(4.9, 5.9), 0.0],
		["crate", Vector2(-0.6, 8.6), 0.3],
		["bags", Vector2(-2.4, 6.2), 0.1],
		["bags", Vector2(3.5, -6.4), PI]
	]
	for thing: Array in things:
		var offset: Vector2 = (thing[1] as Vector2).rotated(east)
		var at: Vector3 = _ground(middle.x + offset.x, middle.z + offset.y)
		mesh.set_place(_stand(middle, at, float(thing[2]) - east, thing[0] == "barrier"))
		mesh.set_dust(0.3, at.y - middle.y)
		match thing[0]:
			"hut":
				maker.hut()
			"beam":
				maker.barrier_beam(6.6, 1.1)
			"barrier":
				maker.road_barrier()
			"hedgehog":
				maker.hedgehog()
			"drum":
				maker.drum(SolidMaker.Tint.RED if offset.x > 4.8 else SolidMaker.Tint.PLAIN)
			"crate":
				maker.crate(Vector3(1.1, 0.7, 0.7), SolidMaker.Tint.OLIVE)
			_:
				maker.sandbags(
					[
						Vector2(-1.6, 0.9),
						Vector2(-1.6, -0.9),
						Vector2(1.6, -0.9),
						Vector2(1.6, 0.9)
					],
					6
				)


func _add_camp() -> void:
	var middle: Vector3 = _spot(_layout["camp"])
	var mesh: BlockMesh = _begin("Camp", middle)
	mesh.set_finest(0.8)
	var maker: CampMaker = CampMaker.new(mesh, 78)
	var things: Array[Array] = [
		["tent", Vector2(-6.0, -3.0), 0.3],
		["tent", Vector2(-5.0, 5.0), 0.15],
		["tent", Vector2(7.0, 3.0), 1.7],
		["crate", Vector2(0.0, -4.0), 0.2],
		["crate", Vector2(1.3, -4.2), 0.25],
		["crate", Vector2(0.6, -3.0), 1.4],
		["drum", Vector2(3.0, -5.0), 0.0],
		["drum", Vector2(3.7, -5.3), 0.0],
		["bags", Vector2(12.0, -4.0), 1.0],
		["bags", Vector2(-12.0, 1.0), -1.6]
	]
	for thing: Array in things:
		var offset: Vector2 = thing[1]
		var at: Vector3 = _ground(middle.x + offset.x, middle.z + offset.y)
		mesh.set_place(_stand(middle, at, thing[2], thing[0] != "bags"))
		mesh.set_dust(0.3, at.y - middle.y)
		match thing[0]:
			"tent":
				maker.tent()
			"crate":
				maker.crate(Vector3(1.1, 0.7, 0.7), SolidMaker.Tint.OLIVE)
			"drum":
				maker.drum(SolidMaker.Tint.PLAIN)
			_:
				maker.sandbags(
					[
						Vector2(-1.8, 1.2),
						Vector2(-1.8, -0.9),
						Vector2(1.8, -0.9),
						Vector2(1.8, 1.2)
					],
					5
				)


## Poles beside the road, some leaning, wires between them.
func _add_telegraph() -> void:
	var line: Curve2D = Curve2D.new()
	for place: Array in _layout["road"]:
		line.add_point(Vector2(place[0], place[1]))
	line.bake_interval = 1.0
	var last: PackedVector3Array = []
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = 5
	var poles: BlockMesh = null
	var wires: BlockMesh = null
	var part: Vector3 = Vector3.ZERO
	var count: int = int((line.get_baked_length() - 170.0) / 34.0)
	for number: int in count:
		var on: float = 16.0 + number * 34.0
		var way: Vector2 = (line.sample_baked(on + 1.0) - line.sample_baked(on - 1.0)).normalized()
		var side: Vector2 = line.sample_baked(on) + way.orthogonal() * 9.5
		var at: Vector3 = _ground(side.x, side.y)
		if number % 3 == 0:
			part = at
			poles = _begin("Poles%d" % (number / 3 + 1), part)
			poles.set_dust(0.0, 0.0)
			wires = _begin("Wires%d" % (number / 3 + 1), part)
			_casts[_casts.size() - 1] = false
			wires.set_finest(60.0)
		var lean: Basis = Basis(
			Vector3(dice.randfn(), 0.0, dice.randfn()).normalized(), 0.05 * dice.randf()
		)
		var turn: Basis = lean * Basis(Vector3.UP, PI / 2.0 - way.angle())
		var stand: Transform3D = Transform3D(turn, at - part)
		poles.set_place(stand)
		var ends: PackedVector3Array = CampMaker.new(poles, number).pole()
		var hung: PackedVector3Array = []
		for end: Vector3 in ends:
			hung.append(stand * end + part)
		if not last.is_empty() and number != 5:
			_hang_wires(wires, last, hung, part)
		last = hung


func _hang_wires(
	p_wires: BlockMesh, p_from: PackedVector3Array, p_to: PackedVector3Array, p_part: Vector3
) -> void:
	for wire: int in p_from.size():
		var last: Vector3 = p_from[wire] - p_part
		for step: int in range(1, 9):
			var along: float = step / 8.0
			var next: Vector3 = p_from[wire].lerp(p_to[wire], along) - p_part
			next.y -= 4.0 * along * (1.0 - along) * (0.55 + 0.12 * wire)
			p_wires.rod(last, next, 0.02, 0.02, SurfaceLayers.Layer.STEEL, 11, 3, false)
			last = next


func _make_level() -> void:
	_level = Level.new()
	_level.name = "Desert"
	_level.title = "Desert"
	root.add_child(_level)
	var sky: WorldSky = (load("res://scenes/world/sky/world_sky.tscn") as PackedScene).instantiate()
	sky.time_of_day = 9.5
	sky.shadow_distance = 90.0
	_own(_level, sky)
	_static = _own(_level, Node3D.new(), "Static")
	var terrain: Terrain = Terrain.new()
	terrain.height_file = FOLDER + "desert.height"
	terrain.collision_layer = PhysicsLayers.STATIC
	terrain.collision_mask = 0
	_own(_static, terrain, "Terrain")
	_level.static_root = _static
	_level.props_root = _own(_level, Node3D.new(), "Props")
	_own(_level, Node3D.new(), "Spawns")
	_level.world = sky.entity
	if ResourceLoader.exists(TOWN):
		var town: Node3D = (load(TOWN) as PackedScene).instantiate()
		town.position = Vector3(150.0, 0.0, 0.0)
		_own(_static, town, "Town")


func _own(p_parent: Node, p_node: Node, p_name: String = "") -> Node:
	if p_name != "":
		p_node.name = p_name
	p_parent.add_child(p_node, true)
	p_node.owner = _level
	return p_node


## Works out the light of all parts together, then makes their nodes.
func _bake() -> void:
	var tracer: LevelTracer = LevelTracer.new()
	var layers: PackedColorArray = PackedColorArray(SurfaceLayers.AVERAGE)
	var tints: PackedColorArray = []
	for tint: Color in TINTS:
		tints.append(tint.srgb_to_linear())
	tracer.set_palette(layers, tints)
	tracer.set_suns(SUNS[0], SUNS[1], SUNS[2])
	tracer.set_effort(96, 2, OS.get_processor_count())
	_add_ground(tracer)
	for index: int in _meshes.size():
		tracer.add_part(_standing(index))
	tracer.bake()
	for index: int in _meshes.size():
		_add_part(index, tracer.get_light(index))


## A part where it stands in the world, with the same vertices; its colour is one for all.
func _standing(p_index: int) -> BlockMesh:
	var arrays: Array = _meshes[p_index].make_arrays()
	var layer: int = SurfaceLayers.Layer.ROCK if _is_rock[p_index] else SurfaceLayers.Layer.BURNT
	var mesh: BlockMesh = BlockMesh.new()
	mesh.set_layer_edges(PackedFloat32Array(SurfaceLayers.EDGE_M))
	mesh.set_place(Transform3D(Basis.IDENTITY, _places[p_index]))
	mesh.surface(
		arrays[Mesh.ARRAY_VERTEX],
		arrays[Mesh.ARRAY_NORMAL],
		arrays[Mesh.ARRAY_TEX_UV],
		arrays[Mesh.ARRAY_INDEX],
		layer,
		0
	)
	return mesh


func _add_ground(p_tracer: LevelTracer) -> void:
	var ground: Array = TerrainMesh.make_coarse(_field, GROUND_M)
	var points: PackedVector3Array = ground[Mesh.ARRAY_VERTEX]
	for index: int in points.size():
		points[index].y -= 0.05
	p_tracer.add_surface(
		points, ground[Mesh.ARRAY_NORMAL], ground[Mesh.ARRAY_INDEX], Color(0.42, 0.29, 0.16)
	)


func _add_part(p_index: int, p_light: PackedByteArray) -> void:
	var blocks: BlockMesh = _meshes[p_index]
	var mesh: ArrayMesh = SurfaceMaterial.make_mesh(blocks, p_light)
	mesh.surface_set_material(0, load(MATERIAL) as Material)
	var path: String = FOLDER + "meshes/%s.res" % _names[p_index].to_lower()
	DirAccess.make_dir_recursive_absolute(path.get_base_dir())
	mesh.resource_name = _names[p_index]
	ResourceSaver.save(mesh, path, ResourceSaver.FLAG_COMPRESS)
	mesh.take_over_path(path)
	var body: StaticBody3D = StaticBody3D.new()
	# Wires are only seen.
	body.collision_layer = PhysicsLayers.STATIC if _casts[p_index] else 0
	body.collision_mask = 0
	body.position = _places[p_index]
	_own(_static, body, _names[p_index])
	var seen: MeshInstance3D = MeshInstance3D.new()
	seen.mesh = mesh
	if not _casts[p_index]:
		seen.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
		seen.visibility_range_end = 160.0
	_own(body, seen, "Mesh")
	if _is_rock[p_index]:
		var shape: ConcavePolygonShape3D = mesh.create_trimesh_shape()
		shape.backface_collision = true
		var shape_path: String = path.replace(".res", "_shape.res")
		ResourceSaver.save(shape, shape_path, ResourceSaver.FLAG_COMPRESS)
		shape.take_over_path(shape_path)
		_add_shape(body, shape, Transform3D.IDENTITY)
	for solid: int in blocks.get_solid_count():
		var box: BoxShape3D = BoxShape3D.new()
		box.size = blocks.get_solid_size(solid)
		_add_shape(body, box, blocks.get_solid_place(solid))


func _add_shape(p_body: StaticBody3D, p_shape: Shape3D, p_place: Transform3D) -> void:
	var node: CollisionShape3D = CollisionShape3D.new()
	node.shape = p_shape
	node.transform = p_place
	_own(p_body, node, "Shape%d" % p_body.get_child_count())


func _add_spawns() -> void:
	var middle: Vector2 = Vector2(24.0, -7.0)
	for number: int in 8:
		var at: Vector2 = middle + Vector2(-2.6 * (number % 4), 2.8 * (number / 4) + 2.0)
		var point: SpawnPoint = SpawnPoint.new()
		point.position = _ground(at.x, at.y)
		point.rotation.y = PI / 2.0
		_own(_level.get_node("Spawns"), point, "Spawn%d" % (number + 1))


## Lamps of the checkpoint and of the tents, and a fire in the camp.
func _add_lamps() -> void:
	var lamps: Node3D = _own(_level, Node3D.new(), "Lamps")
	var gate: Array = _layout["checkpoint"]
	var camp: Array = _layout["camp"]
	for row: Array in [
		[Vector2(gate[0] + 1.0, gate[1] + 6.6), 2.1, 2.2, 0.0, 10.0],
		[Vector2(gate[0] - 2.6, gate[1] + 4.6), 2.6, 2.6, 0.0, 14.0],
		[Vector2(camp[0] - 6.0, camp[1] - 3.0), 2.0, 1.8, 0.0, 7.0],
		[Vector2(camp[0] + 7.0, camp[1] + 3.0), 2.0, 1.8, 0.0, 7.0],
		[Vector2(camp[0] + 0.5, camp[1] + 1.5), 0.5, 3.2, 0.3, 13.0]
	]:
		var lamp: WorldLamp = WorldLamp.new()
		var at: Vector2 = row[0]
		lamp.position = _ground(at.x, at.y) + Vector3.UP * float(row[1])
		lamp.lit_energy = row[2]
		lamp.flicker = row[3]
		lamp.omni_range = row[4]
		lamp.light_energy = 0.0
		_own(
			lamps, lamp, "Fire" if lamp.flicker > 0.0 else "Lamp%d" % (lamps.get_child_count() + 1)
		)


## What can be pushed: crates at the checkpoint and in the camp.
func _add_props() -> void:
	var crate: PackedScene = load("res://scenes/world/props/crate.tscn")
	var camp: Array = _layout["camp"]
	for place: Vector2 in [
		Vector2(39.0, -3.0),
		Vector2(39.8, -3.4),
		Vector2(39.2, -2.2),
		Vector2(46.5, -2.0),
		Vector2(camp[0] + 2.5, camp[1] - 1.5),
		Vector2(camp[0] + 3.3, camp[1] - 1.2)
	]:
		var prop: RigidBody3D = crate.instantiate()
		prop.position = _ground(place.x, place.y) + Vector3.UP * 0.27
		_own(_level.props_root, prop, "Crate%d" % (_level.props_root.get_child_count() + 1))


func _save_material() -> void:
	var material: ShaderMaterial = ShaderMaterial.new()
	material.shader = load("res://assets/shaders/surface.gdshader")
	material.set_shader_parameter("albedo_layers", load(SurfaceLayers.ALBEDO))
	material.set_shader_parameter("normal_layers", load(SurfaceLayers.NORMAL))
	material.set_shader_parameter("orm_layers", load(SurfaceLayers.ORM))
	material.set_shader_parameter("tints", TINTS)
	ResourceSaver.save(material, MATERIAL)
	material.take_over_path(MATERIAL)

extends SceneTree
## Makes scenes/world/desert/desert.tscn and its meshes from desert_layout.json and desert.height:
##
## godot --headless --path . -s tools/assets/worlds/build_desert.gd
##
## Rocks, wrecks, ruins, a checkpoint, a camp and a telegraph line are meshes with baked light and
## shapes of their own, each a StaticBody3D below Static that can be moved in the editor (its light
## is then that of the old place).

const FOLDER: String = "res://scenes/world/desert/"
const Scenes: GDScript = preload("res://tools/assets/worlds/world_scenes.gd")
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
## Where vehicles stand: x and z, m.
const VEHICLES: Dictionary[String, Vector2] = {
	"tank": Vector2(26.0, 10.0),
	"carrier": Vector2(20.0, 15.0),
	"truck": Vector2(34.0, 16.0),
	"scootmobile": Vector2(27.0, 2.5),
}

var _layout: Dictionary = {}
var _field: HeightField = null
var _level: Level = null
var _static: Node3D = null
var _parts: DesertParts = null


func _initialize() -> void:
	_layout = JSON.parse_string(FileAccess.get_file_as_string(LAYOUT))
	_field = HeightFile.read(FOLDER + "desert.height").field
	_save_material()
	_parts = DesertParts.new(_layout, _field)
	_parts.build()
	_make_level()
	_bake()
	_add_spawns()
	_add_props()
	_add_vehicles()
	_add_lamps()
	var is_saved: bool = Scenes.save(_level, FOLDER + "desert.tscn")
	print("desert: %d parts, %d vertices" % [_parts.names.size(), _parts.count()])
	quit(0 if is_saved else 1)


func _make_level() -> void:
	_level = Level.new()
	_level.name = "Desert"
	_level.title = "Desert"
	root.add_child(_level)
	var sky: WorldSky = (load("res://scenes/world/sky/world_sky.tscn") as PackedScene).instantiate()
	sky.time_of_day = 9.5
	sky.shadow_distance = 90.0
	_add(_level, sky)
	_static = _add(_level, Node3D.new(), "Static")
	var terrain: Terrain = Terrain.new()
	terrain.height_file = FOLDER + "desert.height"
	terrain.collision_layer = PhysicsLayers.STATIC
	terrain.collision_mask = 0
	_add(_static, terrain, "Terrain")
	_level.static_root = _static
	_level.props_root = _add(_level, Node3D.new(), "Props")
	_add(_level, Node3D.new(), "Spawns")
	_level.world = sky.entity
	if ResourceLoader.exists(TOWN):
		var town: Node3D = (load(TOWN) as PackedScene).instantiate()
		town.position = Vector3(150.0, 0.0, 0.0)
		_add(_static, town, "Town")


static func _add(p_parent: Node, p_node: Node, p_name: String = "") -> Node:
	if p_name != "":
		p_node.name = p_name
	p_parent.add_child(p_node, true)
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
	for index: int in _parts.meshes.size():
		tracer.add_part(_standing(index))
	tracer.bake()
	for index: int in _parts.meshes.size():
		_add_part(index, tracer.get_light(index))


## A part where it stands in the world, with the same vertices; its colour is one for all.
func _standing(p_index: int) -> BlockMesh:
	var arrays: Array = _parts.meshes[p_index].make_arrays()
	var layer: int = (
		SurfaceLayers.Layer.ROCK if _parts.is_rock[p_index] else SurfaceLayers.Layer.BURNT
	)
	var mesh: BlockMesh = BlockMesh.new()
	mesh.set_layer_edges(PackedFloat32Array(SurfaceLayers.EDGE_M))
	mesh.set_place(Transform3D(Basis.IDENTITY, _parts.places[p_index]))
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
	var blocks: BlockMesh = _parts.meshes[p_index]
	var mesh: ArrayMesh = SurfaceMaterial.make_mesh(blocks, p_light)
	mesh.surface_set_material(0, load(MATERIAL) as Material)
	var path: String = FOLDER + "meshes/%s.res" % _parts.names[p_index].to_lower()
	DirAccess.make_dir_recursive_absolute(path.get_base_dir())
	mesh.resource_name = _parts.names[p_index]
	ResourceSaver.save(mesh, path, ResourceSaver.FLAG_COMPRESS)
	mesh.take_over_path(path)
	var body: StaticBody3D = StaticBody3D.new()
	# Wires are only seen.
	body.collision_layer = PhysicsLayers.STATIC if _parts.casts[p_index] else 0
	body.collision_mask = 0
	body.position = _parts.places[p_index]
	_add(_static, body, _parts.names[p_index])
	var seen: MeshInstance3D = MeshInstance3D.new()
	seen.mesh = mesh
	if not _parts.casts[p_index]:
		seen.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
		seen.visibility_range_end = 160.0
	_add(body, seen, "Mesh")
	if _parts.is_rock[p_index]:
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
	_add(p_body, node, "Shape%d" % p_body.get_child_count())


func _ground(p_x: float, p_z: float) -> Vector3:
	return Vector3(p_x, _field.height_at(p_x, p_z), p_z)


func _add_spawns() -> void:
	var middle: Vector2 = Vector2(24.0, -7.0)
	for number: int in 8:
		var at: Vector2 = middle + Vector2(-2.6 * (number % 4), 2.8 * (number / 4) + 2.0)
		var point: SpawnPoint = SpawnPoint.new()
		point.position = _ground(at.x, at.y)
		point.rotation.y = PI / 2.0
		_add(_level.get_node("Spawns"), point, "Spawn%d" % (number + 1))


## Lamps of the checkpoint and of the tents, and a fire in the camp.
func _add_lamps() -> void:
	var lamps: Node3D = _add(_level, Node3D.new(), "Lamps")
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
		_add(
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
		_add(_level.props_root, prop, "Crate%d" % (_level.props_root.get_child_count() + 1))


## Vehicles to drive, beside where people start, looking east.
func _add_vehicles() -> void:
	for name: String in VEHICLES:
		var scene: PackedScene = load("res://scenes/vehicle/%s/%s.tscn" % [name, name])
		var vehicle: Node3D = scene.instantiate()
		var at: Vector2 = VEHICLES[name]
		vehicle.transform = Transform3D(
			Basis(Vector3.UP, -PI / 2.0), _ground(at.x, at.y) + Vector3.UP * 0.1
		)
		_add(_level.props_root, vehicle, name.capitalize())


func _save_material() -> void:
	var material: ShaderMaterial = ShaderMaterial.new()
	material.shader = load("res://assets/shaders/surface.gdshader")
	material.set_shader_parameter("albedo_layers", load(SurfaceLayers.ALBEDO))
	material.set_shader_parameter("normal_layers", load(SurfaceLayers.NORMAL))
	material.set_shader_parameter("orm_layers", load(SurfaceLayers.ORM))
	material.set_shader_parameter("tints", TINTS)
	ResourceSaver.save(material, MATERIAL)
	material.take_over_path(MATERIAL)

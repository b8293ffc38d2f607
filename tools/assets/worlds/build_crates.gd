extends SceneTree
## Makes crates of several sizes, props with mass, and the material of props:
## [code]godot --headless --path . -s tools/assets/worlds/build_crates.gd[/code].

const FOLDER: String = "res://scenes/world/props"
const SHADER: String = "res://assets/shaders/prop.gdshader"
## Name, edge (m), mass (kg), tint.
const CRATES: Array[Array] = [
	["crate_small", 0.3, 3.0, SurfaceTints.Tint.STRAW],
	["crate", 0.5, 10.0, SurfaceTints.Tint.TAN],
	["crate_large", 0.8, 35.0, SurfaceTints.Tint.TRIM_BROWN],
]


func _initialize() -> void:
	_save(_material(), PropMesh.MATERIAL)
	for row: Array in CRATES:
		_make(row[0], row[1], row[2], row[3])
	quit()


func _material() -> ShaderMaterial:
	var material: ShaderMaterial = ShaderMaterial.new()
	material.shader = load(SHADER)
	material.set_shader_parameter("albedo_layers", load(SurfaceLayers.ALBEDO))
	material.set_shader_parameter("normal_layers", load(SurfaceLayers.NORMAL))
	material.set_shader_parameter("orm_layers", load(SurfaceLayers.ORM))
	material.set_shader_parameter("tints", SurfaceTints.srgb())
	return material


func _make(p_name: String, p_edge: float, p_mass: float, p_tint: int) -> void:
	var mesh_path: String = FOLDER.path_join(p_name + ".res")
	_save(_mesh(p_edge, p_tint), mesh_path)
	var box: BoxShape3D = BoxShape3D.new()
	box.size = Vector3.ONE * p_edge
	var body: RigidBody3D = RigidBody3D.new()
	body.name = p_name.to_pascal_case()
	body.add_to_group(KitBlock.PROPS_GROUP, true)
	body.collision_layer = PhysicsLayers.PROPS
	body.collision_mask = PhysicsLayers.ALL
	body.mass = p_mass
	body.continuous_cd = true
	body.physics_material_override = ContactMaterial.find(&"wood")
	var shown: MeshInstance3D = MeshInstance3D.new()
	shown.name = "Mesh"
	shown.mesh = load(mesh_path)
	var shape: CollisionShape3D = CollisionShape3D.new()
	shape.name = "Shape"
	shape.shape = box
	for child: Node in [shown, shape]:
		body.add_child(child)
		child.owner = body
	var scene: PackedScene = PackedScene.new()
	scene.pack(body)
	_save(scene, FOLDER.path_join(p_name + ".tscn"))
	body.free()


func _mesh(p_edge: float, p_tint: int) -> ArrayMesh:
	var blocks: BlockMesh = KitBlock.make_mesh(false)
	blocks.set_place(Transform3D(Basis.IDENTITY, Vector3.DOWN * p_edge / 2.0))
	Goods.add_crate(blocks, Vector3.ONE * p_edge, p_tint)
	# What lies behind the frame is darker.
	var open: PackedFloat32Array = []
	for point: Vector3 in blocks.make_arrays()[Mesh.ARRAY_VERTEX] as PackedVector3Array:
		var out: float = maxf(absf(point.x), maxf(absf(point.y), absf(point.z))) / p_edge * 2.0
		open.append(1.0 if out > 0.995 else 0.75)
	return PropMesh.make(blocks, open)


func _save(p_what: Resource, p_path: String) -> void:
	var fault: Error = ResourceSaver.save(p_what, p_path, ResourceSaver.FLAG_COMPRESS)
	if fault != OK:
		printerr("%s: %s" % [p_path, error_string(fault)])
		quit(1)
	p_what.take_over_path(p_path)

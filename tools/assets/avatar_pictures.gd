extends SceneTree
## Takes pictures of avatars: whole, face, hands, from above the collar, and as their wearers see
## themselves.
##
## Needs a display: [code]godot --path . -s tools/assets/avatar_pictures.gd -- OUT_FOLDER
## NAME...[/code]

const _SIZE: Vector2i = Vector2i(480, 540)
## Name, from where, to where (m), field of view (degrees), whether the head is hidden.
const _VIEWS: Array[Array] = [
	["front", Vector3(0.9, 1.35, 3.3), Vector3(0.0, 0.93, 0.0), 34.0, false],
	["back", Vector3(-1.2, 1.5, -3.1), Vector3(0.0, 0.93, 0.0), 34.0, false],
	["face", Vector3(0.22, 1.66, 0.75), Vector3(0.0, 1.63, 0.02), 34.0, false],
	["hand", Vector3(0.75, 1.25, 0.75), Vector3(0.55, 1.08, 0.26), 26.0, false],
	["feet", Vector3(0.6, 0.45, 0.95), Vector3(0.16, 0.13, 0.05), 26.0, false],
	["above", Vector3(0.0, 2.15, 0.35), Vector3(0.0, 1.4, 0.05), 36.0, true],
	["own", Vector3(0.0, 1.66, 0.18), Vector3(0.0, 1.0, 0.42), 80.0, true],
	["far", Vector3(3.0, 1.5, 17.0), Vector3(0.0, 0.95, 0.0), 8.0, false],
]


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	if arguments.size() < 2:
		printerr("usage: ... -- OUT_FOLDER NAME...")
		quit(2)
		return
	root.size = _SIZE
	_add_world()
	var camera: Camera3D = Camera3D.new()
	camera.near = 0.03
	root.add_child(camera)
	for name: String in arguments.slice(1):
		var avatar: Node3D = (
			(load("res://assets/avatar/%s.glb" % name) as PackedScene).instantiate()
		)
		root.add_child(avatar)
		var eyes: Vector3 = _head_of(avatar)
		for view: Array in _VIEWS:
			var rise: Vector3 = Vector3(0.0, eyes.y - 1.59, 0.0) * (view[1].y / 1.66)
			camera.fov = view[3]
			camera.look_at_from_position(view[1] + rise, view[2] + rise * (view[2].y / 1.63))
			for part: Node in avatar.find_children("HeadMesh", "MeshInstance3D"):
				var is_hidden: bool = view[4]
				(part as MeshInstance3D).cast_shadow = (
					GeometryInstance3D.SHADOW_CASTING_SETTING_SHADOWS_ONLY
					if is_hidden
					else GeometryInstance3D.SHADOW_CASTING_SETTING_ON
				)
			for _frame: int in 4:
				await process_frame
			await RenderingServer.frame_post_draw
			var path: String = "%s/%s_%s.png" % [arguments[0], name, view[0]]
			root.get_texture().get_image().save_png(path)
		avatar.free()
	quit()


func _head_of(p_avatar: Node3D) -> Vector3:
	var skeleton: Skeleton3D = p_avatar.find_children("*", "Skeleton3D")[0]
	return skeleton.get_bone_global_rest(skeleton.find_bone(&"Head")).origin


func _add_world() -> void:
	var is_compatible: bool = RenderingServer.get_current_rendering_method() == "gl_compatibility"
	var environment: Environment = Environment.new()
	environment.background_mode = Environment.BG_COLOR
	environment.background_color = Color(0.55, 0.62, 0.68)
	environment.tonemap_mode = (
		Environment.TONE_MAPPER_LINEAR if is_compatible else Environment.TONE_MAPPER_FILMIC
	)
	environment.tonemap_white = 1.0 if is_compatible else 2.5
	var world: WorldEnvironment = WorldEnvironment.new()
	world.environment = environment
	root.add_child(world)
	var sun: DirectionalLight3D = DirectionalLight3D.new()
	sun.rotation_degrees = Vector3(-42.0, 38.0, 0.0)
	sun.light_color = Color(1.0, 0.94, 0.83)
	sun.light_energy = 1.6
	sun.shadow_enabled = true
	sun.directional_shadow_max_distance = 12.0
	root.add_child(sun)
	var floor_mesh: PlaneMesh = PlaneMesh.new()
	floor_mesh.size = Vector2(60.0, 60.0)
	var ground: MeshInstance3D = MeshInstance3D.new()
	ground.mesh = floor_mesh
	var material: ShaderMaterial = ShaderMaterial.new()
	material.shader = load("res://assets/shaders/person.gdshader")
	material.set_shader_parameter("detail_strength", 0.0)
	var grey: Image = Image.create_empty(4, 4, false, Image.FORMAT_RGB8)
	grey.fill(Color(0.52, 0.5, 0.46))
	material.set_shader_parameter("albedo_texture", ImageTexture.create_from_image(grey))
	ground.material_override = material
	ground.position.y = -0.012
	root.add_child(ground)
	RenderingServer.global_shader_parameter_set(&"light_sky", Vector3(0.62, 0.68, 0.78))

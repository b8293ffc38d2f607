extends RefCounted
## Ground, light and a camera in a window, where effects are measured and their colours compared.

const ProcessTime: GDScript = preload("res://tests/bench/process_time.gd")
## Frames before a measurement: particles come out, shaders are compiled.
const SETTLE: int = 8

var root: Node3D = Node3D.new()
var camera: Camera3D = Camera3D.new()

var _tree: SceneTree = null
var _sky: Node = null


func _init(p_tree: SceneTree) -> void:
	_tree = p_tree
	p_tree.root.add_child(root)
	use_world_sky()
	var ground: MeshInstance3D = MeshInstance3D.new()
	var plane: PlaneMesh = PlaneMesh.new()
	plane.size = Vector2(400.0, 400.0)
	ground.mesh = plane
	var material: StandardMaterial3D = StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.albedo_color = Color(0.55, 0.5, 0.42)
	ground.material_override = material
	root.add_child(ground)
	root.add_child(camera)
	look(8.0)


## Has the sky, sun and air of a level.
func use_world_sky() -> void:
	_free_sky()
	var sky: WorldSky = (load("res://scenes/world/sky/world_sky.tscn") as PackedScene).instantiate()
	sky.entity = null
	_sky = sky
	root.add_child(sky)


## Has nothing behind effects: a shadow map and a sky cost more than effects do.
func use_plain_sky() -> void:
	_free_sky()
	var plain: WorldEnvironment = WorldEnvironment.new()
	plain.environment = Environment.new()
	plain.environment.background_mode = Environment.BG_COLOR
	plain.environment.background_color = Color(0.4, 0.5, 0.6)
	_sky = plain
	root.add_child(plain)


## Looks at the origin from a distance, m.
func look(p_away: float) -> void:
	var up: Vector3 = Vector3(0.0, p_away * 0.12, 0.0)
	camera.look_at_from_position(Vector3(0.0, p_away * 0.2, p_away), up)


## Processor time of all threads of the mean frame, ms: it holds on a loaded machine too.
func frame_ms(p_frames: int) -> float:
	await frames(SETTLE)
	var before: float = ProcessTime.used_ms()
	await frames(p_frames)
	return (ProcessTime.used_ms() - before) / p_frames


## Lets some frames be drawn.
func frames(p_count: int) -> void:
	for _frame: int in p_count:
		await _tree.process_frame


## What is in the window.
func picture() -> Image:
	await RenderingServer.frame_post_draw
	var image: Image = _tree.root.get_texture().get_image()
	image.convert(Image.FORMAT_RGB8)
	return image


func _free_sky() -> void:
	if _sky != null:
		_sky.free()

extends SceneTree
## What both eyes see of a small square at known depths, as the panel shows it: a JSON line for each
## way of stereo, depth and place of the window.
##
## Options: --modes=NAME,...; --origins=X:Y,... of the window on its panel; --scale=FACTOR of its
## texts, which is none of the pictures'.

const EYES_M: float = 0.065
const CONVERGENCE_M: float = 3.0
const FOV_DEG: float = 60.0
const DEPTHS_M: Array[float] = [1.0, 2.0, 3.0, 6.0, 20.0]
## The square is moved over two pixels, by parts of them: its edges are not smoothed, and an eye has
## every second column only where they are shared.
const SHIFTS: int = 16
const SHIFT_PIXELS: float = 2.0
## Values of background and square: grey, so that coloured glasses part them without clipping.
const BACK: float = 0.4
const FRONT: float = 0.7
const FRAMES: int = 2

var _camera: Camera3D = Camera3D.new()
var _square: MeshInstance3D = MeshInstance3D.new()
var _display: StereoDisplay = null


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	_build()
	root.content_scale_factor = _option("scale", "1").to_float()
	for mode: String in _option("modes", "side-by-side").split(","):
		for origin: String in _option("origins", "0:0").split(","):
			var parts: PackedStringArray = origin.split(":")
			await _measure(mode, Vector2i(parts[0].to_int(), parts[1].to_int()))
	quit()


func _option(p_name: String, p_default: String) -> String:
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with("--%s=" % p_name):
			return argument.get_slice("=", 1)
	return p_default


func _build() -> void:
	var scene: Node3D = Node3D.new()
	root.add_child(scene)
	var world: WorldEnvironment = WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color(BACK, BACK, BACK)
	scene.add_child(world)
	_camera.fov = FOV_DEG
	scene.add_child(_camera)
	var material: StandardMaterial3D = StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.albedo_color = Color(FRONT, FRONT, FRONT)
	var quad: QuadMesh = QuadMesh.new()
	quad.material = material
	_square.mesh = quad
	scene.add_child(_square)
	# The viewer is not at the origin, nor does he look along an axis.
	scene.transform = Transform3D(Basis(Vector3.UP, 0.7), Vector3(3.0, 1.6, -2.0))


func _measure(p_mode: String, p_origin: Vector2i) -> void:
	root.position = p_origin
	_display = StereoDisplay.new()
	_display.camera = _camera
	root.add_child(_display)
	var fault: String = _display.set_up(p_mode, EYES_M, CONVERGENCE_M)
	fault = _display.open() if fault == "" else fault
	if fault != "":
		printerr(fault)
		quit(1)
		return
	var size: Vector2i = root.size
	var pixel: float = 2.0 * tan(deg_to_rad(FOV_DEG) * 0.5) / size.y
	for depth: float in DEPTHS_M:
		(_square.mesh as QuadMesh).size = Vector2.ONE * 40.0 * pixel * depth
		var sum: float = 0.0
		for shift: int in SHIFTS:
			var at: float = 0.03 + pixel * SHIFT_PIXELS * (shift + 0.5) / SHIFTS
			_square.position = Vector3(at * depth, 0.05 * depth, -depth)
			for _frame: int in FRAMES:
				await RenderingServer.frame_post_draw
			sum += _disparity(p_mode, await _picture())
		var wanted: float = EYES_M * (1.0 / CONVERGENCE_M - 1.0 / depth) / pixel
		var row: Dictionary = {
			"mode": p_mode, "depth": depth, "got": sum / SHIFTS, "wanted": wanted, "at": p_origin
		}
		print(JSON.stringify(row))
	_display.close()
	_display.queue_free()
	await process_frame


## What the panel shows there where the window is: of the screen itself.
func _picture() -> Image:
	await process_frame
	DisplayServer.process_events()
	var panel: Image = DisplayServer.screen_get_image(root.current_screen)
	return panel.get_region(Rect2i(root.position, root.size))


## Pixels by which the right eye sees the square further to the right.
func _disparity(p_mode: String, p_picture: Image) -> float:
	var size: Vector2i = p_picture.get_size()
	var sums: Array[Vector2] = [Vector2.ZERO, Vector2.ZERO]
	# The square is there for both eyes.
	for y: int in range(size.y / 2 - 60, size.y / 2 + 20):
		for x: int in size.x:
			var color: Color = p_picture.get_pixel(x, y)
			var at: Vector2i = Vector2i(x, y)
			if p_mode == "anaglyph":
				_add(sums, 0, x, _unmixed(color.srgb_to_linear(), true))
				_add(sums, 1, x, _unmixed(color.srgb_to_linear(), false))
			elif p_mode.begins_with("side-by-side"):
				var eye: int = 1 if x >= size.x / 2 else 0
				var wide: float = 1.0 if p_mode.ends_with("full") else 2.0
				var inside: int = x - eye * size.x / 2
				_add(sums, eye, (inside + 0.5) * wide, (color.g - BACK) / (FRONT - BACK))
			else:
				var own: Vector2i = root.position + at
				var line: int = own.y if p_mode == "rows" else own.x
				_add(sums, line & 1, x, (color.g - BACK) / (FRONT - BACK))
	return sums[1].x / sums[1].y - sums[0].x / sums[0].y


func _add(p_sums: Array[Vector2], p_eye: int, p_x: float, p_weight: float) -> void:
	# Edges are not smoothed; values have 8 bits.
	if p_weight > 0.5:
		p_sums[p_eye] += Vector2(p_x, 1.0)


## How much of the square one eye sees through its glass: Dubois' matrices for greys, solved.
func _unmixed(p_light: Color, p_is_left: bool) -> float:
	var red: Vector2 = Vector2(1.132965, -0.13296488)
	var green: Vector2 = Vector2(-0.0936658, 1.0936737)
	var cut: float = red.x * green.y - red.y * green.x
	var left: float = (p_light.r * green.y - red.y * p_light.g) / cut
	var right: float = (red.x * p_light.g - p_light.r * green.x) / cut
	var back: float = Color(BACK, 0.0, 0.0).srgb_to_linear().r
	var front: float = Color(FRONT, 0.0, 0.0).srgb_to_linear().r
	return ((left if p_is_left else right) - back) / (front - back)

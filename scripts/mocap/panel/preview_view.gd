class_name PreviewView
extends SubViewportContainer
## A small world of its own: a floor, a light, a camera in front, and what is put into
## [member stage].

## How far away the camera is, m.
const DISTANCE_M: float = 3.5
## How much the camera sees across the shorter side, degrees: arms that are stretched out too.
const FOV_DEG: float = 40.0
## What the camera looks at, m.
const TARGET: Vector3 = Vector3(0.0, 0.93, 0.0)

## What is shown hangs here.
var stage: Node3D = Node3D.new()

var _viewport: SubViewport = SubViewport.new()
var _camera: Camera3D = Camera3D.new()


func _init() -> void:
	stretch = true
	mouse_filter = Control.MOUSE_FILTER_IGNORE
	_viewport.own_world_3d = true
	_viewport.msaa_3d = Viewport.MSAA_2X
	_viewport.handle_input_locally = false
	_viewport.render_target_update_mode = SubViewport.UPDATE_WHEN_VISIBLE
	add_child(_viewport)
	_viewport.add_child(stage)
	_camera.fov = FOV_DEG
	_camera.position = TARGET + Vector3(0.7, 0.25, DISTANCE_M)
	_camera.basis = Basis.looking_at(TARGET - _camera.position)
	_viewport.add_child(_camera)
	resized.connect(_fit)
	var light: DirectionalLight3D = DirectionalLight3D.new()
	light.basis = Basis.looking_at(Vector3(-0.4, -1.0, -0.7))
	_viewport.add_child(light)
	_viewport.add_child(_make_surroundings())
	_viewport.add_child(_make_floor())


func _fit() -> void:
	var is_narrow: bool = size.x < size.y
	_camera.keep_aspect = Camera3D.KEEP_WIDTH if is_narrow else Camera3D.KEEP_HEIGHT


static func _make_surroundings() -> WorldEnvironment:
	var surroundings: WorldEnvironment = WorldEnvironment.new()
	surroundings.environment = Environment.new()
	surroundings.environment.background_mode = Environment.BG_COLOR
	surroundings.environment.background_color = Color(0.16, 0.18, 0.21)
	surroundings.environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	surroundings.environment.ambient_light_color = Color(0.6, 0.65, 0.7)
	return surroundings


static func _make_floor() -> MeshInstance3D:
	var plane: PlaneMesh = PlaneMesh.new()
	plane.size = Vector2(2.4, 2.4)
	var look: StandardMaterial3D = StandardMaterial3D.new()
	look.albedo_color = Color(0.25, 0.27, 0.3)
	plane.material = look
	var floor_plate: MeshInstance3D = MeshInstance3D.new()
	floor_plate.mesh = plane
	return floor_plate

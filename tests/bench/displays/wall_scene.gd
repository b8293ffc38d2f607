class_name WallScene
extends Node3D
## What walls are measured with: a room of shaded boxes around a viewer.

## Where the viewer is, m, and where he looks, as a heading.
const EYE: Vector3 = Vector3(1.0, 1.7, -2.0)
const HEADING: float = 0.4

var camera: Camera3D = Camera3D.new()


func _init() -> void:
	var world: WorldEnvironment = WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color(0.30, 0.36, 0.45)
	world.environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	world.environment.ambient_light_color = Color(0.5, 0.5, 0.5)
	add_child(world)
	var sun: DirectionalLight3D = DirectionalLight3D.new()
	sun.rotation = Vector3(-0.9, 0.5, 0.0)
	add_child(sun)
	var ground: MeshInstance3D = MeshInstance3D.new()
	var plane: PlaneMesh = PlaneMesh.new()
	plane.size = Vector2(200.0, 200.0)
	ground.mesh = plane
	add_child(ground)
	for at: int in 18:
		var box: MeshInstance3D = MeshInstance3D.new()
		box.mesh = BoxMesh.new()
		var material: StandardMaterial3D = StandardMaterial3D.new()
		material.albedo_color = Color.from_hsv(at / 18.0, 0.4, 0.8)
		box.material_override = material
		var around: float = at * TAU / 18.0
		var away: float = 4.0 + (at % 3) * 2.0
		box.position = EYE + Vector3(sin(around) * away, -0.9 + (at % 4) * 0.6, cos(around) * away)
		box.rotation = Vector3(at, at * 0.7, 0.0)
		add_child(box)
	camera.position = EYE
	camera.rotation.y = HEADING
	camera.near = 0.05
	add_child(camera)


## Waits for frames of a window.
static func draw(p_frames: int) -> void:
	for _frame: int in p_frames:
		await RenderingServer.frame_post_draw

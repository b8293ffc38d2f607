class_name TuningGround
extends Node3D
## Ground to try a vehicle on: flat, with slopes, steps, a trench between two banks, and bumps.

## Extent of the flat ground, m.
const SIZE: float = 800.0


func _ready() -> void:
	_add(Vector3(SIZE, 2.0, SIZE), Transform3D(Basis.IDENTITY, Vector3.DOWN), Color(0.55, 0.5, 0.4))
	for index: int in 3:
		# 30, 45 and 60 %, side by side.
		var slope: Basis = Basis(Vector3.RIGHT, atan(0.3 + 0.15 * index))
		var at: Vector3 = (
			Vector3(30.0 + 14.0 * index, 0.0, -60.0) + slope * Vector3(0.0, -1.0, -20.0)
		)
		_add(Vector3(12.0, 2.0, 44.0), Transform3D(slope, at), Color(0.6, 0.45, 0.35))
	for index: int in 4:
		var height: float = 0.3 * (index + 1)
		var at: Vector3 = Vector3(-30.0 - 14.0 * index, 0.5 * height, -70.0)
		_add(Vector3(12.0, height, 30.0), Transform3D(Basis.IDENTITY, at), Color(0.5, 0.5, 0.55))
	for index: int in 20:
		var ridge: Vector3 = Vector3(0.0, -0.42, -40.0 - 8.0 * index)
		_add_ridge(ridge)


func _add(p_size: Vector3, p_at: Transform3D, p_colour: Color) -> void:
	var shape: BoxShape3D = BoxShape3D.new()
	shape.size = p_size
	var mesh: BoxMesh = BoxMesh.new()
	mesh.size = p_size
	_add_body(shape, mesh, p_at, p_colour)


## A bump of 0.18 m: the top of a pipe that lies across.
func _add_ridge(p_at: Vector3) -> void:
	var shape: CylinderShape3D = CylinderShape3D.new()
	shape.radius = 0.6
	shape.height = 10.0
	var mesh: CylinderMesh = CylinderMesh.new()
	mesh.top_radius = shape.radius
	mesh.bottom_radius = shape.radius
	mesh.height = shape.height
	_add_body(shape, mesh, Transform3D(Basis(Vector3.BACK, PI / 2.0), p_at), Color(0.4, 0.4, 0.3))


func _add_body(p_shape: Shape3D, p_mesh: Mesh, p_at: Transform3D, p_colour: Color) -> void:
	var body: StaticBody3D = StaticBody3D.new()
	var collision: CollisionShape3D = CollisionShape3D.new()
	collision.shape = p_shape
	var drawn: MeshInstance3D = MeshInstance3D.new()
	drawn.mesh = p_mesh
	var material: StandardMaterial3D = StandardMaterial3D.new()
	material.albedo_color = p_colour
	drawn.material_override = material
	body.add_child(collision)
	body.add_child(drawn)
	body.transform = p_at
	add_child(body)

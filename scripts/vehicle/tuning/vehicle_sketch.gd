class_name VehicleSketch
extends Node3D
## Draws a vehicle as the physics has it: the shapes of its hull, and its wheels.

## The vehicle that is drawn.
var vehicle: Vehicle = null

var _wheels: Array[MeshInstance3D] = []


func _process(_delta: float) -> void:
	if vehicle == null or not is_instance_valid(vehicle):
		return
	var wanted: Array[VehicleWheel] = vehicle.parameters.wheels_of(vehicle.gear_kind())
	if _wheels.size() != wanted.size():
		_build(wanted)
	global_transform = vehicle.global_transform
	for index: int in _wheels.size():
		_wheels[index].transform = vehicle.wheel_transform(index)


func _build(p_wheels: Array[VehicleWheel]) -> void:
	for child: Node in get_children():
		child.queue_free()
	_wheels.clear()
	for shape: Node in vehicle.find_children("*", "CollisionShape3D", false, false):
		var hull: MeshInstance3D = MeshInstance3D.new()
		hull.mesh = (shape as CollisionShape3D).shape.get_debug_mesh()
		hull.transform = (shape as CollisionShape3D).transform
		add_child(hull)
	var tyres: bool = vehicle.parameters.steering_kind == VehicleParameters.Steering.WHEELS
	for wheel: VehicleWheel in p_wheels:
		var drawn: MeshInstance3D = MeshInstance3D.new()
		drawn.mesh = _mesh_of(wheel, tyres)
		add_child(drawn)
		_wheels.append(drawn)


## A sphere with few sides, so that it is seen to turn, or a disc that stands upright.
func _mesh_of(p_wheel: VehicleWheel, p_is_disc: bool) -> Mesh:
	if not p_is_disc:
		var sphere: SphereMesh = SphereMesh.new()
		sphere.radius = p_wheel.radius
		sphere.height = 2.0 * p_wheel.radius
		sphere.radial_segments = 12
		sphere.rings = 6
		return sphere
	var disc: TorusMesh = TorusMesh.new()
	disc.outer_radius = p_wheel.radius
	disc.inner_radius = 0.6 * p_wheel.radius
	disc.rings = 12
	disc.ring_segments = 8
	# A torus lies flat: its axle is to lie along x.
	var tool: SurfaceTool = SurfaceTool.new()
	tool.append_from(disc, 0, Transform3D(Basis(Vector3.BACK, PI / 2.0), Vector3.ZERO))
	return tool.commit()

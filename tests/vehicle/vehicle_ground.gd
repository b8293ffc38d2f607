class_name VehicleGround
extends RefCounted
## A world of its own with ground to drive on, for tests and benchmarks of vehicles.

## What it is made in.
var view: SubViewport = SubViewport.new()

var _tree: SceneTree = null


func _init(p_parent: Node) -> void:
	view.own_world_3d = true
	p_parent.add_child(view)
	_tree = p_parent.get_tree()


## Flat ground at height 0.
func add_floor() -> StaticBody3D:
	return add_box(Vector3(3000.0, 2.0, 3000.0), Transform3D(Basis.IDENTITY, Vector3.DOWN))


## A solid box.
func add_box(p_size: Vector3, p_at: Transform3D) -> StaticBody3D:
	var body: StaticBody3D = StaticBody3D.new()
	var shape: CollisionShape3D = CollisionShape3D.new()
	var box: BoxShape3D = BoxShape3D.new()
	box.size = p_size
	shape.shape = box
	body.add_child(shape)
	body.transform = p_at
	view.add_child(body)
	return body


## A plane through the origin, turned about an axis by a slope, as a share (0.6 is 60 %).
func add_slope(p_slope: float, p_axis: Vector3) -> StaticBody3D:
	var turned: Basis = Basis(p_axis, atan(p_slope))
	return add_box(Vector3(600.0, 2.0, 600.0), Transform3D(turned, -turned.y))


## A preset, with the running gear that is meant.
func add_vehicle(
	p_preset: String, p_kind: VehicleParameters.GearKind, p_at: Transform3D = Transform3D.IDENTITY
) -> Vehicle:
	var vehicle: Vehicle = create(p_preset)
	vehicle.set_gear_kind(p_kind)
	vehicle.transform = p_at
	view.add_child(vehicle)
	return vehicle


## A preset that is not in the world yet.
static func create(p_preset: String) -> Vehicle:
	var path: String = "res://scenes/vehicle/%s/%s.tscn" % [p_preset, p_preset]
	return (load(path) as PackedScene).instantiate()


## Simulates so many seconds.
func run(p_seconds: float) -> void:
	for _tick: int in roundi(p_seconds * Engine.physics_ticks_per_second):
		await _tree.physics_frame


## Speed in the way that a vehicle looks, m/s.
static func speed_of(p_vehicle: Vehicle) -> float:
	return -p_vehicle.linear_velocity.dot(p_vehicle.global_basis.z)


func free_all() -> void:
	view.queue_free()

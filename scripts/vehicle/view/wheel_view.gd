class_name WheelView
extends RefCounted
## The wheels of one side of a vehicle that stands on tyres: they turn, follow the ground, and the
## foremost ones steer.

const _SIDES: Array[String] = ["L", "R"]
const _MAX_WHEELS: int = 6

## How far they have rolled since they were shown first, m, forward positive.
var way: float = 0.0
## Their lowest points at rest, in the vehicle's frame, from rear to front.
var feet: PackedVector3Array = []

var _wheels: Array[Node3D] = []
var _rest: Array[Transform3D] = []
var _radius: PackedFloat32Array = []


## Takes over a side's wheels (0 left, 1 right) of a model, in which they are numbered from the
## front.
func configure(p_model: Node3D, p_side: int) -> void:
	for number: int in range(_MAX_WHEELS, 0, -1):
		var name: String = "Wheel_%s%d" % [_SIDES[p_side], number]
		var wheel: MeshInstance3D = p_model.find_child(name, true, false) as MeshInstance3D
		if wheel == null:
			continue
		var radius: float = wheel.mesh.get_aabb().size.y / 2.0
		_wheels.append(wheel)
		_rest.append(wheel.transform)
		_radius.append(radius)
		feet.append(wheel.position - Vector3(0.0, radius, 0.0))


## Rolls on by a speed (m/s) for a time (s), lifted by [param p_lifts] (m, from rear to front); the
## foremost wheel is turned by [param p_steer], rad, to the left.
func advance(p_speed: float, p_delta: float, p_lifts: PackedFloat32Array, p_steer: float) -> void:
	way += p_speed * p_delta
	for index: int in _wheels.size():
		var rolled: Basis = Basis(Vector3.RIGHT, fmod(-way / _radius[index], TAU))
		var basis: Basis = rolled * _rest[index].basis
		if index == _wheels.size() - 1:
			basis = Basis(Vector3.UP, p_steer) * basis
		var place: Vector3 = _rest[index].origin + Vector3(0.0, p_lifts[index], 0.0)
		_wheels[index].transform = Transform3D(basis, place)

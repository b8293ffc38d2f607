class_name GroundRun
extends RefCounted
## One person on the scale: what carries the body, and how well it follows.

## Limbs of the upper body, by their place in [constant Limbs.BONES].
const UPPER: int = 10

## Vertical force on the floor, N, one entry a step.
var carried: PackedFloat64Array = []
## Force and torque from outside, N and N·m: the sizes of the vectors.
var forces: PackedFloat64Array = []
var torques: PackedFloat64Array = []
## Mean error of all limbs, and of those above the legs, deg.
var errors: PackedFloat64Array = []
var upper: PackedFloat64Array = []
## Height of the hips over the floor, and where the motion has them, m.
var heights: PackedFloat64Array = []
var wanted_heights: PackedFloat64Array = []
## How far the hips are from the wearer's, level, m.
var distances: PackedFloat64Array = []
## How fast limbs turn against the motion, mean of all, deg/s.
var jitter: PackedFloat64Array = []
## Steps that the motion does not have.
var steps: int = 0

var world: ContactWorld = null
var person: ContactPerson = null
var _plate: GroundPlate = null
var _bodies_before: Array[Transform3D] = []
var _hips_before: Vector3 = Vector3.ZERO
var _way: float = 0.0
var _was_stepping: bool = false
var _residual: GroundResidual = null


## Begins with a world that holds a floor of force; somebody enters it next.
func _init(p_tree: SceneTree, p_hz: int) -> void:
	world = ContactWorld.new(p_hz)
	p_tree.root.add_child(world)
	_plate = GroundPlate.new(world, Vector3.ZERO, GroundPlate.WIDE)


## Notes the state after a step; for [method ContactWorld.run].
func note() -> bool:
	if _residual == null:
		_residual = GroundResidual.new(person, _plate)
	if _residual.note(world.delta_s):
		forces.append(_residual.force.length())
		torques.append(_residual.torque.length())
	carried.append(_plate.force.y)
	var balance: Dictionary = person.ragdoll.motor.get_balance()
	var is_stepping: bool = balance.get("is_stepping", false)
	steps += 1 if is_stepping and not _was_stepping else 0
	_was_stepping = is_stepping
	var bodies: Array[Transform3D] = person.bodies()
	var wanted: Array[Transform3D] = person.targets_at(world.time_s)
	var sum: float = 0.0
	var above: float = 0.0
	for slot: int in Limbs.COUNT:
		var limb: int = person.find(Limbs.BONES[slot])
		var error: float = ContactPerson.angle_deg(bodies[limb].basis, wanted[limb].basis)
		sum += error
		above += error if slot < UPPER else 0.0
	errors.append(sum / Limbs.COUNT)
	if not _bodies_before.is_empty():
		var turned: float = 0.0
		for limb: int in person.count:
			turned += ContactPerson.angle_deg(_bodies_before[limb].basis, bodies[limb].basis)
		jitter.append(turned / person.count / world.delta_s)
	_bodies_before = bodies
	upper.append(above / UPPER)
	var off: Vector3 = person.joint(0, bodies) - person.joint(0, wanted)
	distances.append(Vector2(off.x, off.z).length())
	var hips: Vector3 = person.joint(0, wanted) * Vector3(1.0, 0.0, 1.0)
	_way += hips.distance_to(_hips_before) if not heights.is_empty() else 0.0
	_hips_before = hips
	heights.append(person.joint(0, bodies).y)
	wanted_heights.append(person.joint(0, wanted).y)
	return false


## Weight of the person, N.
func weight() -> float:
	var mass: float = 0.0
	for limb: int in person.count:
		mass += person.mass_of(limb)
	return mass * 9.81


## How fast the wearer walks on average, m/s.
func speed() -> float:
	return _way / maxf(world.time_s, world.delta_s)


func end() -> void:
	world.queue_free()


static func mean(p_values: PackedFloat64Array, p_from: int = 0) -> float:
	var sum: float = 0.0
	for i: int in range(p_from, p_values.size()):
		sum += p_values[i]
	return sum / maxi(p_values.size() - p_from, 1)


static func percentile(p_values: PackedFloat64Array, p_share: float) -> float:
	var sorted: PackedFloat64Array = p_values.duplicate()
	sorted.sort()
	return sorted[int((sorted.size() - 1) * p_share)] if not sorted.is_empty() else 0.0

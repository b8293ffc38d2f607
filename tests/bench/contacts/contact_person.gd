class_name ContactPerson
extends RefCounted
## A ragdoll with its motion: where its bodies are, where they are to be, and what that tells.
##
## Bodies are counted as in the ragdoll's profile. All places are in the world, m.

## Who is driven.
var ragdoll: Ragdoll = null
## The pose at a time, s: a PoseSample.
var pose: Callable = Callable()
## Where the hips are to be at a time, s: a Vector3.
var place: Callable = Callable()
## How many limbs there are.
var count: int = 0

var _reset: Array[Quaternion] = []
var _limbs: PackedInt32Array = PackedInt32Array()
var _parents: PackedInt32Array = PackedInt32Array()
var _anchors: PackedVector3Array = PackedVector3Array()
var _offsets: PackedVector3Array = PackedVector3Array()
var _turns: Array[Quaternion] = []
var _masses: PackedFloat64Array = PackedFloat64Array()
var _inertias: PackedVector3Array = PackedVector3Array()


## Looks at a ragdoll that is in the tree; it need not be started.
func _init(p_ragdoll: Ragdoll) -> void:
	ragdoll = p_ragdoll
	var limbs: Array[RagdollLimb] = ragdoll.profile.limbs
	count = limbs.size()
	for i: int in count:
		var limb: RagdollLimb = limbs[i]
		var parent: int = ragdoll.profile.get_parent_index(i)
		var above: RagdollLimb = limbs[maxi(parent, 0)]
		var mass: float = ragdoll.profile.mass * limb.mass_fraction
		_limbs.append(Limbs.find(limb.bone))
		_parents.append(parent)
		_anchors.append(above.rest_orientation.inverse() * (limb.anchor - above.anchor))
		_offsets.append(limb.rest_orientation.inverse() * (limb.position - limb.anchor))
		_turns.append(limb.rest_orientation.inverse() * limb.orientation)
		_masses.append(mass)
		_inertias.append(limb.get_body_inertia(mass))
		_reset.append(limb.reset_orientation)


## The place of a limb by its humanoid name.
func find(p_bone: StringName) -> int:
	return _limbs.find(Limbs.find(p_bone))


## Mass of a limb, kg.
func mass_of(p_limb: int) -> float:
	return _masses[p_limb]


## Moments of inertia of a limb about its body's axes, kg·m², not scaled.
func inertia_of(p_limb: int) -> Vector3:
	return _inertias[p_limb]


## The limb that a limb hangs on, or -1.
func parent_of(p_limb: int) -> int:
	return _parents[p_limb]


## Shape of a limb.
func shape_of(p_limb: int) -> RagdollLimb:
	return ragdoll.profile.limbs[p_limb]


## Distance from a limb's joint to that of the limb that hangs on it, m.
func length_of(p_bone: StringName) -> float:
	return _anchors[_parents.find(find(p_bone))].length()


## Distance from the shoulder to the wrist of a straight arm, m. The side is "Left" or "Right".
func arm_length(p_side: String) -> float:
	return length_of(StringName(p_side + "UpperArm")) + length_of(StringName(p_side + "LowerArm"))


## Where a person who stands in the reset pose, feet at height 0, has the hips.
func standing_hips() -> Vector3:
	return Vector3(0.0, -lowest(targets(ContactPoses.reset(), Vector3.ZERO)), 0.0)


## Where a pose has all bodies. For hips that are given.
func targets(p_pose: PoseSample, p_hips: Vector3) -> Array[Transform3D]:
	var joints: PackedVector3Array = PackedVector3Array()
	var turns: Array[Quaternion] = []
	var result: Array[Transform3D] = []
	for i: int in count:
		var parent: int = _parents[i]
		turns.append(p_pose.orientation(_limbs[i]) * _reset[i])
		joints.append(p_hips if parent < 0 else joints[parent] + turns[parent] * _anchors[i])
		result.append(Transform3D(Basis(turns[i]), joints[i] + turns[i] * _offsets[i]))
	return result


## Where the motion has all bodies at a time, s.
func targets_at(p_time_s: float) -> Array[Transform3D]:
	return targets(pose.call(p_time_s), place.call(p_time_s))


## Where all bodies are.
func bodies() -> Array[Transform3D]:
	var result: Array[Transform3D] = []
	for rid: RID in ragdoll.get_bodies():
		result.append(PhysicsServer3D.body_get_state(rid, PhysicsServer3D.BODY_STATE_TRANSFORM))
	return result


## The joint of a limb, by a set of bodies.
func joint(p_limb: int, p_bodies: Array[Transform3D]) -> Vector3:
	return p_bodies[p_limb] * -_offsets[p_limb]


## How far a limb reaches in a direction, m: the largest dot product of its surface with it.
func reach(p_limb: int, p_body: Transform3D, p_direction: Vector3) -> float:
	var limb: RagdollLimb = shape_of(p_limb)
	var local: Vector3 = (p_body.basis * Basis(_turns[p_limb])).inverse() * p_direction
	var middle: float = p_body.origin.dot(p_direction)
	if limb.type == RagdollLimb.BOX:
		return middle + local.abs().dot(limb.size) / 2.0
	return middle + absf(local.y) * limb.length / 2.0 + limb.radius


## Height of the lowest point of a set of bodies, m.
func lowest(p_bodies: Array[Transform3D]) -> float:
	var result: float = INF
	for i: int in count:
		result = minf(result, -reach(i, p_bodies[i], Vector3.DOWN))
	return result


## The largest angle between a limb's orientation in one set of bodies and in another, degrees.
func worst_error_deg(p_bodies: Array[Transform3D], p_targets: Array[Transform3D]) -> float:
	var worst: float = 0.0
	for i: int in count:
		worst = maxf(worst, angle_deg(p_bodies[i].basis, p_targets[i].basis))
	return worst


## The largest gap of any joint, m.
func gap(p_bodies: Array[Transform3D]) -> float:
	var largest: float = 0.0
	for i: int in range(1, count):
		var in_parent: Vector3 = _anchors[i] - _offsets[_parents[i]]
		var other: Vector3 = p_bodies[_parents[i]] * in_parent
		largest = maxf(largest, joint(i, p_bodies).distance_to(other))
	return largest


## Velocity of a limb's centre, m/s.
func velocity_of(p_limb: int) -> Vector3:
	return _velocity(ragdoll.get_bodies()[p_limb])


## Turning rate of a limb, world axes, rad/s.
func spin_of(p_limb: int) -> Vector3:
	return PhysicsServer3D.body_get_state(
		ragdoll.get_bodies()[p_limb], PhysicsServer3D.BODY_STATE_ANGULAR_VELOCITY
	)


## Internal kinetic energy, J: that of all limbs about the common centre of mass.
func energy() -> float:
	var linear: PackedVector3Array = PackedVector3Array()
	var angular: PackedVector3Array = PackedVector3Array()
	var places: Array[Transform3D] = bodies()
	for i: int in count:
		linear.append(velocity_of(i))
		angular.append(places[i].basis.inverse() * spin_of(i))
	var mass: float = 0.0
	var momentum: Vector3 = Vector3.ZERO
	for i: int in count:
		mass += _masses[i]
		momentum += linear[i] * _masses[i]
	var common: Vector3 = momentum / mass
	var sum: float = 0.0
	for i: int in count:
		sum += 0.5 * _masses[i] * (linear[i] - common).length_squared()
		sum += 0.5 * _inertias[i].dot(angular[i] * angular[i])
	return sum


## The rotation vector from one orientation to another, rad, in the first one's axes. Precise also
## for the smallest angles.
static func turn_between(p_from: Basis, p_to: Basis) -> Vector3:
	var turn: Quaternion = (
		p_from.get_rotation_quaternion().inverse() * p_to.get_rotation_quaternion()
	)
	var part: Vector3 = Vector3(turn.x, turn.y, turn.z) * (1.0 if turn.w >= 0.0 else -1.0)
	var sine: float = part.length()
	return part * 2.0 if sine < 1e-6 else part * (2.0 * atan2(sine, absf(turn.w)) / sine)


## The angle between two orientations, degrees.
static func angle_deg(p_from: Basis, p_to: Basis) -> float:
	return rad_to_deg(turn_between(p_from, p_to).length())


func _velocity(p_body: RID) -> Vector3:
	return PhysicsServer3D.body_get_state(p_body, PhysicsServer3D.BODY_STATE_LINEAR_VELOCITY)

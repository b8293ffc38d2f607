extends ContactScene
## A ball of 5 kg that flies at 10 m/s against a person who stands.
##
## The time to recover is that from the first step in which the ball has lost speed until all limbs
## are within 5 degrees of the pose again, and stay there as long as it is watched. A value as long
## as the watch ([constant _WATCH_S]) means that they were not at its end. The ball has no weight
## until it hits.

const _MASS: float = 5.0
const _SPEED: float = 10.0
const _RADIUS: float = 0.11
const _DISTANCE: float = 0.8
const _SETTLE_S: float = 0.5
const _WATCH_S: float = 3.0
const _LIMIT_DEG: float = 5.0
const _GOAL_MS: float = 120.0
const _STRENGTHS: Array[float] = [1.0, 0.3]
## What is hit, and whether the person guards the face.
const _TARGETS: Dictionary[StringName, bool] = {
	&"Chest": false, &"Head": false, &"RightLowerArm": true, &"RightUpperLeg": false
}

var _hit_s: float = -1.0
var _late_s: float = -1.0
var _worst_deg: float = 0.0


func play(p_performer: ContactPerformer) -> void:
	for strength: float in _STRENGTHS:
		for bone: StringName in _TARGETS:
			await _throw(p_performer, bone, strength)


func _throw(p_performer: ContactPerformer, p_bone: StringName, p_strength: float) -> void:
	var world: ContactWorld = make_world()
	var properties: Dictionary[StringName, float] = {&"strength": p_strength}
	var person: ContactPerson = p_performer.enter(world, root, properties)
	var pose: PoseSample = ContactPoses.standing(person)
	if _TARGETS[p_bone]:
		pose = ContactPoses.guard(person)
	world.add_standing(person, pose, person.standing_hips())
	await world.run(_SETTLE_S)
	var from: Vector3 = person.bodies()[person.find(p_bone)].origin + Vector3.BACK * _DISTANCE
	var ball: RigidBody3D = world.add_ball(_RADIUS, from, _MASS)
	ball.gravity_scale = 0.0
	ball.linear_velocity = Vector3.FORWARD * _SPEED
	_hit_s = -1.0
	_late_s = -1.0
	_worst_deg = 0.0
	await world.run(_WATCH_S + _DISTANCE / _SPEED, _watch.bind(world, ball))
	var scene: String = "ball %s" % String(p_bone).trim_prefix("Right").to_lower()
	if p_strength < 1.0:
		scene += " at strength %s" % p_strength
	var case: String = name_case(scene, p_performer)
	var has: bool = p_strength >= 1.0 and hz == 60
	var recovery_s: float = minf(maxf(_late_s - _hit_s, 0.0), _WATCH_S)
	report.at_most(case, "time until < 5 deg", recovery_s * 1000.0, "ms", _GOAL_MS, has)
	report.add(case, "largest error", _worst_deg, "deg")
	await end_world(world)


func _watch(p_world: ContactWorld, p_ball: RigidBody3D) -> bool:
	if _hit_s < 0.0:
		if p_ball.linear_velocity.z < 0.1 - _SPEED:
			return false
		# The contact began within the step that has just passed.
		_hit_s = p_world.time_s - p_world.delta_s
		_late_s = _hit_s
		p_ball.gravity_scale = 1.0
	var person: ContactPerson = p_world.people[0]
	var error: float = person.worst_error_deg(person.bodies(), person.targets_at(p_world.time_s))
	_worst_deg = maxf(_worst_deg, error)
	if error >= _LIMIT_DEG:
		# Below it again by the end of the next step at the earliest.
		_late_s = p_world.time_s + p_world.delta_s
	return p_world.time_s > _hit_s + _WATCH_S

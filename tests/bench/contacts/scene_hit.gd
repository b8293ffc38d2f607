extends ContactScene
## The blow of a ball of 5 kg at 10 m/s as a call ([method RagdollMotor.hit]), on a person who
## stands.
##
## The trunk has to turn by 8 to 20 degrees, and to be back within 2 degrees of the pose 0.6 s after
## the blow. That is meant for an adult of the soldier's size: how far it turns goes with the height
## to the power of -5 (lever and blow squared over inertia and torque), so smaller figures turn
## more.

const _IMPULSE: float = 50.0
const _SETTLE_S: float = 0.5
const _WATCH_S: float = 1.5
const _BACK_DEG: float = 2.0
const _LEAST_DEG: float = 8.0
const _MOST_DEG: float = 20.0
const _GOAL_MS: float = 600.0
## No limb shall be bent further than a neck can be, deg.
const _WORST_DEG: float = 50.0
## Where the blow comes from, for the trunk.
const _DIRECTIONS: Dictionary[String, Vector3] = {
	"front": Vector3.FORWARD, "side": Vector3.RIGHT, "back": Vector3.BACK
}

var _largest_deg: float = 0.0
var _late_s: float = 0.0
var _worst_deg: float = 0.0


func play(p_performer: ContactPerformer) -> void:
	for from: String in _DIRECTIONS:
		await _hit(p_performer, &"Chest", from)
	await _hit(p_performer, &"Head", "front")
	await _hit(p_performer, &"RightUpperLeg", "front")


func _hit(p_performer: ContactPerformer, p_bone: StringName, p_from: String) -> void:
	var world: ContactWorld = make_world()
	var person: ContactPerson = p_performer.enter(world, root)
	var pose: PoseSample = ContactPoses.standing(person)
	world.add_standing(person, pose, person.standing_hips())
	await world.run(_SETTLE_S)
	var limb: int = person.find(p_bone)
	var struck: int = person.ragdoll.motor.hit(
		_DIRECTIONS[p_from] * _IMPULSE, person.bodies()[limb].origin
	)
	_largest_deg = 0.0
	_worst_deg = 0.0
	_late_s = 0.0
	await world.run(_WATCH_S, _watch.bind(world, world.time_s))
	var case: String = name_case("hit %s, %s" % [String(p_bone).to_lower(), p_from], p_performer)
	var is_trunk: bool = p_bone == &"Chest" and hz == 60 and p_performer.name == "soldier"
	report.at_least(case, "trunk turns", _largest_deg, "deg", _LEAST_DEG, is_trunk)
	if is_trunk:
		report.at_most(case, "trunk turns", _largest_deg, "deg", _MOST_DEG, is_trunk)
	report.at_most(case, "trunk is back", _late_s * 1000.0, "ms", _GOAL_MS, is_trunk)
	report.at_most(case, "worst limb", _worst_deg, "deg", _WORST_DEG)
	report.at_least(case, "right limb", 1.0 if struck == limb else 0.0, "", 1.0)
	await end_world(world)


func _watch(p_world: ContactWorld, p_hit_s: float) -> bool:
	var person: ContactPerson = p_world.people[0]
	var bodies: Array[Transform3D] = person.bodies()
	var targets: Array[Transform3D] = person.targets_at(p_world.time_s)
	var chest: int = person.find(&"Chest")
	var off: float = ContactPerson.angle_deg(bodies[chest].basis, targets[chest].basis)
	_largest_deg = maxf(_largest_deg, off)
	_worst_deg = maxf(_worst_deg, person.worst_error_deg(bodies, targets))
	if off > _BACK_DEG:
		_late_s = p_world.time_s + p_world.delta_s - p_hit_s
	return false

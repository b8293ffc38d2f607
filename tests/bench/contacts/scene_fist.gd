extends ContactScene
## A straight punch with the right fist, 4 m/s fast when it hits a free crate of 10 and of 40 kg
## that lies on a slippery table, its middle at the fist's height.
##
## A jab: the fist brakes within the last sixth of the arm's length and goes back as it came. The
## crate's speed is taken 100 ms after the first contact, when they are apart again. It is compared
## with the inelastic estimate v m / (m + M): v is the speed that the hand had in the step before
## the contact, M the crate's mass, m the mass of the arm for the blow. That lies between two
## bounds, both from the body's own masses and joints: the effective mass of an arm whose muscles
## do nothing ([ContactEffectiveMass]), and the mass of the whole arm, as if the muscles kept it
## stiff. The goal is within 30 % of the second.

const _MASSES: Array[float] = [10.0, 40.0]
const _SIZE: float = 0.5
const _SPEED: float = 4.0
const _FRICTION: float = 0.02
const _SETTLE_S: float = 0.3
const _WINDOW_S: float = 0.1
const _GOAL_PERCENT: float = 30.0
## Shares of the arm's length at which the fist starts, hits, begins to brake, and stops.
const _FROM: float = 0.3
const _HIT: float = 0.75
const _BRAKE: float = 0.76
const _TO: float = 0.92

var _world: ContactWorld = null
var _person: ContactPerson = null
var _crate: RigidBody3D = null
var _hand: int = 0
var _hit_s: float = -1.0
var _fist_speed: float = 0.0
var _crate_speed: float = 0.0


func play(p_performer: ContactPerformer) -> void:
	var speeds: PackedFloat64Array = PackedFloat64Array()
	for mass: float in _MASSES:
		await _strike(p_performer, mass)
		speeds.append(_crate_speed)
	var case: String = name_case("fist", p_performer)
	report.add(case, "light crate's speed by heavy's", speeds[0] / speeds[1], "")


func _strike(p_performer: ContactPerformer, p_mass: float) -> void:
	_world = make_world()
	_person = p_performer.enter(_world, root)
	_hand = _person.find(&"RightHand")
	var hips: Vector3 = _person.standing_hips()
	_world.add_person(_person, _pose, func(_time: float) -> Vector3: return hips)
	var at_hit: Array[Transform3D] = _person.targets(_fist(_HIT), hips)
	_place_crate(at_hit, p_mass)
	_hit_s = -1.0
	await _world.run(_SETTLE_S + 1.0, _watch)
	var case: String = name_case("fist on %d kg" % int(p_mass), p_performer)
	var arm: float = 0.0
	for part: StringName in [&"RightUpperArm", &"RightLowerArm", &"RightHand"]:
		arm += _person.mass_of(_person.find(part))
	var limp: float = ContactEffectiveMass.of_arm(_person, at_hit, "Right", Vector3.BACK)
	var estimate: float = _fist_speed * arm / (arm + p_mass)
	var off: float = 100.0 * absf(_crate_speed / estimate - 1.0)
	report.add(case, "fist", _fist_speed, "m/s")
	report.add(case, "crate", _crate_speed, "m/s")
	report.add(case, "estimate, limp arm", _fist_speed * limp / (limp + p_mass), "m/s")
	report.add(case, "estimate, stiff arm", estimate, "m/s")
	report.add(case, "off the stiff arm's", off, "%", BenchReport.Goal.AT_MOST, _GOAL_PERCENT)
	add_bounds(case, _world, false)
	await end_world(_world)


## A crate whose face the fist touches in the pose of the hit, on a table.
func _place_crate(p_at_hit: Array[Transform3D], p_mass: float) -> void:
	var middle: Vector3 = p_at_hit[_hand].origin
	middle.z = _person.reach(_hand, p_at_hit[_hand], Vector3.BACK) + _SIZE / 2.0
	_crate = _world.add_crate(Vector3.ONE * _SIZE, middle, p_mass)
	var table: Vector3 = Vector3(
		middle.x, middle.y - _SIZE / 2.0 - 0.5, middle.z + 2.0 - _SIZE / 2.0
	)
	_world.add_block(Vector3(2.0, 1.0, 4.0), Transform3D(Basis(), table), _FRICTION)


func _pose(p_time_s: float) -> PoseSample:
	return _fist(_share(p_time_s - _SETTLE_S))


## The fist ahead of the shoulder by a share of the arm's length.
func _fist(p_share: float) -> PoseSample:
	return ContactPoses.fist_at(_person, Vector3(0.0, 0.0, p_share * _person.arm_length("Right")))


## Even acceleration until shortly before the hit, 4 m/s, even braking. Then back as it
## came.
func _share(p_time_s: float) -> float:
	var length: float = _person.arm_length("Right")
	var even: float = _HIT - 0.05
	var gather_s: float = 2.0 * (even - _FROM) * length / _SPEED
	var strike_s: float = (_BRAKE - even) * length / _SPEED
	var brake_s: float = 2.0 * (_TO - _BRAKE) * length / _SPEED
	var turn_s: float = gather_s + strike_s + brake_s
	var time: float = clampf(p_time_s, 0.0, turn_s)
	if p_time_s > turn_s:
		time = maxf(2.0 * turn_s - p_time_s, 0.0)
	if time < gather_s:
		return _FROM + (even - _FROM) * (time / gather_s) ** 2
	time -= gather_s
	if time < strike_s:
		return even + _SPEED * time / length
	var left: float = 1.0 - (time - strike_s) / brake_s
	return _TO - (_TO - _BRAKE) * left * left


func _watch() -> bool:
	var fist: float = _person.velocity_of(_hand).z
	var crate: float = _crate.linear_velocity.z
	if _hit_s < 0.0:
		if crate < 0.02:
			_fist_speed = fist
			return false
		_hit_s = _world.time_s - _world.delta_s
	_crate_speed = crate
	return _world.time_s - _hit_s > _WINDOW_S - _world.delta_s / 2.0

extends ContactScene
## A blow with the right fist, 4 m/s fast when it hits a free crate of 10 and of 40 kg that lies
## on a slippery table, its middle at the fist's height: a jab, a swing with the straight arm, and
## the clip's own fastest blow, if it is above 3 m/s (see [FistBlow]).
##
## The crate's speed is taken 100 ms after the first contact. It is compared with the inelastic
## estimate v m / (m + M): v is the speed that the hand had in the step before the contact, M the
## crate's mass, m the mass of the whole arm, as if the muscles kept it stiff. The goal is within
## 30 % of it.

const _MASSES: Array[float] = [10.0, 40.0]
const _SIZE: float = 0.5
const _FRICTION: float = 0.02
const _WINDOW_S: float = 0.1
## A slower blow of a clip is none.
const _MIN_SPEED: float = 3.0
const _GOAL_PERCENT: float = 30.0

var _world: ContactWorld = null
var _person: ContactPerson = null
var _blow: FistBlow = null
var _crate: RigidBody3D = null
var _hand: int = 0
var _hit_s: float = -1.0
var _fist_speed: float = 0.0
var _crate_speed: float = 0.0


func play(p_performer: ContactPerformer) -> void:
	for number: int in 3:
		for mass: float in _MASSES:
			await _strike(p_performer, number, mass)


func _make_blow(p_performer: ContactPerformer, p_number: int) -> FistBlow:
	match p_number:
		0:
			return FistBlow.jab(_person)
		1:
			return FistBlow.swing(_person)
	return FistBlow.of_clip(p_performer, _person)


func _strike(p_performer: ContactPerformer, p_number: int, p_mass: float) -> void:
	_world = make_world()
	_person = p_performer.enter(_world, root)
	_hand = _person.find(&"RightHand")
	_blow = _make_blow(p_performer, p_number)
	if _blow.speed < _MIN_SPEED:
		await end_world(_world)
		return
	_world.add_person(_person, _blow.pose, _blow.place)
	var at_hit: Array[Transform3D] = _person.targets_at(_blow.hit_s)
	_place_crate(at_hit, p_mass)
	_hit_s = -1.0
	await _world.run(_blow.hit_s + 0.5, _watch)
	var case: String = name_case("%s on %d kg" % [_blow.name, int(p_mass)], p_performer)
	var arm: float = 0.0
	for part: StringName in [&"RightUpperArm", &"RightLowerArm", &"RightHand"]:
		arm += _person.mass_of(_person.find(part))
	var estimate: float = _fist_speed * arm / (arm + p_mass)
	var off: float = 100.0 * absf(_crate_speed / estimate - 1.0)
	report.add(case, "fist", _fist_speed, "m/s")
	report.add(case, "crate", _crate_speed, "m/s")
	report.add(case, "estimate, stiff arm", estimate, "m/s")
	report.at_most(case, "off the stiff arm's", off, "%", _GOAL_PERCENT)
	await end_world(_world)


## A crate whose face the fist touches in the pose of the hit, on a table.
func _place_crate(p_at_hit: Array[Transform3D], p_mass: float) -> void:
	var ahead: Vector3 = _blow.direction
	var fist: Vector3 = p_at_hit[_hand].origin
	var face: float = _person.reach(_hand, p_at_hit[_hand], ahead)
	var middle: Vector3 = fist + ahead * (face - fist.dot(ahead) + _SIZE / 2.0)
	var facing: Basis = Basis.looking_at(ahead)
	_crate = _world.add_crate(Vector3.ONE * _SIZE, middle, p_mass)
	_crate.basis = facing
	# The table begins where the crate does: arms and legs have room before it.
	var table: Vector3 = middle + ahead * (2.0 - _SIZE / 2.0) + Vector3.DOWN * (_SIZE / 2.0 + 0.5)
	_world.add_block(Vector3(2.0, 1.0, 4.0), Transform3D(facing, table), _FRICTION)


func _watch() -> bool:
	var crate: float = _crate.linear_velocity.dot(_blow.direction)
	if _hit_s < 0.0:
		if crate < 0.02:
			_fist_speed = _person.velocity_of(_hand).dot(_blow.direction)
			return false
		_hit_s = _world.time_s - _world.delta_s
	_crate_speed = crate
	return _world.time_s - _hit_s > _WINDOW_S - _world.delta_s / 2.0

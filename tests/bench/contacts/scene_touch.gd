extends ContactScene
## People who stand still and touch something: how much chest and hands tremble once they have come
## to rest.
##
## The figure is how fast the worst of chest and hands turns, RMS of [constant _MEASURE_S], in
## twenty situations that are drawn by a seed: hands on a wall, on a table, around a crate, arms
## crossed in front of the chest, two people whose arms lie around each other.

const _GOAL_DEG_S: float = 2.0
const _DRAWS: int = 4
const _SETTLE_S: float = 3.0
const _MEASURE_S: float = 3.0
const _WATCHED: Array[StringName] = [&"Chest", &"LeftHand", &"RightHand"]
const _SIDES: Array[String] = ["Left", "Right"]

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func play(p_performer: ContactPerformer) -> void:
	for kind: String in ["wall", "table", "crate", "crossed", "hug"]:
		var worst: float = 0.0
		for draw: int in _DRAWS:
			_random.seed = draw
			worst = maxf(worst, await _touch(p_performer, kind))
		report.at_most(name_case("touch " + kind, p_performer), "RMS", worst, "deg/s", _GOAL_DEG_S)


func _touch(p_performer: ContactPerformer, p_kind: String) -> float:
	var world: ContactWorld = make_world()
	world.add_floor(0.0)
	var person: ContactPerson = p_performer.enter(world, root)
	if p_kind == "hug":
		await _enter_two(world, person, p_performer)
	else:
		_enter(world, person, _crossed(person) if p_kind == "crossed" else _ahead(person))
	await world.run(0.1)
	_put_in_front(world, person, p_kind)
	await world.run(_SETTLE_S)
	var squares: PackedFloat64Array = [0.0, 0.0, 0.0]
	var steps: Array[int] = [0]
	await world.run(
		_MEASURE_S,
		func() -> bool:
			steps[0] += 1
			for i: int in _WATCHED.size():
				squares[i] += _turning(person, _WATCHED[i]).length_squared()
			return false
	)
	await end_world(world)
	return rad_to_deg(sqrt(maxf(squares[0], maxf(squares[1], squares[2])) / steps[0]))


func _enter(
	p_world: ContactWorld,
	p_person: ContactPerson,
	p_turns: Dictionary[StringName, Quaternion],
	p_at: Vector3 = Vector3.ZERO,
	p_heading: float = 0.0
) -> void:
	var pose: PoseSample = ContactPoses.reset(p_turns)
	var turn: Quaternion = Quaternion(Vector3.UP, p_heading)
	for slot: int in Limbs.COUNT:
		pose.set_orientation(slot, turn * pose.orientation(slot))
	p_world.add_standing(p_person, pose, p_at + p_person.standing_hips())


## Two who face each other.
func _enter_two(
	p_world: ContactWorld, p_person: ContactPerson, p_performer: ContactPerformer
) -> void:
	var apart: float = _random.randf_range(0.28, 0.4)
	_enter(p_world, p_person, _around(p_person))
	var other: ContactPerson = p_performer.enter(p_world, root)
	_enter(p_world, other, _around(other), Vector3(0.0, 0.0, apart), PI)


func _put_in_front(p_world: ContactWorld, p_person: ContactPerson, p_kind: String) -> void:
	var hand: int = p_person.find(&"LeftHand")
	var targets: Array[Transform3D] = p_person.targets_at(0.0)
	var tip: float = p_person.reach(hand, targets[hand], Vector3.BACK)
	var under: float = -p_person.reach(hand, targets[hand], Vector3.DOWN)
	match p_kind:
		"wall":
			var z: float = tip - _random.randf_range(0.02, 0.25) + 0.1
			p_world.add_block(Vector3(4.0, 4.0, 0.2), Transform3D(Basis(), Vector3(0.0, 2.0, z)))
		"table":
			var y: float = under + _random.randf_range(0.02, 0.12) - 0.025
			var place: Vector3 = Vector3(0.0, y, tip - 0.05)
			p_world.add_block(Vector3(2.0, 0.05, 0.5), Transform3D(Basis(), place))
		"crate":
			var at: Vector3 = Vector3(
				0.0, targets[hand].origin.y + 0.3, targets[hand].origin.z - 0.08
			)
			var size: Vector3 = Vector3(0.4, 0.3, 0.3)
			p_world.add_crate(size, at, _random.randf_range(3.0, 10.0))


## Both arms ahead.
func _ahead(p_person: ContactPerson) -> Dictionary[StringName, Quaternion]:
	var down: float = _random.randf_range(-0.5, -0.1)
	return _arms(p_person, func(_sign: float) -> Vector3: return Vector3(0.0, down, 0.8))


## Forearms crossed in front of the chest.
func _crossed(p_person: ContactPerson) -> Dictionary[StringName, Quaternion]:
	var inward: float = _random.randf_range(0.6, 0.85)
	return _arms(p_person, func(sign: float) -> Vector3: return Vector3(-sign * inward, -0.3, 0.42))


## Both arms around somebody in front.
func _around(p_person: ContactPerson) -> Dictionary[StringName, Quaternion]:
	var inward: float = _random.randf_range(0.25, 0.45)
	return _arms(p_person, func(sign: float) -> Vector3: return Vector3(-sign * inward, -0.15, 0.7))


## Hands at a place for each side, from the shoulder, in parts of the arm's length; the sign of
## the left side is 1.
func _arms(p_person: ContactPerson, p_place: Callable) -> Dictionary[StringName, Quaternion]:
	var turns: Dictionary[StringName, Quaternion] = {}
	for side: String in _SIDES:
		var sign: float = 1.0 if side == "Left" else -1.0
		var reach: Vector3 = p_place.call(sign) * p_person.arm_length(side)
		turns.merge(ContactPoses.arm(p_person, side, reach, Vector3(sign, -0.6, 0.0), Vector3.ZERO))
	return turns


func _turning(p_person: ContactPerson, p_bone: StringName) -> Vector3:
	var body: RID = p_person.ragdoll.get_bodies()[p_person.find(p_bone)]
	return PhysicsServer3D.body_get_state(body, PhysicsServer3D.BODY_STATE_ANGULAR_VELOCITY)

class_name ServerPeople
extends Node3D
## The people on the server: a ragdoll for each, driven by the samples that a client sends.

## Somebody has come; the body is in the world.
signal person_added(p_person: Person)
## Somebody is carried by an entity from now on; -1 by none.
signal person_attached(p_person: Person, p_carrier: int)

## Number of people who left and whose stats are still reported.
const _REMEMBERED: int = 16

## Old samples in a row that are worth a log line, and that mean a new clock.
const _LATE: int = 5
const _NEW_CLOCK: int = 30

## Longest stage of a sample's latency that a latency mark can hold, µs.
const _MAX_STEP_USEC: int = 655000

## The scene of a person; its root is a [Ragdoll].
@export var scene: PackedScene
## Distance between people who start where there is no free [SpawnPoint].
@export_range(0.5, 10.0, 0.1, "suffix:m") var spacing: float = 1.5

## How people's travel is found and how their hips follow.
var root_mode: RagdollMotor.RootMode = RagdollMotor.ROOT_SOFT
## The server's tick.
var tick: int = 0

var _people: Dictionary[int, Person] = {}
var _gone: Array[Dictionary] = []
var _table: EntityTable = null
var _spawn_points: Array[Vector3] = []
var _plain_type: EntityType = EntityType.person()


## One person's body.
class Person:
	var id: int = 0
	## Number of the session that sends its motion.
	var session: int = 0
	## What the client sent about the wearer.
	var card: PersonCard = PersonCard.new()
	var name: String = ""
	var ragdoll: Ragdoll = null
	var clock: SampleClock = SampleClock.new()
	## Moment of the motion that the last step ended at, s in the wearer's clock.
	var moment_s: float = 0.0
	var newest: PoseSample = null
	## Where the person's own origin is in the world, or in the carrier's frame.
	var origin: Vector3 = Vector3.ZERO
	## The body that carries the person, or null, and the person's own frame in that of the body.
	var carrier: PhysicsBody3D = null
	## Its entity, which outlives the body; -1 none.
	var carrier_id: int = -1
	var seat: Transform3D = Transform3D.IDENTITY
	## Scales the wearer's travel to the body's build.
	var scale: float = 1.0
	var refused: int = 0
	var refused_in_a_row: int = 0
	## From sampling to the end of the tick that used the sample, ms.
	var delay: Statistics = Statistics.recent()


## Sets the table of entities.
func setup(p_table: EntityTable) -> void:
	_table = p_table


## Gives a session the bodies of these people, and takes away those whom it no longer lists.
## [param p_name] is for those who have no name.
func set_people(p_session: int, p_cards: Array[PersonCard], p_name: String) -> void:
	var wanted: Dictionary[int, bool] = {}
	for card: PersonCard in p_cards:
		wanted[card.index] = true
		var person: Person = _people.get(_key(p_session, card.index))
		if person != null and not person.card.is_same_body(card):
			_remove(_key(p_session, card.index))
			person = null
		if person == null:
			_add(p_session, card, p_name)
			person = _people.get(_key(p_session, card.index))
		if person != null:
			person.card = card
			person.name = card.name if card.name != "" else p_name
	for index: int in PersonCard.MAX_PEOPLE:
		if not wanted.has(index):
			_remove(_key(p_session, index))


func _add(p_session: int, p_card: PersonCard, p_name: String) -> void:
	var person: Person = Person.new()
	person.session = p_session
	person.card = p_card
	person.ragdoll = scene.instantiate()
	person.ragdoll.root_mode = root_mode
	person.origin = _free_origin()
	if not p_card.lengths.is_empty():
		person.ragdoll.fit(p_card.lengths, p_card.hip_height)
	add_child(person.ragdoll)
	person.scale = person.ragdoll.get_hip_height() / p_card.hip_height
	if not person.ragdoll.get_limb_order().has(-1) and person.ragdoll.start():
		person.name = p_card.name if p_card.name != "" else p_name
		_people[_key(p_session, p_card.index)] = person
		_enter(person)
	else:
		Log.error("server", "'%s' gets no body: the person's scene has a fault" % p_name)
		person.ragdoll.queue_free()


## Removes all bodies of a session.
func remove(p_session: int) -> void:
	for index: int in PersonCard.MAX_PEOPLE:
		_remove(_key(p_session, index))


func _remove(p_key: int) -> void:
	if _people.has(p_key):
		_gone.push_front(_stats_of(_people[p_key]))
		_gone.resize(mini(_gone.size(), _REMEMBERED))
		_table.despawn(_people[p_key].id)
		_people[p_key].ragdoll.queue_free()
		_people.erase(p_key)


## The people, in the order in which they came.
func list() -> Array[Person]:
	return _people.values()


## Takes a sample that arrived from a session at a time, s.
func push_sample(p_session: int, p_sample: PoseSample, p_now_s: float) -> void:
	var person: Person = _people.get(_key(p_session, p_sample.person))
	if person == null:
		return
	var sample_s: float = p_sample.time_usec / 1e6
	var root: Vector3 = p_sample.root * person.scale + person.origin
	if person.ragdoll.push_sample(sample_s, p_sample, root):
		person.newest = p_sample
		person.refused_in_a_row = 0
		person.clock.arrived(sample_s, p_now_s)
		return
	person.refused += 1
	person.refused_in_a_row += 1
	if person.refused_in_a_row == _LATE:
		# A few are the network's fault, where datagrams overtake each other.
		var parts: Array = [person.name, _LATE]
		Log.limited("server", "sample %d" % person.id, "'%s' sent %d old samples in a row" % parts)
	if person.refused_in_a_row >= _NEW_CLOCK:
		# Not some late datagrams, but a wearer whose clock was set back.
		person.ragdoll.motor.clear_motion()


## Sets everybody's motors for the next step.
func drive(p_now_s: float, p_delta_s: float) -> void:
	_carry(p_delta_s)
	var motors: Array[RagdollMotor] = []
	var moments: PackedFloat64Array = []
	for person: Person in _people.values():
		if person.newest != null:
			var moment: float = person.clock.advance(p_now_s, p_delta_s)
			motors.append(person.ragdoll.motor)
			moments.append(moment)
			person.moment_s = moment + p_delta_s
	RagdollMotor.drive_all(motors, moments, p_delta_s)


## Measures how well everybody followed, after a step.
func measure() -> void:
	for person: Person in _people.values():
		if person.newest != null:
			person.ragdoll.motor.measure(person.moment_s)


## Passes on the states of bodies that [method measure] has read, so that they are read once.
func hand_poses(p_encoder: SnapshotEncoder) -> void:
	for person: Person in _people.values():
		if person.newest != null:
			p_encoder.set_body_pose(person.id, person.ragdoll.motor.get_body_pose())


## Gives an encoder the samples that moved each person in a tick that ended at a time, µs.
func mark(p_encoder: SnapshotEncoder, p_now_usec: int) -> void:
	for person: Person in _people.values():
		var newest: PoseSample = person.newest
		if newest == null or newest.sent_usec == 0:
			continue
		var steps: PackedInt32Array = [
			mini(newest.held_usec, _MAX_STEP_USEC),
			clampi(newest.arrival_usec - newest.sent_usec, 0, _MAX_STEP_USEC),
			clampi(p_now_usec - newest.arrival_usec, 0, _MAX_STEP_USEC),
		]
		person.delay.add((steps[0] + steps[1] + steps[2]) / 1000.0)
		p_encoder.set_mark(person.id, newest.id, p_now_usec, steps)


## Stats of everybody for a report: those present, then those who left last.
func stats() -> Array[Dictionary]:
	var result: Array[Dictionary] = []
	for person: Person in _people.values():
		result.append(_stats_of(person))
	return result + _gone


static func _stats_of(p_person: Person) -> Dictionary:
	var stats: Dictionary = p_person.ragdoll.motor.get_tracking()
	stats["name"] = p_person.name
	stats["refused_samples"] = p_person.refused
	stats["sample_to_tick_ms_p50"] = p_person.delay.percentile(0.5)
	stats["sample_to_tick_ms_p95"] = p_person.delay.percentile(0.95)
	return stats


static func _key(p_session: int, p_index: int) -> int:
	return p_session * PersonCard.MAX_PEOPLE + p_index


## Removes everybody from the table: the level goes.
func leave() -> void:
	for person: Person in _people.values():
		person.carrier = null
		person.carrier_id = -1
		_table.despawn(person.id)


## Puts everybody into the table and at the start points of the present level, m;
## those who come later start there too, and those without a point beside the last one.
func enter(p_points: Array[Vector3]) -> void:
	_spawn_points = p_points
	for person: Person in _people.values():
		person.origin = Vector3.INF
	for person: Person in _people.values():
		person.origin = _free_origin()
		person.ragdoll.motor.set_frame(Transform3D.IDENTITY)
		person.ragdoll.motor.clear_motion()
		_enter(person)


## Has a body carry all people of a session: their own frame is where [param p_seat] is in the
## body's, with the first one's hips above it.
func attach(p_session: int, p_entity: int, p_carrier: PhysicsBody3D, p_seat: Transform3D) -> void:
	for person: Person in _of_session(p_session):
		var at: Vector3 = person.origin
		if person.newest != null:
			at += person.newest.root * person.scale
		at.y = 0.0
		attach_person(person, p_entity, p_carrier, p_seat.translated_local(-at))


## Has a body carry one person, whose own frame is in the body's from now on.
func attach_person(
	p_person: Person, p_entity: int, p_carrier: PhysicsBody3D, p_frame: Transform3D
) -> void:
	p_person.carrier = p_carrier
	p_person.carrier_id = p_entity
	p_person.seat = p_frame
	person_attached.emit(p_person, p_entity)


## The person whose limb a node is, or null.
func find_by_limb(p_limb: Node3D) -> Person:
	for person: Person in _people.values():
		if person.ragdoll.is_ancestor_of(p_limb):
			return person
	return null


## Puts the people of a session back on their own feet, where they are.
func detach(p_session: int) -> void:
	for person: Person in _of_session(p_session):
		detach_person(person)


## Puts one person back on the ground's frame, where it is.
func detach_person(p_person: Person) -> void:
	if p_person.carrier == null:
		return
	var frame: Transform3D = p_person.carrier.global_transform * p_person.seat
	p_person.carrier = null
	p_person.carrier_id = -1
	# The frame stays turned as it is, so that getting off turns nobody.
	p_person.ragdoll.motor.set_frame(frame)
	person_attached.emit(p_person, -1)


func _enter(p_person: Person) -> void:
	var row: EntityRow = EntityRow.new()
	var node: Entity = Entity.find_in(p_person.ragdoll)
	row.type = node.type if node != null and node.type != null else _plain_type
	row.tick = tick
	row.owner = p_person.session
	row.person_index = p_person.card.index
	row.person_name = p_person.name
	row.skeleton = p_person.ragdoll.get_joints()
	if _table.spawn(row) == null:
		_people.erase(_key(p_person.session, p_person.card.index))
		p_person.ragdoll.queue_free()
		return
	p_person.id = row.id
	p_person.ragdoll.name = "Person%d" % row.id
	person_added.emit(p_person)


## Sets the frames of those who are carried, for a step of this length, s.
func _carry(p_delta_s: float) -> void:
	for person: Person in _people.values():
		if person.carrier != null and is_instance_valid(person.carrier):
			var body: PhysicsBody3D = person.carrier
			var state: PhysicsDirectBodyState3D = PhysicsServer3D.body_get_direct_state(
				body.get_rid()
			)
			var next: Transform3D = body.global_transform
			if state != null:
				next = _moved(
					state.transform, state.linear_velocity, state.angular_velocity, p_delta_s
				)
			person.ragdoll.motor.set_frame(next * person.seat)
		elif person.carrier_id >= 0:
			# What carried it was freed: its frame stays where it was last.
			person.carrier = null
			person.carrier_id = -1
			person_attached.emit(person, -1)


static func _moved(
	p_transform: Transform3D, p_velocity: Vector3, p_spin: Vector3, p_delta_s: float
) -> Transform3D:
	var moved: Transform3D = p_transform
	moved.origin += p_velocity * p_delta_s
	if not p_spin.is_zero_approx():
		moved.basis = Basis(p_spin.normalized(), p_spin.length() * p_delta_s) * moved.basis
	return moved


func _of_session(p_session: int) -> Array[Person]:
	var found: Array[Person] = []
	for person: Person in _people.values():
		if person.session == p_session:
			found.append(person)
	return found


func _free_origin() -> Vector3:
	var taken: Array = list().map(func(person: Person) -> Vector3: return person.origin)
	for point: Vector3 in _spawn_points:
		if not taken.has(point):
			return point
	var last: Vector3 = _spawn_points[-1] if not _spawn_points.is_empty() else Vector3.ZERO
	var origin: Vector3 = last
	while taken.has(origin):
		origin.x += spacing
	return origin

class_name ServerPeople
extends Node3D
## The people on the server: a ragdoll for each, driven by the samples that a client sends.

## Somebody came or went.
signal changed

## People that left and whose stats are still told.
const _REMEMBERED: int = 16

## Old samples in a row that are worth a word, and that mean a new clock.
const _LATE: int = 5
const _NEW_CLOCK: int = 30

## Longest step of a sample's way that a mark can tell, µs.
const _LONGEST_STEP_USEC: int = 655000

## Numbers of people are 16 bits on the wire.
const _MAX_IDS: int = 65536

## The scene of a person; its root is a [Ragdoll].
@export var scene: PackedScene
## Distance between the places where people start.
@export_range(0.5, 10.0, 0.1, "suffix:m") var spacing: float = 1.5

## Where people's travel comes from, and who holds them.
var root_mode: RagdollMotor.RootMode = RagdollMotor.ROOT_SOFT

var _people: Dictionary[int, Person] = {}
var _gone: Array[Dictionary] = []
var _next_id: int = 0


## One person's body.
class Person:
	var id: int = 0
	## Number of the session that sends its motion.
	var session: int = 0
	## What the client told of the wearer.
	var card: PersonCard = PersonCard.new()
	var name: String = ""
	var ragdoll: Ragdoll = null
	var clock: SampleClock = SampleClock.new()
	## Moment of the motion that the last step ended at, s in the wearer's clock.
	var moment_s: float = 0.0
	var newest: PoseSample = null
	## Where the person's own origin is in the world.
	var origin: Vector3 = Vector3.ZERO
	## Scales the wearer's travel to the body's build.
	var scale: float = 1.0
	var refused: int = 0
	var refused_in_a_row: int = 0
	## From sampling to the end of the tick that used the sample, ms.
	var delay: RecentStatistics = RecentStatistics.new()


## Gives a session the bodies of these people, and takes away those of whom it tells no more.
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
	changed.emit()


func _add(p_session: int, p_card: PersonCard, p_name: String) -> void:
	var person: Person = Person.new()
	person.id = _free_id()
	person.session = p_session
	person.card = p_card
	person.ragdoll = scene.instantiate()
	person.ragdoll.name = "Person%d" % person.id
	person.ragdoll.root_mode = root_mode
	person.origin = _free_place()
	_next_id = (person.id + 1) % _MAX_IDS
	if not p_card.lengths.is_empty():
		person.ragdoll.fit(p_card.lengths, p_card.hip_height)
	add_child(person.ragdoll)
	person.scale = person.ragdoll.get_hip_height() / p_card.hip_height
	if not person.ragdoll.get_limb_order().has(-1) and person.ragdoll.start():
		_people[_key(p_session, p_card.index)] = person
	else:
		Log.error("server", "'%s' gets no body: the person's scene has a fault" % p_name)
		person.ragdoll.queue_free()


## Takes all bodies of a session away.
func remove(p_session: int) -> void:
	for index: int in PersonCard.MAX_PEOPLE:
		_remove(_key(p_session, index))
	changed.emit()


func _remove(p_key: int) -> void:
	if _people.has(p_key):
		_gone.push_front(_figure(_people[p_key]))
		_gone.resize(mini(_gone.size(), _REMEMBERED))
		_people[p_key].ragdoll.queue_free()
		_people.erase(p_key)


## The people, in the order of their coming.
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
		# One now and then is the way's fault, which lets some overtake others.
		var parts: Array = [person.name, _LATE]
		Log.limited("server", "sample %d" % person.id, "'%s' sent %d old samples in a row" % parts)
	if person.refused_in_a_row >= _NEW_CLOCK:
		# Not some late datagrams, but a wearer whose clock was set back.
		person.ragdoll.motor.clear_motion()


## Sets everybody's motors for the next step.
func drive(p_now_s: float, p_delta_s: float) -> void:
	var motors: Array[RagdollMotor] = []
	var moments: PackedFloat64Array = []
	for person: Person in _people.values():
		if person.newest != null:
			var moment: float = person.clock.advance(p_now_s, p_delta_s)
			motors.append(person.ragdoll.motor)
			moments.append(moment)
			person.moment_s = moment + p_delta_s
	RagdollMotor.drive_all(motors, moments, p_delta_s)


## Notes how well everybody followed, after a step.
func measure() -> void:
	for person: Person in _people.values():
		if person.newest != null:
			person.ragdoll.motor.measure(person.moment_s)


## Hands over what [method measure] has read of everybody's bodies, so that they are read once.
func hand_poses(p_encoder: SnapshotEncoder) -> void:
	for person: Person in _people.values():
		if person.newest != null:
			p_encoder.set_body_pose(person.id, person.ragdoll.motor.get_body_pose())


## Tells an encoder which samples moved whom in a tick that ended at a time, µs.
func mark(p_encoder: SnapshotEncoder, p_now_usec: int) -> void:
	for person: Person in _people.values():
		var newest: PoseSample = person.newest
		if newest == null or newest.sent_usec == 0:
			continue
		var steps: PackedInt32Array = [
			mini(newest.held_usec, _LONGEST_STEP_USEC),
			clampi(newest.arrival_usec - newest.sent_usec, 0, _LONGEST_STEP_USEC),
			clampi(p_now_usec - newest.arrival_usec, 0, _LONGEST_STEP_USEC),
		]
		person.delay.add((steps[0] + steps[1] + steps[2]) / 1000.0)
		p_encoder.set_mark(person.id, newest.id, p_now_usec, steps)


## Stats of everybody for a report: who is there, then who left last.
func stats() -> Array[Dictionary]:
	var result: Array[Dictionary] = []
	for person: Person in _people.values():
		result.append(_figure(person))
	return result + _gone


static func _figure(p_person: Person) -> Dictionary:
	var figure: Dictionary = p_person.ragdoll.motor.get_tracking()
	figure["name"] = p_person.name
	figure["refused_samples"] = p_person.refused
	figure["sample_to_tick_ms_p50"] = p_person.delay.percentile(0.5)
	figure["sample_to_tick_ms_p95"] = p_person.delay.percentile(0.95)
	return figure


static func _key(p_session: int, p_index: int) -> int:
	return p_session * PersonCard.MAX_PEOPLE + p_index


## A number that no one here has, not even as far as the numbers of the bodies tell people apart.
func _free_id() -> int:
	var id: int = _next_id % _MAX_IDS
	var taken: Array = list().map(
		func(person: Person) -> int: return person.id % BodyRegistry.MAX_PEOPLE
	)
	while taken.has(id % BodyRegistry.MAX_PEOPLE):
		id = (id + 1) % _MAX_IDS
	return id


func _free_place() -> Vector3:
	var place: int = 0
	var taken: Array = list().map(func(person: Person) -> Vector3: return person.origin)
	while taken.has(Vector3(place * spacing, 0.0, 0.0)):
		place += 1
	return Vector3(place * spacing, 0.0, 0.0)

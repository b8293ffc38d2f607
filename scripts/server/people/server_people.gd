class_name ServerPeople
extends Node3D
## The people on the server: a ragdoll for each, driven by the samples that a client sends.

## Somebody has come; the body is in the world.
signal person_added(p_person: ServerPerson)
## Somebody is carried by an entity from now on; -1 by none.
signal person_attached(p_person: ServerPerson, p_carrier: int)

## Number of people who left and whose stats are still reported.
const _REMEMBERED: int = 16

## Ticks after which the bodies of a new level are in the physics space.
const _SETTLING: int = 2

## The scene of a person; its root is a [Ragdoll].
@export var scene: PackedScene
## Distance between people who start, m.
@export_range(0.5, 10.0, 0.1, "suffix:m") var spacing: float = 2.5

## How people's travel is found and how their hips follow.
var root_mode: RagdollMotor.RootMode = RagdollMotor.ROOT_SOFT
## What people are shown as who choose no avatar: the level's. Who is here already stays as he is.
var default_avatar: String = ""
## The server's tick.
var tick: int = 0
## Whose bodies are to be made and removed.
var changes: PeopleChanges = null

var _people: Dictionary[int, ServerPerson] = {}
var _gone: Array[Dictionary] = []
var _table: EntityTable = null
var _positions: StartPositions = StartPositions.new()
var _points: Array[Transform3D] = []
var _avatars: PackedStringArray = PackedStringArray()
## Ticks until the bodies of a new level are in the physics space; 0: they are.
var _settling: int = 0
## The numbers of those who belong to the server count down from here.
var _enlisted: int = 0
var _plain_type: EntityType = EntityType.person()
## What somebody needs who stands up somewhere.
var _standing_room: CapsuleShape3D = CapsuleShape3D.new()


## Sets the table of entities and the maximum of people.
func setup(p_table: EntityTable, p_max_people: int = PeopleChanges.DEFAULT_MAX) -> void:
	_table = p_table
	_positions.spacing = spacing
	_positions.set_points([])
	changes = PeopleChanges.new(scene, self, _take_start)
	changes.max_people = p_max_people
	changes.root_mode = root_mode
	changes.made.connect(_on_made)
	changes.left.connect(_remove)
	_standing_room.radius = 0.28
	_standing_room.height = 1.5


func _exit_tree() -> void:
	if changes != null:
		changes.close()
	# A person and a seat hold each other.
	for person: ServerPerson in _people.values():
		person.let_go()


## Gives a session the bodies of these people, and takes away those whom it no longer lists: as
## [method advance] comes to it. Returns how many of them there is no room for.
## [param p_name] is for those who have no name.
func set_people(p_session: int, p_cards: Array[PersonCard], p_name: String) -> int:
	for card: PersonCard in p_cards:
		if card.avatar == "":
			card.avatar = default_avatar
	var refused: int = changes.take_list(p_session, p_cards, p_name)
	for card: PersonCard in p_cards:
		var person: ServerPerson = _people.get(PeopleChanges.key_of(p_session, card.index))
		if person != null and person.card.is_same_body(card):
			person.card = card
			person.name = card.name if card.name != "" else p_name
	return refused


## Gives the server itself somebody, such as an opponent, who belongs to no client. Returns a number
## that takes the place of a session's in [method push_sample] and [method remove], or 0 where there
## is no room. The body comes as [method advance] comes to it, and counts among the most that there
## may be.
func enlist(p_card: PersonCard, p_name: String) -> int:
	p_card.index = 0
	_enlisted -= 1
	return _enlisted if set_people(_enlisted, [p_card], p_name) == 0 else 0


## Makes and removes bodies, as many as fit into a tick. Call it once a tick, before the step.
func advance() -> void:
	if _settling > 0:
		_settling -= 1
		if _settling == 0:
			# What is in the way is known only now.
			_positions.set_points(_points, get_world_3d().direct_space_state, _avatars)
			_stand_up()
	changes.advance()


## Does all at once that [method advance] would do in the next ticks.
func settle() -> void:
	changes.settle()


## Removes all bodies of a session, as [method advance] comes to it.
func remove(p_session: int) -> void:
	changes.take_list(p_session, [], "")


func _take_start(p_key: int, p_avatar: String) -> Transform3D:
	var space: PhysicsDirectSpaceState3D = get_world_3d().direct_space_state
	return _positions.take(p_key, space, p_avatar)


func _on_made(
	p_key: int, p_wanted: PeopleChanges.Wanted, p_ragdoll: Ragdoll, p_joints: PersonSkeleton
) -> void:
	var person: ServerPerson = ServerPerson.new()
	person.session = p_wanted.session
	person.card = p_wanted.card
	person.name = p_wanted.name
	person.ragdoll = p_ragdoll
	person.entity = Entity.find_in(p_ragdoll)
	person.scale = p_ragdoll.get_hip_height() / p_wanted.card.hip_height
	person.joints = p_joints
	_people[p_key] = person
	person.stand_at(p_ragdoll.transform)
	_enter(person)


func _remove(p_key: int) -> void:
	var person: ServerPerson = _people.get(p_key)
	if person == null:
		return
	_gone.push_front(person.stats())
	_gone.resize(mini(_gone.size(), _REMEMBERED))
	_table.despawn(person.id)
	# Before its limbs leave the areas that carry people.
	person.let_go()
	_people.erase(p_key)
	_positions.release(p_key)
	changes.discard(person.ragdoll)


## The people, in the order in which they came.
func list() -> Array[ServerPerson]:
	return _people.values()


## Takes a sample of one of a session's people, or of somebody who was enlisted, that arrived at a
## time, s.
func push_sample(p_session: int, p_sample: PoseSample, p_now_s: float) -> void:
	var person: ServerPerson = _people.get(PeopleChanges.key_of(p_session, p_sample.person))
	if person != null:
		person.push_sample(p_sample, p_now_s)


## Sets everybody's motors for the next step.
func drive(p_now_s: float, p_delta_s: float) -> void:
	_carry(p_delta_s)
	var motors: Array[RagdollMotor] = []
	var moments: PackedFloat64Array = []
	for person: ServerPerson in _people.values():
		if person.newest != null:
			var moment: float = person.clock.advance(p_now_s, p_delta_s)
			motors.append(person.ragdoll.motor)
			moments.append(moment)
			person.moment_s = moment + p_delta_s
	RagdollMotor.drive_all(motors, moments, p_delta_s)


## Measures how well everybody followed, after a step.
func measure() -> void:
	for person: ServerPerson in _people.values():
		if person.newest != null:
			person.ragdoll.motor.measure(person.moment_s)


## Passes on the states of bodies that [method measure] has read, so that they are read once.
func hand_poses(p_encoder: SnapshotEncoder) -> void:
	for person: ServerPerson in _people.values():
		if person.newest != null:
			p_encoder.set_body_pose(person.id, person.ragdoll.motor.get_body_pose())


## Gives an encoder the samples that moved each person in a tick that ended at a time, µs.
func mark(p_encoder: SnapshotEncoder, p_now_usec: int) -> void:
	for person: ServerPerson in _people.values():
		person.mark(p_encoder, p_now_usec)


## Stats of everybody for a report: those present, then those who left last.
func stats() -> Array[Dictionary]:
	var result: Array[Dictionary] = []
	for person: ServerPerson in _people.values():
		result.append(person.stats())
	return result + _gone


## Removes everybody from the table: the level goes.
func leave() -> void:
	for person: ServerPerson in _people.values():
		person.let_go()
		_table.despawn(person.id)


## Puts everybody into the table and at the start points of the present level, m, facing their +Z;
## those who come later start there too.
func enter(p_points: Array[Transform3D], p_avatars: PackedStringArray = []) -> void:
	_points = p_points
	_avatars = p_avatars
	_settling = _SETTLING
	_positions.set_points(p_points, null, p_avatars)
	for person: ServerPerson in _people.values():
		_enter(person)
	_stand_up()


## Puts everybody who is here at start positions.
func _stand_up() -> void:
	for key: int in _people:
		if _people[key].carrier == null:
			var avatar: String = AvatarStore.resolve(_people[key].card.avatar)
			_people[key].stand_at(_take_start(key, avatar))
			person_attached.emit(_people[key], -1)


## Has a seat of an entity carry the people of a session: the first of them, if the seat holds
## bodies, or all.
func attach(p_session: int, p_entity: int, p_carrier: PhysicsBody3D, p_seat: Seat) -> void:
	for person: ServerPerson in _of_session(p_session):
		# Some sit already when others of the session come; some are still on the way out.
		var sits: bool = person.sitting != null and person.sitting.seat == p_seat
		if not sits or person.sitting.phase >= PersonSeat.Phase.LEAVING:
			_seat(person, p_entity, p_carrier, p_seat)
		if person.sitting.hold != null:
			break


## Has a body carry one person, whose own frame is in the body's from now on. With
## [param p_rides] it does not: friction alone carries who stands or lies there.
func attach_person(
	p_person: ServerPerson,
	p_entity: int,
	p_carrier: PhysicsBody3D,
	p_frame: Transform3D,
	p_rides: bool = false
) -> void:
	p_person.rides = p_rides
	p_person.carrier = p_carrier
	p_person.carrier_id = p_entity
	p_person.seat = p_frame
	person_attached.emit(p_person, p_entity)


## The person whose limb a node is, or null.
func find_by_limb(p_limb: Node3D) -> ServerPerson:
	for person: ServerPerson in _people.values():
		if person.ragdoll.is_ancestor_of(p_limb):
			return person
	return null


## Puts the people of a session back on their own feet: where they are, or where a seat's way out
## leads.
func detach(p_session: int) -> void:
	for person: ServerPerson in _of_session(p_session):
		var sits: bool = person.sitting != null and is_instance_valid(person.carrier)
		if person.carrier == null or person.rides:
			continue
		if not sits or not person.sitting.leave(_is_free.bind(person.carrier)):
			detach_person(person)


## Puts one person back on the ground's frame, where it is.
func detach_person(p_person: ServerPerson) -> void:
	if p_person.carrier == null:
		return
	var motor: RagdollMotor = p_person.ragdoll.motor
	var frame: Transform3D = motor.get_frame()
	if not p_person.rides and p_person.sitting == null:
		frame = p_person.carrier.global_transform * p_person.seat
	elif p_person.sitting != null and p_person.sitting.hold != null:
		frame = _upright(p_person, frame)
		motor.clear_motion()
	var was_moved: bool = not p_person.rides
	p_person.let_go()
	# The frame stays turned as it is, so that getting off turns nobody.
	if was_moved:
		motor.set_frame(frame)
	person_attached.emit(p_person, -1)


func _seat(p_person: ServerPerson, p_entity: int, p_carrier: PhysicsBody3D, p_seat: Seat) -> void:
	var is_inside: bool = p_person.sitting != null and p_person.carrier == p_carrier
	p_person.let_go()
	p_person.sitting = PersonSeat.new(p_person, p_seat, p_carrier, is_inside)
	attach_person(p_person, p_entity, p_carrier, Transform3D.IDENTITY)


## A frame as it is on the ground: upright, and so that the hips stay where the motion has them.
func _upright(p_person: ServerPerson, p_frame: Transform3D) -> Transform3D:
	var root: Vector3 = p_person.origin
	if p_person.newest != null:
		root += p_person.newest.root * p_person.scale
	# In a seat the own frame's origin is below the hips.
	var feet: Vector3 = p_frame.origin
	var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		feet + Vector3.UP, feet + Vector3.DOWN * 2.0, PhysicsLayers.STATIC | PhysicsLayers.PROPS
	)
	var hit: Dictionary = get_world_3d().direct_space_state.intersect_ray(ray)
	if not hit.is_empty():
		feet.y = (hit["position"] as Vector3).y
	var turn: Basis = Basis(Vector3.UP, p_frame.basis.get_euler().y)
	return Transform3D(turn, feet - turn * Vector3(root.x, p_person.origin.y, root.z))


## Whether somebody could stand at a place in a body's frame: there is ground, and nothing above it.
func _is_free(p_place: Vector3, p_body: PhysicsBody3D) -> bool:
	var space: PhysicsDirectSpaceState3D = get_world_3d().direct_space_state
	var at: Vector3 = p_body.global_transform * p_place
	var mask: int = PhysicsLayers.STATIC | PhysicsLayers.PROPS
	var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		at + Vector3.UP, at + Vector3.DOWN * 2.0, mask, [p_body.get_rid()]
	)
	var hit: Dictionary = space.intersect_ray(ray)
	if hit.is_empty():
		return false
	var query: PhysicsShapeQueryParameters3D = PhysicsShapeQueryParameters3D.new()
	query.shape = _standing_room
	query.collision_mask = mask
	query.exclude = [p_body.get_rid()]
	var feet: Vector3 = hit["position"]
	query.transform = Transform3D(Basis.IDENTITY, feet + Vector3.UP * 1.15)
	return space.intersect_shape(query, 1).is_empty()


func _enter(p_person: ServerPerson) -> void:
	var row: EntityRow = EntityRow.new()
	var node: Entity = p_person.entity
	row.type = node.type if node != null and node.type != null else _plain_type
	row.tick = tick
	row.owner = maxi(p_person.session, 0)
	row.person_index = p_person.card.index
	row.person_name = p_person.name
	row.path = AvatarStore.resolve(p_person.card.avatar)
	row.skeleton = p_person.joints
	if _table.spawn(row) == null:
		_people.erase(PeopleChanges.key_of(p_person.session, p_person.card.index))
		changes.discard(p_person.ragdoll)
		return
	p_person.id = row.id
	p_person.ragdoll.name = "Person%d" % row.id
	person_added.emit(p_person)


## Sets the frames of those who are carried, for a step of this length, s.
func _carry(p_delta_s: float) -> void:
	for person: ServerPerson in _people.values():
		if person.carrier != null and is_instance_valid(person.carrier):
			person.follow_carrier(p_delta_s)
			if person.sitting != null and person.sitting.phase == PersonSeat.Phase.GONE:
				detach_person(person)
		elif person.carrier_id >= 0:
			# What carried it was freed: its frame stays where it was last.
			person.let_go()
			person_attached.emit(person, -1)


func _of_session(p_session: int) -> Array[ServerPerson]:
	var found: Array[ServerPerson] = []
	for person: ServerPerson in _people.values():
		if person.session == p_session:
			found.append(person)
	return found

extends TestCase
## The people on the server: coming, going, samples and what is told of them.

const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")
const Stage: GDScript = preload("res://tests/actor/ragdoll/stage.gd")
const SOLDIER: PackedScene = preload("res://scenes/actor/soldier.tscn")
const STEP_USEC: int = 16667

var _actors: ServerPeople = null
var _changes: int = 0
var _table: EntityTable = null
var _now_s: float = 1000.0
var _sent: int = 0


func before_each() -> void:
	_actors = ServerPeople.new()
	_actors.scene = SOLDIER
	_table = EntityTable.new()
	_actors.setup(_table)
	_table.spawned.connect(_on_changed)
	_table.despawned.connect(_on_changed)
	add_child(_actors)
	_changes = 0


func after_each() -> void:
	_actors.free()


func test_come_and_go() -> void:
	_add(7, "Ada", 0.95)
	_add(9, "Bob", 0.95)
	equal(_changes, 2)
	equal(_actors.list().map(_name), ["Ada", "Bob"])
	equal([_table.person_of(7).person_name, _table.person_of(9).id], ["Ada", _actors.list()[1].id])
	_remove(7)
	equal(_actors.list().map(_name), ["Bob"])
	equal(_changes, 3)
	await process_frames(2)
	equal(_actors.get_child_count(), 1, "bodies")


func test_everybody_starts_at_a_place_of_his_own() -> void:
	for peer: int in 4:
		_add(peer, "n%d" % peer, 0.95)
	_remove(1)
	_add(8, "late", 0.95)
	var places: Array = _actors.list().map(
		func(person: ServerPerson) -> Vector3: return person.origin
	)
	for i: int in places.size():
		for j: int in i:
			is_true((places[i] as Vector3).distance_to(places[j]) >= 2.499)


func test_the_travel_of_tall_wearers_is_scaled() -> void:
	_add(7, "tall", 1.2)
	var person: ServerPerson = _actors.list()[0]
	almost_equal(person.scale, person.ragdoll.get_hip_height() / 1.2, 1e-6)


func test_a_body_gets_the_size_of_its_wearer() -> void:
	_add(7, "plain", 0.95)
	var plain: Ragdoll = _actors.list()[0].ragdoll
	var card: PersonCard = PersonCard.of("small", plain.get_hip_height() * 0.8)
	for length: float in BodyScale.own_lengths(plain):
		card.lengths.append(length * 0.8)
	_put(8, [card], "")
	var person: ServerPerson = _actors.list()[1]
	almost_equal(person.scale, 1.0, 0.005)
	almost_equal(person.ragdoll.get_hip_height(), plain.get_hip_height() * 0.8, 0.005)
	is_true(person.ragdoll.profile.mass < 0.7 * plain.profile.mass)
	# Who grows gets another body.
	var taller: PersonCard = PersonCard.of("small", card.hip_height)
	taller.lengths = card.lengths.duplicate()
	taller.lengths[10] *= 1.3
	_put(8, [taller], "")
	var grown: ServerPerson = _actors.list()[1]
	not_equal(grown.id, person.id)
	is_true(grown.ragdoll.get_hip_height() > person.ragdoll.get_hip_height() + 0.05)


func test_samples_move_the_body() -> void:
	_add(7, "Ada", 1.0115)
	for _step: int in 60:
		await _step(7, Stage.arms_pose(80.0, 80.0), Vector3(0.0, 1.0115, 0.5))
	var person: ServerPerson = _actors.list()[0]
	var hips: Transform3D = PhysicsServer3D.body_get_state(
		person.ragdoll.get_bodies()[0], PhysicsServer3D.BODY_STATE_TRANSFORM
	)
	almost_equal(hips.origin, person.origin + Vector3(0.0, 1.02, 0.51), 0.05)
	equal(person.newest.id, _sent)


func test_marks_tell_when_the_newest_sample_was_where() -> void:
	_add(7, "Ada", 1.0115)
	equal(_mark_of(2000000), {}, "nothing has come yet")
	await _step(7, Stage.reset_pose(), Vector3.UP)
	equal(_mark_of(2000000), {}, "nobody knows when it was sent")
	var newest: PoseSample = _actors.list()[0].newest
	newest.held_usec = 2000
	newest.sent_usec = 1990000
	newest.arrival_usec = 1993000
	var mark: Dictionary = _mark_of(2000000)
	equal([mark["person"], mark["sample"]], [_actors.list()[0].id, newest.id])
	equal(mark["simulated_usec"], 2000000)
	equal(mark["steps_usec"], PackedInt32Array([2000, 3000, 7000, 500]))


func test_samples_of_strangers_are_ignored() -> void:
	_actors.push_sample(99, Stage.reset_pose(), 1.0)
	_remove(99)
	equal(_actors.list().size(), 0)


func test_old_samples_are_refused_and_counted() -> void:
	_add(7, "Ada", 0.95)
	await _step(7, Stage.reset_pose(), Vector3.UP)
	var old: PoseSample = Stage.reset_pose()
	old.time_usec = 5
	_actors.push_sample(7, old, _now_s)
	equal(_actors.stats()[0]["refused_samples"], 1)
	not_equal(_actors.list()[0].newest, old)


func test_stats_of_grounded_people_tell_force_and_tether() -> void:
	_add(7, "Ada", 0.95)
	await _step(7, Stage.reset_pose(), Vector3.UP)
	equal(_actors.stats()[0]["tether_m"], 0.0)
	is_false(_actors.stats()[0].has("residual_n"), "a soft root has none")
	_actors.list()[0].ragdoll.motor.root_mode = RagdollMotor.ROOT_GROUNDED
	await _step(7, Stage.reset_pose(), Vector3.UP)
	var row: Dictionary = _actors.stats()[0]
	is_true(row["residual_n"] <= row["residual_limit_n"] + 0.01, "%s" % row)
	is_true(row["residual_nm"] >= 0.0 and row["residual_p95_nm"] > 0.0, "%s" % row)
	is_true(row["tether_m"] >= 0.0 and row["tether_m"] < 1.0, "%s" % row)


func test_a_wearers_new_clock_is_followed_soon() -> void:
	_add(7, "Ada", 1.0115)
	for _step_number: int in 20:
		await _step(7, Stage.reset_pose(), Vector3.UP)
	_sent = -1000000
	for _step_number: int in 60:
		await _step(7, Stage.reset_pose(), Vector3.UP)
	equal(_actors.list()[0].newest.id, _sent)


func test_stats_also_of_who_left() -> void:
	_add(7, "Ada", 0.95)
	_add(9, "Bob", 0.95)
	_remove(7)
	var names: Array = _actors.stats().map(func(row: Dictionary) -> String: return row["name"])
	equal(names, ["Bob", "Ada"])
	for peer: int in 40:
		_add(100 + peer, "n", 0.95)
		_remove(100 + peer)
	is_true(_actors.stats().size() <= 20, "memory is bounded")


## A sample, and a step of the simulation.
func _step(p_peer: int, p_pose: PoseSample, p_root: Vector3) -> void:
	await get_tree().physics_frame
	_push(p_peer, p_pose, p_root)
	_sent += 1
	_now_s += 1.0 / 60.0
	_actors.drive(_now_s, 1.0 / 60.0)
	_actors.measure()


## The mark that a client gets of a tick that ended at a time, µs.
func _mark_of(p_now_usec: int) -> Dictionary:
	var encoder: SnapshotEncoder = SnapshotEncoder.new()
	var decoder: SnapshotDecoder = SnapshotDecoder.new()
	var parents: PackedInt32Array = PackedInt32Array(Limbs.PARENTS)
	encoder.configure(parents, Protocol.POSE_ERROR_DEG, 60)
	decoder.configure(parents, Protocol.POSE_ERROR_DEG)
	encoder.add_client(1, 0, 1e6)
	encoder.begin_tick(100)
	var pose: PoseSample = Stage.reset_pose()
	encoder.put_person(_actors.list()[0].id, Vector3.UP, pose.orientations)
	encoder.end_tick()
	_actors.mark(encoder, p_now_usec)
	decoder.decode(encoder.encode(1, p_now_usec + 500)[0])
	return decoder.get_mark()


func _on_changed(_row: EntityRow) -> void:
	_changes += 1


func _name(p_person: ServerPerson) -> String:
	return p_person.name


func test_a_client_may_have_several_people() -> void:
	var ada: PersonCard = PersonCard.of("Ada", 0.95)
	var bob: PersonCard = PersonCard.of("", 1.0, 3)
	_put(7, [ada, bob], "client")
	_add(9, "Eve", 0.9)
	equal(_actors.list().map(_name), ["Ada", "client", "Eve"])
	var first: ServerPerson = _actors.list()[0]
	_put(7, [ada, bob], "client")
	is_true(_actors.list()[0] == first, "told again, the bodies stay")
	_put(7, [bob], "client")
	equal(_actors.list().map(_name), ["client", "Eve"])
	_put(7, [PersonCard.of("", 1.1, 3)], "client")
	almost_equal(_actors.list()[1].card.hip_height, 1.1, 1e-6, "another size, another body")
	_remove(7)
	equal(_actors.list().map(_name), ["Eve"])


func test_samples_move_the_person_that_they_are_of() -> void:
	_put(7, [PersonCard.of("Ada", 0.95), PersonCard.of("Bob", 0.95, 1)], "")
	var sample: PoseSample = Stage.reset_pose()
	sample.person = 1
	_actors.push_sample(7, sample, _now_s)
	is_null(_actors.list()[0].newest)
	is_true(_actors.list()[1].newest == sample)


func _add(p_session: int, p_name: String, p_hip_height: float) -> void:
	_put(p_session, [PersonCard.of(p_name, p_hip_height)], p_name)


## Somebody's people, and their bodies at once.
func _put(p_session: int, p_cards: Array[PersonCard], p_name: String) -> void:
	_actors.set_people(p_session, p_cards, p_name)
	_actors.settle()


func _remove(p_session: int) -> void:
	_actors.remove(p_session)
	_actors.settle()


func test_people_start_at_the_points_of_the_level() -> void:
	_actors.enter([_at(Vector3(5.0, 0.0, 0.0)), _at(Vector3(0.0, 0.0, 7.0))])
	for session: int in 3:
		_add(session, "n%d" % session, 0.95)
	var origins: Array = _actors.list().map(
		func(person: ServerPerson) -> Vector3: return person.origin
	)
	equal(origins.slice(0, 2), [Vector3(5.0, 0.0, 0.0), Vector3(0.0, 0.0, 7.0)])
	almost_equal(origins[2], Vector3(5.0 + _actors.spacing, 0.0, 0.0), 1e-5)


func test_people_face_as_their_point_does() -> void:
	var points: Array[Transform3D] = [
		Transform3D(Basis(Vector3.UP, PI / 2.0), Vector3(5.0, 0.0, 1.0)),
	]
	_actors.enter(points)
	_add(7, "Ada", 1.0115)
	for _round: int in 2:
		var hips: PhysicsBody3D = _actors.list()[0].ragdoll.get_limb_nodes()[Limbs.ROOT]
		var reset: Quaternion = _actors.list()[0].joints.reset_orientations[Limbs.ROOT]
		for step: int in 30:
			# A step ahead, of the wearer's.
			await _step(7, Stage.reset_pose(), Vector3(0.0, 1.0115, 0.5))
			var at: Transform3D = PhysicsServer3D.body_get_state(
				hips.get_rid(), PhysicsServer3D.BODY_STATE_TRANSFORM
			)
			var off: Quaternion = at.basis.get_rotation_quaternion() * reset.inverse()
			if step > 1:
				almost_equal(off.get_euler().y, points[0].basis.get_euler().y, 0.03, "%d" % step)
				var wanted: Vector3 = points[0] * Vector3(0.0, 0.0, 0.5)
				almost_equal(Vector3(at.origin.x, 0.0, at.origin.z), wanted, 0.12, "%d" % step)
		# Another level turns everybody at once.
		_actors.leave()
		points[0] = Transform3D(Basis(Vector3.UP, -2.0), Vector3(-3.0, 0.0, 0.0))
		_actors.enter(points)
		await _step(7, Stage.reset_pose(), Vector3(0.0, 1.0115, 0.5))


func test_people_stay_when_the_level_changes() -> void:
	_add(7, "Ada", 0.95)
	var before: int = _actors.list()[0].id
	_actors.leave()
	is_null(_table.find(before))
	_actors.enter([_at(Vector3(0.0, 0.0, 3.0))])
	equal(_actors.list()[0].origin, Vector3(0.0, 0.0, 3.0))
	equal(_table.person_of(7).id, _actors.list()[0].id)


static func _at(p_position: Vector3) -> Transform3D:
	return Transform3D(Basis.IDENTITY, p_position)


func test_who_is_carried_moves_with_the_carrier() -> void:
	_add(7, "Ada", 1.0115)
	var person: ServerPerson = _actors.list()[0]
	for _step: int in 30:
		await _step(7, Stage.reset_pose(), Vector3(0.0, 1.0115, 0.0))
	var carrier: AnimatableBody3D = AnimatableBody3D.new()
	carrier.sync_to_physics = false
	add_child(carrier)
	await get_tree().physics_frame
	_actors.attach_person(person, 1024, carrier, person.ragdoll.motor.get_frame())
	for _step: int in 60:
		carrier.rotate_y(0.5 / 60.0)
		carrier.position.x += 1.0 / 60.0
		await _step(7, Stage.reset_pose(), Vector3(0.0, 1.0115, 0.0))
	var hips: Transform3D = PhysicsServer3D.body_get_state(
		person.ragdoll.get_bodies()[0], PhysicsServer3D.BODY_STATE_TRANSFORM
	)
	var expected: Vector3 = carrier.transform * (person.origin + Vector3(0.0, 1.02, 0.01))
	almost_equal(hips.origin, expected, 0.06)
	is_true(person.ragdoll.motor.get_tracking()["p95_deg"] < 6.0)
	_actors.detach_person(person)
	is_null(person.carrier)
	carrier.free()


func test_four_with_outstretched_arms_do_not_push_each_other() -> void:
	var alone: Array[Quaternion] = await _stand(1)
	var together: Array[Quaternion] = await _stand(4)
	equal(together.size(), 4 * Limbs.COUNT)
	for limb: int in together.size():
		var turn: float = together[limb].angle_to(alone[limb % Limbs.COUNT])
		is_true(rad_to_deg(turn) < 0.5, "%.2f deg, limb %d" % [rad_to_deg(turn), limb])


## How so many people's limbs are turned who have stood side by side for a while.
func _stand(p_count: int) -> Array[Quaternion]:
	for session: int in p_count:
		_add(session, "n%d" % session, 1.0115)
	for _step_number: int in 90:
		for session: int in range(1, p_count):
			_push(session, Stage.reset_pose(), Vector3(0.0, 1.0115, 0.0))
		await _step(0, Stage.reset_pose(), Vector3(0.0, 1.0115, 0.0))
	var turns: Array[Quaternion] = []
	for person: ServerPerson in _actors.list():
		for body: RID in person.ragdoll.get_bodies():
			var state: Transform3D = PhysicsServer3D.body_get_state(
				body, PhysicsServer3D.BODY_STATE_TRANSFORM
			)
			turns.append(state.basis.get_rotation_quaternion())
	for session: int in p_count:
		_remove(session)
	return turns


## A sample for the next step.
func _push(p_peer: int, p_pose: PoseSample, p_root: Vector3) -> void:
	p_pose.id = _sent + 1
	p_pose.time_usec = 1780000000000000 + (_sent + 1) * STEP_USEC
	p_pose.root = p_root
	_actors.push_sample(p_peer, p_pose, _now_s + 1.0 / 60.0)

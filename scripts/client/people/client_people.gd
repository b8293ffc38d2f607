class_name ClientPeople
extends RefCounted
## The people whose motion a client sends: they come and go with their sources (thesis section 6.1).

## The list of people has changed.
signal changed

## Age from which on a motion is no longer published, s.
const _STALE_S: float = 0.5
## Period of checking sizes, s, and the difference that is sent anew, m: some sources know a size
## only after a while.
const _SIZE_PERIOD_S: float = 1.0
const _SIZE_STEP_M: float = 0.01

## Number of the first person whose body is shown as the wearer's own, or -1.
var first_actor: int = -1
## Sends poses to other programs by the VMC protocol, or null.
var vmc_out: VmcOut = null

var _link: ClientLink = null
var _rate: float = 60.0
var _avatar: String = ""
var _sender: MotionSender = MotionSender.new()
var _motions: Array[ClientMotion] = []
var _sizes_due_s: float = 0.0
var _publishers: Dictionary[ClientMotion, TrackerPublisher] = {}


func _init(p_link: ClientLink, p_options: Options) -> void:
	_link = p_link
	_rate = p_options.number("rate")
	_avatar = p_options.text("avatar")
	_sender.start(_rate, _link)


## Begins to send somebody's motion. Returns false where there are too many already.
func add(p_source: MotionSource, p_name: String) -> bool:
	var index: int = 0
	while _motions.any(func(other: ClientMotion) -> bool: return other.card.index == index):
		index += 1
	if index >= PersonCard.MAX_PEOPLE:
		Log.warning("mocap", "%s is one too many: %d is the most" % [p_name, PersonCard.MAX_PEOPLE])
		return false
	var motion: ClientMotion = ClientMotion.new()
	motion.card.name = p_name
	motion.card.avatar = _avatar
	motion.start(p_source, _sender, _link, index)
	_motions.append(motion)
	_publish_anew(motion)
	_declare()
	return true


## Ends somebody's motion.
func remove(p_source: MotionSource) -> void:
	for motion: ClientMotion in _motions:
		if motion.source == p_source:
			_end(motion)
			_motions.erase(motion)
			_declare()
			return


## Sends the server the card of somebody whose size has changed.
func measure(p_source: MotionSource) -> void:
	for motion: ClientMotion in _motions:
		if motion.source == p_source:
			motion.card.take_size(p_source.get_hip_height(), p_source.get_limb_lengths())
			_publish_anew(motion)
			_declare()


## Takes what was sampled, and publishes it for avatars of this machine. Call it in every frame.
func take_samples() -> void:
	for motion: ClientMotion in _motions:
		var before: PoseSample = motion.newest
		motion.take_samples()
		if motion.newest != before:
			_publishers[motion].publish(motion.newest)
			if vmc_out != null:
				vmc_out.send(motion.card.index, motion.newest, motion.source)
		elif motion.newest != null and _age_s(motion.newest) > _STALE_S:
			_publishers[motion].pause()
	var now: float = Time.get_ticks_usec() / 1e6
	if now >= _sizes_due_s:
		_sizes_due_s = now + _SIZE_PERIOD_S
		_look_at_sizes()


## Samples those whose motion needs the physics world. Call it in every physics frame.
func sample_in_world() -> void:
	_sender.sample_in_world()


## How many there are.
func count() -> int:
	return _motions.size()


## The source of one of them, by its number, or null.
func source_of(p_index: int) -> MotionSource:
	for motion: ClientMotion in _motions:
		if motion.card.index == p_index:
			return motion.source
	return null


## The server has admitted us: sends it the cards of our people.
func begin() -> void:
	for motion: ClientMotion in _motions:
		motion.disembody()
	first_actor = -1
	_sender.restart()
	_declare()


## Finds the bodies that the server has given them, of which some are shown already.
func embody(p_replica: WorldReplica, p_shown: Dictionary[int, ActorView]) -> void:
	for motion: ClientMotion in _motions:
		var row: EntityRow = p_replica.table.person_of(_link.session, motion.card.index)
		if row != null and row.id != motion.actor and row.skeleton.is_sound():
			var hips: float = p_shown[row.id].node.get_hip_height() if p_shown.has(row.id) else 0.0
			motion.embody(row.id, row.skeleton, hips, _rate)
		if motion.card.index == 0:
			first_actor = motion.actor


## All of them, by their numbers. They may be read but not changed.
func motions() -> Array[ClientMotion]:
	return _motions


## Shows everybody as an avatar from now on; an empty text is the world's.
func wear(p_avatar: String) -> void:
	_avatar = p_avatar
	for motion: ClientMotion in _motions:
		motion.card.avatar = p_avatar
	_declare()


## The avatar that is worn; an empty text is the world's.
func avatar() -> String:
	return _avatar


## Sends an acknowledgement of snapshots, together with samples.
func send_ack(p_bytes: PackedByteArray) -> void:
	_sender.send_ack(p_bytes)


## Records how long a sample took to the server.
func note_trip(p_mark: LatencyMark) -> void:
	for motion: ClientMotion in _motions:
		if motion.actor == p_mark.person:
			motion.note_trip(p_mark)


## Keeps the samples in step with the server's ticks, and says where the own bodies are at a local
## time, µs: seven floats a limb, by person.
func evaluate(p_now_usec: int, p_replica: WorldReplica) -> Dictionary[int, PackedFloat32Array]:
	var bodies: Dictionary[int, PackedFloat32Array] = {}
	for motion: ClientMotion in _motions:
		motion.keep_in_step()
		var truth: PackedFloat32Array = []
		var heading: float = NAN
		if motion.actor >= 0 and p_replica.has_person(motion.actor):
			heading = p_replica.ground_heading(motion.actor)
			motion.turn(heading)
			truth = p_replica.person_floats(motion.actor, true)
		var floats: PackedFloat32Array = motion.evaluate(p_now_usec, truth, p_replica.newest_tick)
		if not floats.is_empty() and not is_nan(heading):
			bodies[motion.actor] = floats
	return bodies


## Transform of the first person's own frame, for the shown body (see [method evaluate]); null while
## it is not known.
func find_wearer(
	p_replica: WorldReplica, p_own: Dictionary[int, PackedFloat32Array]
) -> WearerTransform:
	if first_actor < 0 or not p_replica.has_person(first_actor):
		return null
	var floats: PackedFloat32Array = p_own.get(first_actor, PackedFloat32Array())
	if floats.is_empty():
		floats = p_replica.person_floats(first_actor)
	for motion: ClientMotion in _motions:
		if motion.actor == first_actor and motion.newest != null:
			var place: WearerTransform = WearerTransform.new()
			place.actor = first_actor
			place.carrier = p_replica.decoder.get_frame(first_actor)
			if place.carrier >= 0 and p_replica.has_body(place.carrier):
				place.carrier_frame = p_replica.body_transform(place.carrier)
			var heading: float = p_replica.ground_heading(first_actor)
			place.frame = motion.frame_in_world(floats, heading)
			_carry(place, motion.source)
			return place
	return null


## Which moment of the first one's motion is shown at a local time: µs of Unix time.
func shown_moment_usec(p_now_usec: int) -> int:
	return _motions[0].shown_moment_usec(p_now_usec) if not _motions.is_empty() else 0


## Stats for a report, by name.
func stats() -> Array[Dictionary]:
	var result: Array[Dictionary] = []
	for motion: ClientMotion in _motions:
		var row: Dictionary = motion.stats()
		row["name"] = motion.card.name
		row["source"] = motion.source.describe()
		result.append(row)
	return result


## Ends all.
func stop() -> void:
	for motion: ClientMotion in _motions:
		_end(motion)
	_motions.clear()
	_sender.stop()


## Where a stick has carried who walks by it.
static func _carry(r_place: WearerTransform, p_source: MotionSource) -> void:
	var legs: WalkedLegs = p_source as WalkedLegs
	var walker: WalkerSource = p_source as WalkerSource
	if legs != null:
		r_place.travel = legs.travel()
		r_place.velocity = legs.velocity()
	elif walker != null and walker.find_room.is_valid():
		walker.find_room.call(r_place)


func _look_at_sizes() -> void:
	for motion: ClientMotion in _motions:
		var fresh: PersonCard = PersonCard.new()
		fresh.take_size(motion.source.get_hip_height(), motion.source.get_limb_lengths())
		if fresh.is_resized(motion.card, _SIZE_STEP_M):
			measure(motion.source)


func _publish_anew(p_motion: ClientMotion) -> void:
	if vmc_out != null:
		vmc_out.forget(p_motion.card.index)
	if _publishers.has(p_motion):
		_publishers[p_motion].retire()
	var tracker: StringName = TrackerPublisher.name_for(p_motion.card.index)
	var size: BodySize = p_motion.source.get_body()
	_publishers[p_motion] = TrackerPublisher.new(size, tracker, p_motion.card.name)


func _end(p_motion: ClientMotion) -> void:
	p_motion.stop()
	_publishers[p_motion].retire()
	_publishers.erase(p_motion)


static func _age_s(p_sample: PoseSample) -> float:
	return Time.get_unix_time_from_system() - p_sample.time_usec / 1e6


func _declare() -> void:
	var cards: Array[PersonCard] = []
	for motion: ClientMotion in _motions:
		cards.append(motion.card)
	_sender.set_sending(_link.is_joined())
	_link.declare_people(cards)
	changed.emit()

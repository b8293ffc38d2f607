class_name WorldReplica
extends RefCounted
## A client's copy of the server's world: takes in what a [StateStream] brings, and knows where
## everything is, which values fields have, and which events are due, at the moment that is shown.

## The server has a level of this name and fingerprint: all entities of the last one are gone.
signal level_named(p_name: String, p_fingerprint: PackedByteArray)
## A snapshot with this mark has come. [member LatencyMark.arrival_usec] is of the stream's clock,
## all other times of the server's.
signal marked(p_mark: LatencyMark)
## A snapshot of a tick has been taken: [member decoder] has what it brought.
signal snapshot_taken(p_tick: int)

## Floats of a limb in [method SnapshotSmoother.person_transforms]: position, quaternion.
const FLOATS: int = 7
## What the option --smoothing can be: the methods of [SnapshotSmoother] by name.
const SMOOTHING: Dictionary[String, SnapshotSmoother.Method] = {
	"none": SnapshotSmoother.NONE,
	"linear": SnapshotSmoother.LINEAR,
	"hermite": SnapshotSmoother.HERMITE,
	"extrapolate_lerp": SnapshotSmoother.EXTRAPOLATE_LERP,
	"error_offset": SnapshotSmoother.ERROR_OFFSET,
	"adaptive_low_delay": SnapshotSmoother.ADAPTIVE_LOW_DELAY,
}
## Least time between two acknowledgements, µs, unless more datagrams came than one can name.
const ACK_PERIOD_USEC: int = 112000
## An acknowledgement names so many datagrams and one more.
const MAX_UNACKNOWLEDGED: int = 32
## Age beyond which the decoder takes no snapshot, ticks behind the newest, unless that was wrong.
const STALE: int = 30
## Ticks after their last update for which fields are evaluated: then they have come to rest.
const _FIELD_TICKS: int = 60

## Datagrams that were of use.
var datagrams: int = 0
## Which entities there are; it is void before [method is_ready].
var table: EntityTable = EntityTable.new()
## Events that wait for their moment.
var events: EventQueue = EventQueue.new()
## What is to be heard of contacts, until its moment.
var impacts: ImpactQueue = ImpactQueue.new()
## The newest tick that has come, or -1.
var newest_tick: int = -1
## Outcome of the last datagram.
var outcome: SnapshotDecoder.Outcome = SnapshotDecoder.OK
## Reads the snapshots: what the last datagram of use had, and which command the server has applied.
var decoder: SnapshotDecoder = SnapshotDecoder.new()
## Makes motion smooth: which tick of the server it is, and which bodies are shown where this client
## has predicted them.
var smoother: SnapshotSmoother = SnapshotSmoother.new()
## Whether the server shall mark every snapshot, for measuring delays.
var wants_marks: bool = false

var _acked_usec: int = 0
var _error_deg: float = 0.0
## Whether this server has sent its table: without it snapshots make no sense.
var _has_table: bool = false
var _defined_types: int = 0
## Entities whose fields are in motion, and the tick of their last update.
var _active: Dictionary[int, int] = {}


func _init() -> void:
	_set_error(Protocol.POSE_ERROR_DEG)
	table.spawned.connect(_on_spawned)
	table.despawned.connect(_on_despawned)
	table.cleared.connect(_on_cleared)


## Sets how motion is made smooth, by a name of [constant SMOOTHING].
func set_smoothing(p_name: String) -> void:
	smoother.method = SMOOTHING[p_name]


## Whether the server has sent which entities there are.
func is_ready() -> bool:
	return _has_table


## Takes a message that arrived at a time of the stream's clock, s. Returns whether it was of use.
func take(p_bytes: PackedByteArray, p_arrival_s: float) -> bool:
	if p_bytes.is_empty():
		return false
	match p_bytes[0]:
		Protocol.Message.SNAPSHOT, Protocol.Message.SNAPSHOT_OF_ONE, Protocol.Message.KEY:
			return _take_snapshot(p_bytes, p_arrival_s)
		Protocol.Message.TABLE:
			return _take_table(_decode_table(p_bytes))
		Protocol.Message.LEVEL:
			return _take_level(LevelMessage.decode(p_bytes))
		Protocol.Message.EVENTS:
			for event: EntityEvent in EventMessage.decode(p_bytes):
				events.push(event)
			return true
		Protocol.Message.IMPACTS:
			impacts.push(ImpactMessage.decode(p_bytes))
			return true
	return false


## What is to be sent to the server at a time (µs), by somebody who looks from a position (m);
## mostly nothing.
func acknowledgement(p_now_usec: int, p_viewpoint: Vector3) -> PackedByteArray:
	var is_early: bool = p_now_usec - _acked_usec < ACK_PERIOD_USEC
	if is_early and decoder.get_unacknowledged() < MAX_UNACKNOWLEDGED / 2:
		return PackedByteArray()
	var bytes: PackedByteArray = decoder.get_ack(p_viewpoint)
	if not bytes.is_empty():
		_acked_usec = p_now_usec
	return bytes


## Forgets the server's world, but not how it was made smooth.
func clear() -> void:
	table.clear()
	# Another server may have other types.
	_configure(_error_deg)
	smoother.clear()
	events.clear()
	impacts.clear()
	_active.clear()
	newest_tick = -1
	_has_table = false


## Works out where everything is at a time of the stream's clock, s.
func evaluate(p_now_s: float) -> void:
	smoother.evaluate(p_now_s)


## The server's tick that is shown, with its fraction, or -1.
func shown_tick() -> float:
	return smoother.get_shown_tick()


## The tick of people's motion that is shown, with its fraction, or -1: [method shown_tick], but
## beyond the newest update only as far as motion is carried on.
func motion_tick() -> float:
	return smoother.get_motion_tick()


## The server's ticks per second, or 0 while that is not known.
func tick_rate() -> float:
	return decoder.get_tick_rate()


## How far what is shown is behind the quickest arrivals, s.
func delay() -> float:
	return smoother.get_delay()


## Whether something is known of a person's pose.
func has_person(p_person: int) -> bool:
	return smoother.has_person(p_person)


## Where a person's limbs are, seven floats each; as received last if [param p_newest].
func person_floats(p_person: int, p_newest: bool = false) -> PackedFloat32Array:
	if p_newest:
		return smoother.newest_person_transforms(p_person)
	return smoother.person_transforms(p_person)


## Poses the visible body of a person. Returns whether something is known of its pose.
func pose(p_view: ActorView, p_person: int) -> bool:
	return p_view.pose(smoother, p_person)


## Transforms of a person's bodies, by limb, of such floats.
func limbs_of(p_person: int, p_floats: PackedFloat32Array) -> Array[Transform3D]:
	var row: EntityRow = table.find(p_person)
	var bodies: Array[Transform3D] = []
	if row == null or p_floats.size() != Limbs.COUNT * FLOATS or not row.skeleton.is_sound():
		return bodies
	for limb: int in Limbs.COUNT:
		var at: int = limb * FLOATS
		var position: Vector3 = Vector3(p_floats[at], p_floats[at + 1], p_floats[at + 2])
		var rotation: Quaternion = Quaternion(
			p_floats[at + 3], p_floats[at + 4], p_floats[at + 5], p_floats[at + 6]
		)
		bodies.append(row.skeleton.body_at(limb, position, rotation))
	return bodies


## How far a person's own frame is turned about the vertical in the world, rad; NAN while something
## carries it. A wearer's motion can be shown at once, before the server has moved the body, where
## this is known.
func ground_heading(p_person: int) -> float:
	var row: EntityRow = table.find(p_person)
	if row == null or decoder.get_frame(p_person) >= 0:
		return NAN
	var heading: int = row.type.find_field(EntityType.HEADING)
	return field(p_person, heading) if heading >= 0 else 0.0


## Whether something is known of where a rigid body is.
func has_body(p_id: int) -> bool:
	return smoother.has_body(p_id)


## Where a rigid body is; as received last if [param p_newest].
func body_transform(p_id: int, p_newest: bool = false) -> Transform3D:
	if p_newest:
		return smoother.newest_body_transform(p_id)
	return smoother.body_transform(p_id)


## Rigid bodies that are not where they were at the last [method evaluate].
func moved_bodies() -> PackedInt32Array:
	return smoother.get_moved_bodies()


## Entities whose fields may have other values than in the last frame.
func active_entities() -> PackedInt32Array:
	var found: PackedInt32Array = PackedInt32Array(_active.keys())
	for entity: int in found:
		if shown_tick() > _active[entity] + _FIELD_TICKS:
			_active.erase(entity)
	return found


## The value of a field at the moment that is shown.
func field(p_entity: int, p_field: int) -> float:
	return smoother.field(p_entity, p_field)


## Takes a snapshot's datagram; see [method take].
func _take_snapshot(p_bytes: PackedByteArray, p_arrival_s: float) -> bool:
	outcome = decoder.decode(p_bytes) if _has_table else SnapshotDecoder.NOT_BEGUN
	if outcome != SnapshotDecoder.OK:
		return false
	datagrams += 1
	var tick: int = decoder.get_tick()
	if tick > newest_tick or tick < newest_tick - STALE:
		newest_tick = tick
	_take_motion(p_arrival_s)
	snapshot_taken.emit(tick)
	var mark: LatencyMark = _take_mark()
	if mark != null:
		mark.arrival_usec = roundi(p_arrival_s * 1e6)
		marked.emit(mark)
	return true


## Takes the state of the snapshot that was decoded last.
func _take_motion(p_arrival_s: float) -> void:
	smoother.take(decoder, p_arrival_s)
	for entity: int in decoder.get_changed_entities():
		_active[entity] = decoder.get_tick()


func _decode_table(p_bytes: PackedByteArray) -> EntityTableMessage:
	return EntityTableMessage.decode(p_bytes, table.types)


func _set_skeleton(p_row: EntityRow) -> void:
	var joints: PersonSkeleton = p_row.skeleton
	smoother.set_skeleton(p_row.id, joints.parents, joints.joints_in_parent, joints.joints_in_limb)


## Takes changes of the entity table; null is none.
func _take_table(p_changes: EntityTableMessage) -> bool:
	if p_changes == null or not (p_changes.is_full or _has_table):
		return false
	_set_error(p_changes.pose_error_deg)
	if p_changes.is_full:
		_active.clear()
	if not p_changes.apply(table):
		Log.limited("client", "table", "the server sent changes that do not fit what is here")
		return false
	_has_table = true
	decoder.set_table_version(table.version)
	return true


func _take_level(p_level: LevelMessage) -> bool:
	if p_level == null:
		return false
	clear()
	level_named.emit(p_level.name, p_level.fingerprint)
	return true


func _on_cleared() -> void:
	_defined_types = 0


func _on_spawned(p_row: EntityRow) -> void:
	while _defined_types < table.types.size():
		table.types[_defined_types].define(decoder.define_type, _defined_types)
		_defined_types += 1
	decoder.add_entity(p_row.id, p_row.type_number, p_row.values)
	if p_row.is_person() and p_row.skeleton.is_sound():
		_set_skeleton(p_row)


func _on_despawned(p_row: EntityRow) -> void:
	decoder.remove_entity(p_row.id)
	_active.erase(p_row.id)
	smoother.forget_entity(p_row.id)


## The mark of the datagram that was taken last, in times of the server's clock; null if it had
## none.
func _take_mark() -> LatencyMark:
	var known: Dictionary = decoder.get_mark()
	if known.is_empty():
		return null
	var steps: PackedInt32Array = known["steps_usec"]
	var mark: LatencyMark = LatencyMark.new()
	mark.person = known["person"]
	mark.sample = known["sample"]
	mark.tick = known["tick"]
	mark.simulated_usec = known["simulated_usec"]
	mark.snapshot_sent_usec = mark.simulated_usec + steps[3]
	mark.received_usec = mark.simulated_usec - steps[2]
	mark.sent_usec = mark.received_usec - steps[1]
	mark.sampled_usec = mark.sent_usec - steps[0]
	return mark


func _set_error(p_degrees: float) -> void:
	if p_degrees != _error_deg:
		_configure(p_degrees)
	decoder.set_wants_marks(wants_marks)


func _configure(p_error_deg: float) -> void:
	_error_deg = p_error_deg
	decoder.configure(PackedInt32Array(Limbs.PARENTS), p_error_deg)
	decoder.set_wants_marks(wants_marks)

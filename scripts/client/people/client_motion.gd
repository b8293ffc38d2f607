class_name ClientMotion
extends RefCounted
## The motion of one of a trainee's people: sampled and sent by a [MotionSender], and shown at once
## as the own body (thesis sections 7.4.2 and 7.5).

## Time before a tick begins at which samples should reach the server, µs: later ones wait for the
## next tick. On an unsteady network a little more.
const LEAD_USEC: int = 3500
const MAX_LEAD_USEC: int = 8000
## Span over which the lowest latency of a sample to the server counts, marks.
const _TRIPS: int = 40

## Where the motion comes from.
var source: MotionSource = null
## What is sent to the server about the wearer.
var card: PersonCard = PersonCard.new()
## The person's number in the server's world, or -1.
var actor: int = -1
## The newest sample that [method take_samples] saw, or null.
var newest: PoseSample = null
## The samples that [method take_samples] took last, oldest first.
var taken: Array[PoseSample] = []

var _index: int = 0
var _link: ClientLink = null
var _sender: MotionSender = null
var _body: OwnBody = OwnBody.new()
var _has_body: bool = false
var _truth_tick: int = -1
var _trips: Array[int] = []


## Lets a sender sample a source and send it; [param p_index] tells the people of a client apart.
func start(
	p_source: MotionSource, p_sender: MotionSender, p_link: ClientLink, p_index: int = 0
) -> void:
	source = p_source
	card.index = p_index
	card.take_size(p_source.get_hip_height(), p_source.get_limb_lengths())
	_index = p_index
	_link = p_link
	_sender = p_sender
	_sender.add(_index, p_source)


## Ends the sampling of the source.
func stop() -> void:
	_sender.remove(_index)


## The suit that the person wears, or null.
func suit() -> SuitSource:
	return innermost(source) as SuitSource


## What moves the trunk behind a motion that is carried by a walker's legs, fitted to a headset, or
## put together of several.
static func innermost(p_source: MotionSource) -> MotionSource:
	var inner: MotionSource = p_source
	if inner is WalkedLegs:
		inner = (inner as WalkedLegs).first
	if inner is FusedSource:
		inner = (inner as FusedSource).source
	if inner is LimbFusion:
		inner = (inner as LimbFusion).first()
	return inner


## Sets the own body's number, skeleton and height of the hips, m.
func embody(p_actor: int, p_joints: PersonSkeleton, p_hips: float, p_rate: float) -> void:
	actor = p_actor
	_body.setup(p_joints, p_hips / source.get_hip_height(), p_rate)
	var legs: WalkedLegs = source as WalkedLegs
	if legs != null:
		legs.embody(p_hips, p_joints)
	# A motion that is fitted to a headset is fitted to the body that is shown.
	var worn: XrSource = (legs.first if legs != null else source) as XrSource
	var fault: String = worn.show_on(p_joints, p_hips) if worn != null else ""
	if fault != "":
		Log.warning("client", "hands may miss what they hold: " + fault)
	var walker: WalkerSource = source as WalkerSource
	if walker != null:
		walker.embody(p_hips, p_joints)
	_body.clear()
	_has_body = true
	_truth_tick = -1
	_trips.clear()


## Forgets the body: the server will send another.
func disembody() -> void:
	actor = -1
	_has_body = false


## Records how long a sample took to the server, from a latency mark of the own person.
func note_trip(p_mark: LatencyMark) -> void:
	_trips.append(p_mark.received_usec - p_mark.sampled_usec)
	if _trips.size() > _TRIPS:
		_trips.pop_front()


## Locks the samples' times to the server's ticks. Call it now and then.
func keep_in_step() -> void:
	if _link.clock.is_known():
		var now: int = Time.get_ticks_usec()
		var tick: int = ceili(_link.clock.tick_at(now)) + 1
		var transit: int = _link.clock.round_trip_usec / 2
		var lead: int = mini(LEAD_USEC + roundi(2.0 * _link.clock.jitter_usec), MAX_LEAD_USEC)
		var due: int = _link.clock.local_usec_of_tick(tick) - transit - lead
		var ahead: int = _link.clock.server_usec(now) - now
		_sender.keep_in_step(ahead, due + MotionSender.unix_ahead())


## Takes what was sampled since the last call. Call it in every frame.
func take_samples() -> void:
	taken = _sender.take_samples(_index)
	for sample: PoseSample in taken:
		newest = sample
		if _has_body:
			_body.add_sample(sample)


## The own body at a local time, µs: seven floats a limb. Empty until the server's state of it, and
## the tick of that state, are known.
func evaluate(p_now_usec: int, p_truth: PackedFloat32Array, p_tick: int) -> PackedFloat32Array:
	if not _has_body or p_truth.is_empty():
		return PackedFloat32Array()
	var moment: int = _moment_of(p_tick) if p_tick != _truth_tick else -1
	if moment >= 0:
		_truth_tick = p_tick
		_body.add_truth(moment, p_truth)
	# Only the server knows where the body is in the world, and what it touches.
	if _truth_tick < 0:
		return PackedFloat32Array()
	return _body.evaluate(p_now_usec / 1e6, p_now_usec + MotionSender.unix_ahead())


## Where the wearer's own frame lies in the world, of the body's floats and its heading, rad. Takes
## a body that is carried as it sits: NAN for the heading.
func frame_in_world(p_floats: PackedFloat32Array, p_heading: float) -> Transform3D:
	if not _has_body or newest == null or p_floats.size() < 7:
		return Transform3D.IDENTITY
	var heading: float = p_heading
	if is_nan(heading):
		var shown: Quaternion = Quaternion(p_floats[3], p_floats[4], p_floats[5], p_floats[6])
		heading = _yaw(shown) - _yaw(newest.orientation(Limbs.ROOT))
	return _body.frame_in_world(newest, p_floats, heading)


## Says how far the person's own frame is turned about the vertical in the world, rad; with NAN it
## stays as it is.
func turn(p_heading: float) -> void:
	_body.turn(p_heading)


## Which moment of the motion [method show] shows at a local time: µs of Unix time.
func shown_moment_usec(p_now_usec: int) -> int:
	return _body.shown_moment_usec(p_now_usec + MotionSender.unix_ahead())


## Stats for a report.
func stats() -> Dictionary:
	return _sender.stats(_index)


## Which moment of the motion a tick of the server has made true: µs of Unix time; -1: not known.
func _moment_of(p_tick: int) -> int:
	var walker: WalkerSource = source as WalkerSource
	if walker != null:
		return walker.moment_of(p_tick)
	if not _link.clock.is_known() or _trips.is_empty():
		return -1
	# The step that ended the tick aimed at the motion as known at the tick's beginning, one step
	# further.
	var aimed: int = _link.clock.local_usec_of_tick(p_tick + 1.0) - _trips.min()
	return aimed + MotionSender.unix_ahead()


## Where something that faces +Z at rest faces: rad about the vertical.
static func _yaw(p_turn: Quaternion) -> float:
	var ahead: Vector3 = p_turn * Vector3.BACK
	return atan2(ahead.x, ahead.z)

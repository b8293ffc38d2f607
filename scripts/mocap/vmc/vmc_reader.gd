class_name VmcReader
extends StreamReader
## Reads the VMC protocol (https://protocol.vmc.info, Marionette's side): OSC messages in Unity's
## left-handed frame, metres, with each bone's rotation from the VRM's T-pose and its position, both
## on the bone above it. A rotation of VRM 1's own bones (not normalised) cannot be read without the
## model: senders have to normalise them, as VRM 0 does.
##
## A frame comes in one datagram or in many. It is whole when all bones of the frame before have
## come, or else when the next one begins; bones of it that got lost are put between their
## neighbours.

## Greatest number of senders whose bones are kept.
const _MAX_SENDERS: int = 16
## Greatest number of devices of a sender that are listed.
const _MAX_DEVICES: int = 8
## Least length of a lower leg, m: a stream with a shorter one has no positions.
const _MIN_LEG: float = 0.1

## Time of a frame whose sender gives none.
const _UNKNOWN: int = -1
## Step back in a sender's time beyond which the sender has started again, µs.
const _RESTART_USEC: int = 1000000
## Greatest number of frames that wait for their bones, and of frames in a row that lack some.
const _MAX_OPEN: int = 6
const _MAX_SHORT: int = 60

# All joints, parents before their children.
var _order: PackedInt32Array = _find_order()
var _osc: Osc = Osc.new()
var _actors: Dictionary[String, Actor] = {}


## The bones of one moment.
class Frame:
	## The sender's time, µs, or -1.
	var usec: int = -1
	## Order among frames: its time, or a count if the sender gives no time.
	var key: int = 0
	## When its newest bone arrived, µs of Unix time.
	var arrival_usec: int = 0
	## Rotation and position of each bone on the one above it, in Godot's frame, by joint.
	var bones: Dictionary[int, Transform3D] = {}


## State of one sender.
class Actor:
	## Bones of the last finished frame, and its key.
	var bones: Dictionary[int, Transform3D] = {}
	var key: int = -1
	## Unfinished frames, oldest first.
	var frames: Array[Frame] = []
	## Number of bones of a whole frame, and of frames in a row that were passed on with fewer.
	var count: int = 0
	var short_frames: int = 0
	## Bones that moved in the last frame, and those of them that have since come again
	## unchanged.
	var moving: Dictionary[int, bool] = {}
	var repeated: Dictionary[int, bool] = {}
	## Whether different bones have come with the same time: then the time is not used.
	var is_timeless: bool = false
	## Transform of the model in the world.
	var root: Transform3D = Transform3D.IDENTITY
	## Whether a model is loaded and calibrated, as far as the sender says.
	var is_loaded: bool = true
	var is_calibrated: bool = true
	## Serials of headset, controllers and trackers.
	var devices: Dictionary[String, bool] = {}
	var builder: PoseBuilder = PoseBuilder.new()


func title() -> String:
	return "VMC"


func read(p_bytes: PackedByteArray, p_sender: String) -> Array[StreamSample]:
	var samples: Array[StreamSample] = []
	var messages: Array[Array] = _osc.read(p_bytes)
	fault = _osc.fault
	if not _actors.has(p_sender):
		if messages.is_empty():
			return samples
		if _actors.size() >= _MAX_SENDERS:
			_actors.erase(_actors.keys()[0])
		_actors[p_sender] = Actor.new()
	var actor: Actor = _actors[p_sender]
	var coming: Dictionary[int, Transform3D] = {}
	var usec: int = -1
	for message: Array in messages:
		if message[0] == "/VMC/Ext/Bone/Pos":
			_take_bone(message, coming)
		elif message[0] == "/VMC/Ext/T":
			usec = _time_of(message)
		else:
			_take(actor, message)
	if not coming.is_empty():
		actor.is_timeless = actor.is_timeless or _time_stands(actor, coming, usec)
		_put(actor, coming, _UNKNOWN if actor.is_timeless else usec)
		_settle(actor, samples)
	return samples


func detail(p_sender: String) -> String:
	var actor: Actor = _actors.get(p_sender)
	if actor == null or actor.devices.is_empty():
		return ""
	return "devices " + " ".join(actor.devices.keys())


func trouble(p_sender: String) -> String:
	var actor: Actor = _actors.get(p_sender)
	if actor == null:
		return ""
	if not actor.is_loaded:
		return "the sender has loaded no model: load one there"
	return "" if actor.is_calibrated else "the sender is not calibrated: calibrate there"


static func _find_order() -> PackedInt32Array:
	var order: PackedInt32Array = PackedInt32Array(PoseBuilder.PARENTS.keys())
	for hand: int in 2:
		order.append_array(FingerJoints.of_hand(hand))
	return order


func _take_bone(p_message: Array, r_bones: Dictionary[int, Transform3D]) -> void:
	var joint: int = UnityBones.joint_of(str(p_message[1])) if p_message.size() > 1 else -1
	if joint >= 0 and _is_place(p_message):
		r_bones[joint] = _place_of(p_message)


static func _time_of(p_message: Array) -> int:
	if p_message.size() < 2 or not p_message[1] is float or not is_finite(p_message[1]):
		return -1
	return roundi(clampf(p_message[1], 0.0, 1e9) * 1e6)


func _take(r_actor: Actor, p_message: Array) -> void:
	match p_message[0]:
		"/VMC/Ext/Root/Pos":
			if _is_place(p_message):
				r_actor.root = _root_of(p_message)
		"/VMC/Ext/OK":
			if p_message.size() > 1 and p_message[1] is int:
				r_actor.is_loaded = p_message[1] != 0
				# 3 is calibrated; before version 2.5 it was not said.
				var is_said: bool = p_message.size() > 2 and p_message[2] is int
				r_actor.is_calibrated = not is_said or p_message[2] == 3
		"/VMC/Ext/Hmd/Pos", "/VMC/Ext/Con/Pos", "/VMC/Ext/Tra/Pos":
			if p_message.size() > 1 and p_message[1] is String:
				if r_actor.devices.size() < _MAX_DEVICES:
					r_actor.devices[ByteReader.clean(p_message[1]).left(24)] = true


## Whether a message has a name, a position and a rotation.
func _is_place(p_message: Array) -> bool:
	if p_message.size() < 9 or not p_message[1] is String:
		fault = "%s has too few arguments" % p_message[0]
		return false
	for at: int in range(2, 9):
		if not p_message[at] is float or not is_finite(p_message[at]):
			fault = "%s has an argument that is no finite number" % p_message[0]
			return false
	var turn: Vector4 = Vector4(p_message[5], p_message[6], p_message[7], p_message[8])
	if absf(turn.length() - 1.0) > 0.1:
		fault = "%s has a rotation of length %.2f" % [p_message[0], turn.length()]
		return false
	return true


static func _place_of(p_message: Array) -> Transform3D:
	var frame: SourceFrames.Frame = SourceFrames.Frame.MVN_UNITY
	var turn: Quaternion = SourceFrames.rotation(
		p_message[8], p_message[5], p_message[6], p_message[7], frame
	)
	var place: Vector3 = Vector3(p_message[2], p_message[3], p_message[4])
	return Transform3D(Basis(turn.normalized()), SourceFrames.position(place, frame))


## From version 2.1 the root says too by how much the model is larger than the wearer, and how far
## off: EVMC4U divides by that scale, and so does this.
static func _root_of(p_message: Array) -> Transform3D:
	var root: Transform3D = _place_of(p_message)
	if p_message.size() < 15:
		return root
	for at: int in range(9, 15):
		if not p_message[at] is float or not is_finite(p_message[at]):
			return root
	var scale: Vector3 = Vector3(p_message[9], p_message[10], p_message[11])
	if scale.x < 0.1 or scale.y < 0.1 or scale.z < 0.1 or scale.length() > 20.0:
		return root
	var offset: Vector3 = SourceFrames.position(
		Vector3(p_message[12], p_message[13], p_message[14]), SourceFrames.Frame.MVN_UNITY
	)
	root.origin = (root.origin - offset) / scale
	root.basis = root.basis.scaled_local(Vector3.ONE / scale)
	return root


## Whether other bones contain all these bones with the same transforms.
static func _is_contained(
	p_bones: Dictionary[int, Transform3D], p_others: Dictionary[int, Transform3D]
) -> bool:
	for joint: int in p_bones:
		if not p_others.has(joint) or p_others[joint] != p_bones[joint]:
			return false
	return true


## Whether both have some bone.
static func _meet(
	p_bones: Dictionary[int, Transform3D], p_others: Dictionary[int, Transform3D]
) -> bool:
	for joint: int in p_bones:
		if p_others.has(joint):
			return true
	return false


## Whether bones come with a time that other bones had before: the sender's clock stands still or
## is too coarse.
static func _time_stands(
	p_actor: Actor, p_bones: Dictionary[int, Transform3D], p_usec: int
) -> bool:
	if p_usec < 0:
		return false
	if p_usec == p_actor.key and _differ(p_bones, p_actor.bones):
		return true
	for frame: Frame in p_actor.frames:
		if frame.key == p_usec and _differ(p_bones, frame.bones):
			return true
	return false


## Whether some bone that both have differs.
static func _differ(
	p_bones: Dictionary[int, Transform3D], p_others: Dictionary[int, Transform3D]
) -> bool:
	for joint: int in p_bones:
		if p_others.has(joint) and p_others[joint] != p_bones[joint]:
			return true
	return false


## Puts bones into the frame of a time, µs, or into the newest one where no time came with them.
func _put(r_actor: Actor, p_bones: Dictionary[int, Transform3D], p_usec: int) -> void:
	if p_usec >= 0 and p_usec < r_actor.key - _RESTART_USEC:
		r_actor.frames.clear()
		r_actor.key = -1
	if p_usec >= 0:
		if p_usec > r_actor.key:
			var frame: Frame = _frame_at(r_actor, p_usec)
			frame.bones.merge(p_bones, true)
			frame.arrival_usec = now_usec
		return
	var newest: Frame = r_actor.frames[-1] if not r_actor.frames.is_empty() else null
	var bones: Dictionary[int, Transform3D] = _without_repeats(r_actor, p_bones)
	if bones.is_empty() or (newest != null and _is_contained(bones, newest.bones)):
		return
	if newest == null or _meet(bones, newest.bones):
		var key: int = (newest.key if newest != null else r_actor.key) + 1
		newest = _frame_at(r_actor, key)
		# A time in a datagram of its own may be the next frame's, or may have got lost.
		newest.usec = _UNKNOWN
	newest.bones.merge(bones, true)
	newest.arrival_usec = now_usec


## Bones less those that came twice: such a bone is as in the frame before, though it was moving.
## One that comes a second time like that does not move any more.
static func _without_repeats(
	r_actor: Actor, p_bones: Dictionary[int, Transform3D]
) -> Dictionary[int, Transform3D]:
	var bones: Dictionary[int, Transform3D] = {}
	for joint: int in p_bones:
		var repeats: bool = r_actor.moving.has(joint) and r_actor.bones[joint] == p_bones[joint]
		if repeats and not r_actor.repeated.has(joint):
			r_actor.repeated[joint] = true
		else:
			bones[joint] = p_bones[joint]
	return bones


## The frame of a key, a new one if there is none yet.
static func _frame_at(r_actor: Actor, p_key: int) -> Frame:
	var at: int = r_actor.frames.size()
	while at > 0 and r_actor.frames[at - 1].key >= p_key:
		at -= 1
		if r_actor.frames[at].key == p_key:
			return r_actor.frames[at]
	var frame: Frame = Frame.new()
	frame.key = p_key
	frame.usec = p_key
	r_actor.frames.insert(at, frame)
	return frame


## Passes on whole frames and all before them, or the oldest one if too many wait.
func _settle(r_actor: Actor, r_samples: Array[StreamSample]) -> void:
	var frames: Array[Frame] = r_actor.frames
	if r_actor.count == 0:
		if frames.size() < 2:
			return
		r_actor.count = frames[0].bones.size()
	var newest: int = frames.size() - 1
	while newest >= 0 and frames[newest].bones.size() < r_actor.count:
		newest -= 1
	r_actor.short_frames = 0 if newest >= 0 else r_actor.short_frames
	if newest < 0 and frames.size() > _MAX_OPEN:
		# Much loss, or for long another model with fewer bones.
		newest = 0
		r_actor.short_frames += 1
		if r_actor.short_frames > _MAX_SHORT:
			r_actor.count = 1
			for frame: Frame in frames:
				r_actor.count = maxi(r_actor.count, frame.bones.size())
	for _number: int in newest + 1:
		_finish(r_actor, r_samples)


## The oldest frame is done: bones that it lacks were between those before and those that came
## since.
func _finish(r_actor: Actor, r_samples: Array[StreamSample]) -> void:
	var frame: Frame = r_actor.frames[0]
	r_actor.frames.remove_at(0)
	r_actor.count = maxi(r_actor.count, frame.bones.size())
	for joint: int in r_actor.bones:
		if not frame.bones.has(joint):
			frame.bones[joint] = _between(r_actor, joint, frame.key)
	r_actor.moving.clear()
	r_actor.repeated.clear()
	for joint: int in frame.bones:
		if not r_actor.bones.has(joint) or r_actor.bones[joint] != frame.bones[joint]:
			r_actor.moving[joint] = true
	r_actor.bones = frame.bones
	r_actor.key = frame.key
	_emit(r_actor, frame, r_samples)


static func _between(p_actor: Actor, p_joint: int, p_key: int) -> Transform3D:
	var before: Transform3D = p_actor.bones[p_joint]
	for later: Frame in p_actor.frames:
		if later.bones.has(p_joint):
			var part: float = float(p_key - p_actor.key) / maxi(later.key - p_actor.key, 1)
			return before.interpolate_with(later.bones[p_joint], part)
	return before


func _emit(r_actor: Actor, p_frame: Frame, r_samples: Array[StreamSample]) -> void:
	var builder: PoseBuilder = r_actor.builder
	builder.clear()
	var hips: int = XRBodyTracker.JOINT_HIPS
	if r_actor.bones.has(hips):
		var place: Transform3D = r_actor.root * r_actor.bones[hips]
		builder.set_local(hips, place.basis.get_rotation_quaternion(), place.origin)
	var size: Vector3 = r_actor.root.basis.get_scale()
	for bone: int in _order:
		if bone != hips and r_actor.bones.has(bone):
			var local: Transform3D = r_actor.bones[bone]
			var turn: Quaternion = local.basis.get_rotation_quaternion()
			builder.set_local(bone, turn, local.origin * size)
	var shank: Transform3D = r_actor.bones.get(
		XRBodyTracker.JOINT_LEFT_LOWER_LEG, Transform3D.IDENTITY
	)
	var sample: StreamSample = StreamSample.new()
	sample.pose = builder.build(shank.origin.length() > _MIN_LEG)
	if sample.pose == null:
		return
	sample.source_usec = p_frame.usec
	sample.arrival_usec = p_frame.arrival_usec
	r_samples.append(sample)

class_name RokokoReader
extends StreamReader
## Reads Rokoko Studio's custom streaming, JSON version 3: plain, or compressed as an LZ4 frame.
## Bones have positions (metres) and rotations in the world, in Unity's left-handed frame; how each
## lies in the T-pose is as Rokoko's own plugin for Blender has it.

## Rotations of the bones in Studio's T-pose (w, x, y, z).
const REST: Dictionary[String, Array] = {
	"hip": [-1.0, 0.0, 0.0, 0.0],
	"spine": [0.0, 0.0, 0.0, -1.0],
	"chest": [0.0, 0.0, 0.0, -1.0],
	"neck": [0.0, 0.0, 0.0, -1.0],
	"head": [0.0, 0.0, 0.0, -1.0],
	"leftShoulder": [-_HALF, 0.0, 0.0, _HALF],
	"leftUpperArm": [-0.5, -0.5, -0.5, 0.5],
	"leftLowerArm": [-0.5, -0.5, -0.5, 0.5],
	"leftHand": [-0.5, -0.5, -0.5, 0.5],
	"rightShoulder": [_HALF, 0.0, 0.0, _HALF],
	"rightUpperArm": [0.5, 0.5, -0.5, 0.5],
	"rightLowerArm": [0.5, 0.5, -0.5, 0.5],
	"rightHand": [0.5, 0.5, -0.5, 0.5],
	"leftUpLeg": [_HALF, 0.0, _HALF, 0.0],
	"leftLeg": [_HALF, 0.0, _HALF, 0.0],
	"leftFoot": [0.0, 0.0, _HALF, -_HALF],
	"leftToe": [0.0, 0.0, _HALF, -_HALF],
	"rightUpLeg": [_HALF, 0.0, -_HALF, 0.0],
	"rightLeg": [_HALF, 0.0, -_HALF, 0.0],
	"rightFoot": [0.0, 0.0, -_HALF, _HALF],
	"rightToe": [0.0, 0.0, -_HALF, _HALF],
}
## Joints of the bones.
const JOINTS: Dictionary[String, int] = {
	"hip": XRBodyTracker.JOINT_HIPS,
	"spine": XRBodyTracker.JOINT_SPINE,
	"chest": XRBodyTracker.JOINT_CHEST,
	"neck": XRBodyTracker.JOINT_NECK,
	"head": XRBodyTracker.JOINT_HEAD,
	"leftShoulder": XRBodyTracker.JOINT_LEFT_SHOULDER,
	"leftUpperArm": XRBodyTracker.JOINT_LEFT_UPPER_ARM,
	"leftLowerArm": XRBodyTracker.JOINT_LEFT_LOWER_ARM,
	"leftHand": XRBodyTracker.JOINT_LEFT_HAND,
	"rightShoulder": XRBodyTracker.JOINT_RIGHT_SHOULDER,
	"rightUpperArm": XRBodyTracker.JOINT_RIGHT_UPPER_ARM,
	"rightLowerArm": XRBodyTracker.JOINT_RIGHT_LOWER_ARM,
	"rightHand": XRBodyTracker.JOINT_RIGHT_HAND,
	"leftUpLeg": XRBodyTracker.JOINT_LEFT_UPPER_LEG,
	"leftLeg": XRBodyTracker.JOINT_LEFT_LOWER_LEG,
	"leftFoot": XRBodyTracker.JOINT_LEFT_FOOT,
	"leftToe": XRBodyTracker.JOINT_LEFT_TOES,
	"rightUpLeg": XRBodyTracker.JOINT_RIGHT_UPPER_LEG,
	"rightLeg": XRBodyTracker.JOINT_RIGHT_LOWER_LEG,
	"rightFoot": XRBodyTracker.JOINT_RIGHT_FOOT,
	"rightToe": XRBodyTracker.JOINT_RIGHT_TOES,
}
## Joints of a hand's fingers by Studio's names behind "left" or "right", counted from the hand. All
## lie as the hand does; the thumb as Blender's plugin says, for the left side (w, x, y, z).
const FINGERS: Dictionary[String, int] = {
	"ThumbProximal": 3,
	"ThumbMedial": 4,
	"ThumbDistal": 5,
	"IndexProximal": 8,
	"IndexMedial": 9,
	"IndexDistal": 10,
	"MiddleProximal": 13,
	"MiddleMedial": 14,
	"MiddleDistal": 15,
	"RingProximal": 18,
	"RingMedial": 19,
	"RingDistal": 20,
	"LittleProximal": 23,
	"LittleMedial": 24,
	"LittleDistal": 25,
}
const THUMBS: Array[Array] = [
	[-0.0923, -0.56098, -0.70106, 0.43046],
	[-0.2706, -0.65328, -0.65328, 0.2706],
	[-0.2706, -0.65328, -0.65328, 0.2706],
]
## Largest text that is unpacked, bytes.
const MAX_TEXT: int = 1 << 20
const _HALF: float = 0.7071067811865476
const _MAX_ACTORS: int = 8

# Inverse of each bone's rotation in the T-pose.
var _rests: Dictionary[String, Quaternion] = {}
var _json: StreamJson = StreamJson.new()
var _builder: PoseBuilder = PoseBuilder.new()


func _init() -> void:
	for bone: String in REST:
		_rests[bone] = _in_godot(REST[bone]).inverse()
	for finger: String in FINGERS:
		var part: int = FINGERS[finger] - 3
		var left: Array = THUMBS[part] if part < 3 else REST["leftHand"]
		var right: Array = [-left[0], -left[1], left[2], left[3]]
		_rests["left" + finger] = _in_godot(left).inverse()
		_rests["right" + finger] = _in_godot(right).inverse()


func title() -> String:
	return "Rokoko"


func read(p_bytes: PackedByteArray, _p_sender: String) -> Array[StreamSample]:
	var bytes: PackedByteArray = p_bytes
	if Lz4.is_frame(p_bytes):
		bytes = Lz4.unpack(p_bytes, MAX_TEXT)
		if bytes.is_empty():
			return refuse("it is an LZ4 frame that can't be unpacked")
	var message: Dictionary = _json.read(bytes)
	if _json.fault != "":
		return refuse(_json.fault)
	var version: String = str(message.get("version", "")).left(20).replace(",", ".")
	var scene: Dictionary = StreamJson.child(message, "scene")
	if not version.begins_with("3") or scene.is_empty():
		return refuse("its version is '%s': choose JSON v3 in Studio" % ByteReader.clean(version))
	var time_s: float = StreamJson.number(scene, "timestamp")
	var samples: Array[StreamSample] = []
	for actor: Variant in StreamJson.list(scene, "actors").slice(0, _MAX_ACTORS):
		if not actor is Dictionary:
			return refuse("an actor is no object")
		var sample: StreamSample = _read_actor(actor)
		if sample != null:
			sample.person = sample.name
			sample.source_usec = roundi(time_s * 1e6) if time_s >= 0.0 and time_s < 1e11 else -1
			samples.append(sample)
	return samples


## The joint of one of Studio's bones, or -1.
static func joint_of(p_bone: String) -> int:
	if JOINTS.has(p_bone):
		return JOINTS[p_bone]
	for side: int in 2:
		var finger: String = p_bone.trim_prefix("right" if side == 1 else "left")
		if finger != p_bone and FINGERS.has(finger):
			var hands: PackedInt32Array = [
				XRBodyTracker.JOINT_LEFT_HAND, XRBodyTracker.JOINT_RIGHT_HAND
			]
			return hands[side] + FINGERS[finger]
	return -1


func _read_actor(p_actor: Dictionary) -> StreamSample:
	var body: Dictionary = StreamJson.child(p_actor, "body")
	_builder.clear()
	for bone: String in body:
		var joint: int = joint_of(bone)
		if joint < 0 or not body[bone] is Dictionary:
			continue
		var turn: Quaternion = StreamJson.quaternion(StreamJson.child(body[bone], "rotation"))
		var place: Vector3 = StreamJson.vector(StreamJson.child(body[bone], "position"))
		# A comparison that NaN fails, too.
		if not absf(turn.length() - 1.0) < 0.1:
			fault = "%s has no rotation" % bone
			continue
		turn = SourceFrames.rotation(turn.w, turn.x, turn.y, turn.z, SourceFrames.Frame.MVN_UNITY)
		_builder.set_turn(joint, (turn * _rests[bone]).normalized())
		if place.length() < 1e4:
			_builder.set_position(joint, SourceFrames.position(place, SourceFrames.Frame.MVN_UNITY))
	var sample: StreamSample = StreamSample.new()
	sample.name = StreamJson.text(p_actor, "name")
	sample.pose = _builder.build()
	var hips: float = StreamJson.number(StreamJson.child(p_actor, "dimensions"), "hipHeight")
	sample.hip_height = hips if is_finite(hips) else 0.0
	if sample.pose == null and fault == "" and not body.is_empty():
		fault = "an actor's body has no bones that are known"
	return sample if sample.pose != null else null


static func _in_godot(p_wxyz: Array) -> Quaternion:
	var turn: Quaternion = SourceFrames.rotation(
		p_wxyz[0], p_wxyz[1], p_wxyz[2], p_wxyz[3], SourceFrames.Frame.MVN_UNITY
	)
	return turn.normalized()

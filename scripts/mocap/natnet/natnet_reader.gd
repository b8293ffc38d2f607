class_name NatnetReader
extends StreamReader
## Reads OptiTrack Motive's NatNet stream, versions 3 and 4: what the server is, which skeletons
## there are, and frames of motion. Little-endian; Y up, right-handed, metres; who stands in the
## T-pose faces +Z. Layouts are those of NatNet's own samples, as python-natnet-client describes
## them.
##
## The version decides the layout, so the server is asked for it, and for the names of the bones;
## until both have come frames are not used. Skeletons may be streamed on the bones above or in the
## world: the places of the bones say which.

## Messages.
const CONNECT: int = 0
const SERVERINFO: int = 1
const REQUEST_MODELDEF: int = 4
const MODELDEF: int = 5
const FRAME: int = 7
const KEEPALIVE: int = 10
## Port of the server, and the multicast group of its data.
const COMMAND_PORT: int = 1510
const GROUP: String = "239.255.42.99"
## Names of bones: Motive's own, FBX' and BVH's.
const NAMES: Dictionary[String, int] = {
	"hip": XRBodyTracker.JOINT_HIPS,
	"hips": XRBodyTracker.JOINT_HIPS,
	"ab": XRBodyTracker.JOINT_SPINE,
	"spine": XRBodyTracker.JOINT_SPINE,
	"chest": XRBodyTracker.JOINT_CHEST,
	"spine1": XRBodyTracker.JOINT_CHEST,
	"chest2": XRBodyTracker.JOINT_UPPER_CHEST,
	"spine2": XRBodyTracker.JOINT_UPPER_CHEST,
	"neck": XRBodyTracker.JOINT_NECK,
	"head": XRBodyTracker.JOINT_HEAD,
	"lshoulder": XRBodyTracker.JOINT_LEFT_SHOULDER,
	"luarm": XRBodyTracker.JOINT_LEFT_UPPER_ARM,
	"lfarm": XRBodyTracker.JOINT_LEFT_LOWER_ARM,
	"lhand": XRBodyTracker.JOINT_LEFT_HAND,
	"lthigh": XRBodyTracker.JOINT_LEFT_UPPER_LEG,
	"lshin": XRBodyTracker.JOINT_LEFT_LOWER_LEG,
	"lfoot": XRBodyTracker.JOINT_LEFT_FOOT,
	"ltoe": XRBodyTracker.JOINT_LEFT_TOES,
	"leftcollar": XRBodyTracker.JOINT_LEFT_SHOULDER,
	"leftarm": XRBodyTracker.JOINT_LEFT_UPPER_ARM,
	"leftforearm": XRBodyTracker.JOINT_LEFT_LOWER_ARM,
	"leftelbow": XRBodyTracker.JOINT_LEFT_LOWER_ARM,
	"lefthand": XRBodyTracker.JOINT_LEFT_HAND,
	"leftwrist": XRBodyTracker.JOINT_LEFT_HAND,
	"leftupleg": XRBodyTracker.JOINT_LEFT_UPPER_LEG,
	"lefthip": XRBodyTracker.JOINT_LEFT_UPPER_LEG,
	"leftleg": XRBodyTracker.JOINT_LEFT_LOWER_LEG,
	"leftknee": XRBodyTracker.JOINT_LEFT_LOWER_LEG,
	"leftfoot": XRBodyTracker.JOINT_LEFT_FOOT,
	"leftankle": XRBodyTracker.JOINT_LEFT_FOOT,
	"lefttoebase": XRBodyTracker.JOINT_LEFT_TOES,
	"lefttoe": XRBodyTracker.JOINT_LEFT_TOES,
}
## The period of asking, µs; of what is not known yet, and of a sign of life.
const ASK_USEC: int = 1000000
const _MAX_SKELETONS: int = 8
const _MAX_BONES: int = 128
const _MAX_SERVERS: int = 8
## Silence after which a server is forgotten, µs.
const _GONE_USEC: int = 10000000
## A bone's place on the one above it differs from its description by less, m.
const _SAME_M: float = 0.02

## The server's host, or an empty text: then servers are found by what they send to the group.
var host: String = ""

var _servers: Dictionary[String, Motive] = {}
var _bytes: NatnetBytes = NatnetBytes.new()


## What is known of one server, by its address.
class Motive:
	## UDP port that it is asked at.
	var port: int = COMMAND_PORT
	## Program, and version of the stream (4.1 is 401); 0 if it is not known.
	var program: String = ""
	var version: int = 0
	## Skeletons by number.
	var skeletons: Dictionary[int, Skeleton] = {}
	var asked_usec: int = 0
	var has_models: bool = false
	## Whether a frame had a skeleton that no description is known of.
	var lacks_some: bool = false
	## When it was last heard, µs of Unix time.
	var heard_usec: int = 0


## A skeleton of a server.
class Skeleton:
	var name: String = ""
	## Bones by number: the joint or -1, the number of the one above, the place on it at rest, m.
	var joints: Dictionary[int, int] = {}
	var parents: Dictionary[int, int] = {}
	var offsets: Dictionary[int, Vector3] = {}
	var builder: PoseBuilder = PoseBuilder.new()


func title() -> String:
	return "NatNet"


func read(p_bytes: PackedByteArray, p_sender: String) -> Array[StreamSample]:
	var samples: Array[StreamSample] = []
	if p_bytes.size() < 4:
		return refuse("%d bytes are no message" % p_bytes.size())
	var address: String = p_sender.get_slice(":", 0)
	if host != "" and address != host:
		return refuse("the server is %s, and this is not" % host)
	var size: int = p_bytes.decode_u16(2)
	if size > p_bytes.size() - 4:
		return refuse("a message of %d bytes where %d came" % [size, p_bytes.size() - 4])
	if not _servers.has(address):
		if _servers.size() >= _MAX_SERVERS:
			return refuse("more than %d servers" % _MAX_SERVERS)
		_servers[address] = Motive.new()
	var server: Motive = _servers[address]
	server.heard_usec = now_usec
	_bytes.begin(p_bytes, 4)
	match p_bytes.decode_u16(0):
		SERVERINFO:
			_read_info(server)
			server.port = p_sender.get_slice(":", 1).to_int()
		MODELDEF:
			_read_models(server)
		FRAME:
			if server.version > 0 and server.has_models:
				_read_frame(server, samples)
	if _bytes.fault != "":
		fault = _bytes.fault
	return samples


func talk(p_now_usec: int) -> Array[StreamPort.Parcel]:
	var parcels: Array[StreamPort.Parcel] = []
	if host != "" and not _servers.has(host):
		_servers[host] = Motive.new()
	for address: String in _servers.keys():
		var server: Motive = _servers[address]
		var silent_usec: int = p_now_usec - server.heard_usec
		if address != host and server.heard_usec > 0 and silent_usec > _GONE_USEC:
			_servers.erase(address)
			continue
		if p_now_usec - server.asked_usec < ASK_USEC:
			continue
		server.asked_usec = p_now_usec
		var message: PackedByteArray = NatnetBytes.message(KEEPALIVE)
		if server.version == 0:
			message = NatnetBytes.message(CONNECT, "Ping")
		elif not server.has_models or server.skeletons.is_empty() or server.lacks_some:
			# Also again, where skeletons are made meanwhile.
			message = NatnetBytes.message(REQUEST_MODELDEF)
		parcels.append(StreamPort.Parcel.new(message, address, server.port))
	return parcels


func detail(p_sender: String) -> String:
	var server: Motive = _servers.get(p_sender.get_slice(":", 0))
	if server == null or server.version == 0:
		return "its version has not come yet"
	@warning_ignore("integer_division")
	var parts: Array = [server.program, server.version / 100, server.version % 100]
	return "%s, NatNet %d.%d" % parts


func trouble(p_sender: String) -> String:
	var server: Motive = _servers.get(p_sender.get_slice(":", 0))
	if server != null and server.has_models and server.skeletons.is_empty():
		return "the server has no skeletons: create one in Motive, and stream skeletons"
	return ""


## The joint of a bone's name, such as "Skeleton1_LUArm" or "Hips", or -1.
static func joint_of(p_name: String) -> int:
	var name: String = p_name.to_lower().get_slice(":", p_name.get_slice_count(":") - 1)
	if not name.trim_prefix("right").is_empty() and _find(name) < 0:
		name = name.get_slice("_", name.get_slice_count("_") - 1)
	return _find(name)


static func _find(p_name: String) -> int:
	if NAMES.has(p_name):
		return NAMES[p_name]
	var mirrored: String = ""
	if p_name.begins_with("right"):
		mirrored = "left" + p_name.trim_prefix("right")
	elif p_name.begins_with("r"):
		mirrored = "l" + p_name.trim_prefix("r")
	if mirrored == "" or not NAMES.has(mirrored):
		return -1
	var left: int = NAMES[mirrored]
	var at: int = HumanoidAxes.JOINTS.find(left)
	if at >= 0:
		return HumanoidAxes.JOINTS[at + 3]
	if left == XRBodyTracker.JOINT_LEFT_SHOULDER:
		return XRBodyTracker.JOINT_RIGHT_SHOULDER
	return XRBodyTracker.JOINT_RIGHT_TOES


func _read_info(r_server: Motive) -> void:
	var name: String = _bytes.read_text(256, true)
	_bytes.skip(4)
	var major: int = _bytes.read_u8()
	var minor: int = _bytes.read_u8()
	if _bytes.fault != "":
		return
	if major < 3 or major > 4:
		_bytes.fault = "NatNet %d.%d is not understood, only 3 and 4" % [major, minor]
		return
	var version: int = major * 100 + minor
	if version != r_server.version:
		r_server.has_models = false
	r_server.version = version
	r_server.program = name.left(40)
	r_server.asked_usec = 0


func _read_models(r_server: Motive) -> void:
	if r_server.version == 0:
		return
	var skeletons: Dictionary[int, Skeleton] = {}
	var count: int = _bytes.read_count(4096)
	for _number: int in count:
		var type: int = _bytes.read_u32()
		var size: int = _bytes.read_u32() if r_server.version >= 401 else 0
		var end: int = _bytes.position() + size
		if type == 2:
			_read_skeleton(r_server.version, skeletons)
		elif size == 0:
			NatnetBytes.skip_model(_bytes, type, r_server.version)
		if size > 0:
			_bytes.seek(end)
		if _bytes.fault != "":
			return
	r_server.skeletons = skeletons
	r_server.has_models = true
	r_server.lacks_some = false


func _read_skeleton(p_version: int, r_skeletons: Dictionary[int, Skeleton]) -> void:
	var skeleton: Skeleton = Skeleton.new()
	skeleton.name = _bytes.read_text(256)
	var id: int = _bytes.read_u32()
	for _bone: int in _bytes.read_count(_MAX_BONES):
		var name: String = _bytes.read_text(256)
		var bone: int = _bytes.read_u32() & 0xFFFF
		skeleton.parents[bone] = _bytes.read_u32() & 0xFFFF
		skeleton.offsets[bone] = _bytes.read_vector()
		skeleton.joints[bone] = joint_of(name)
		NatnetBytes.skip_markers(_bytes, p_version)
		if _bytes.fault != "":
			return
	if r_skeletons.size() < _MAX_SKELETONS:
		r_skeletons[id] = skeleton


func _read_frame(p_server: Motive, r_samples: Array[StreamSample]) -> void:
	var counter: int = _bytes.read_u32()
	NatnetBytes.skip_before_skeletons(_bytes, p_server.version)
	var count: int = _bytes.read_count(256)
	var size: int = _bytes.read_u32() if p_server.version >= 401 else 0
	var end: int = _bytes.position() + size
	for _number: int in count:
		var id: int = _bytes.read_u32()
		p_server.lacks_some = p_server.lacks_some or not p_server.skeletons.has(id)
		var sample: StreamSample = _read_bones(p_server.skeletons.get(id))
		if _bytes.fault != "":
			return
		if sample != null:
			sample.person = str(id)
			sample.counter = counter
			r_samples.append(sample)
	if size > 0:
		_bytes.seek(end)
	NatnetBytes.skip_after_skeletons(_bytes, p_server.version)
	_bytes.skip(8)
	var time_s: float = _bytes.read_double()
	for sample: StreamSample in r_samples:
		if _bytes.fault == "" and time_s >= 0.0 and time_s < 1e9:
			sample.source_usec = roundi(time_s * 1e6)


## The pose of a skeleton's bones, or null.
func _read_bones(p_skeleton: Skeleton) -> StreamSample:
	var turns: Dictionary[int, Quaternion] = {}
	var places: Dictionary[int, Vector3] = {}
	for _bone: int in _bytes.read_count(_MAX_BONES):
		var bone: int = _bytes.read_u32() & 0xFFFF
		var place: Vector3 = _bytes.read_vector()
		var turn: Quaternion = _bytes.read_turn()
		# The mean error of markers, and whether it is tracked.
		_bytes.skip(6)
		# A comparison that NaN fails, too.
		if absf(turn.length() - 1.0) < 0.1 and place.length() < 1e4:
			turns[bone] = turn.normalized()
			places[bone] = place
	if p_skeleton == null or _bytes.fault != "":
		return null
	if _are_local(p_skeleton, places):
		_make_global(p_skeleton, turns, places)
	var builder: PoseBuilder = p_skeleton.builder
	builder.clear()
	for bone: int in turns:
		if p_skeleton.joints.get(bone, -1) >= 0:
			builder.set_turn(p_skeleton.joints[bone], turns[bone])
			builder.set_position(p_skeleton.joints[bone], places[bone])
	var sample: StreamSample = StreamSample.new()
	sample.name = p_skeleton.name
	sample.pose = builder.build()
	return sample if sample.pose != null else null


## Whether bones are where their description has them on the bone above: then all are on that.
static func _are_local(p_skeleton: Skeleton, p_places: Dictionary[int, Vector3]) -> bool:
	var same: int = 0
	var count: int = 0
	for bone: int in p_places:
		if p_places.has(p_skeleton.parents.get(bone, -1)):
			count += 1
			if p_places[bone].distance_to(p_skeleton.offsets[bone]) < _SAME_M:
				same += 1
	return 2 * same > count


static func _make_global(
	p_skeleton: Skeleton, r_turns: Dictionary[int, Quaternion], r_places: Dictionary[int, Vector3]
) -> void:
	var done: Dictionary[int, bool] = {}
	for _round: int in r_turns.size():
		var is_last: bool = true
		for bone: int in r_turns:
			var above: int = p_skeleton.parents.get(bone, -1)
			if done.has(bone):
				continue
			if r_turns.has(above) and above != bone:
				if not done.has(above):
					is_last = false
					continue
				r_places[bone] = r_places[above] + r_turns[above] * r_places[bone]
				r_turns[bone] = (r_turns[above] * r_turns[bone]).normalized()
			done[bone] = true
		if is_last:
			return

extends SceneTree
## Plays BVH files by the protocol of other people's suits and programs, so that anybody can try
## without them: [code]./run motion-sender[/code].
##
## Exit code 0; 2 with one line on the error output if the call is wrong or a file cannot be used.

const USAGE: String = """usage: ./run motion-sender --to KIND --bvh FILE[,FILE] [options]

  --to KIND         mvn, vmc, slime, rokoko, axis, axis-text, mocopi, natnet or webcam; perhaps
                    with :HOST:PORT behind it (127.0.0.1 and the kind's usual port)
  --bvh FILES       the motion, played in a loop; several people, one a file
  --people N        so many people, up to 32, who take turns with the files (0: one a file)
  --first N         number of the first of them, 0 to 255 (0)
  --name NAME       their name, where the kind has one (Dismount)
  --rate HZ         samples a second, 1 to 240 (60)
  --seconds S       ends after so long (never)
  --loss P          share of the datagrams that are left out, 0 to 1 (0)
  --duplicates P    share of them that are sent twice, 0 to 1 (0)
  --jitter MS       datagrams are late by up to so much, ms, and overtake each other (0)
  --seed N          of what is lost, doubled and late (1)
  --unit U, --up A  the file's unit and up axis, as in ./run bvh
  --types LIST      what MVN sends (02,12,13,23): 01 Euler pose, 02 quaternion pose, 03 points,
                    05 Unity3D, 12 meta data, 13 scale, 20 joint angles, 21 linear and 22 angular
                    kinematics, 23 trackers, 24 centre of mass, 25 time code"""
const DEFAULTS: Dictionary[String, String] = {
	"to": "",
	"bvh": "",
	"people": "0",
	"first": "0",
	"name": "Dismount",
	"rate": "60",
	"seconds": "0",
	"loss": "0",
	"duplicates": "0",
	"jitter": "0",
	"seed": "1",
	"unit": "",
	"up": "",
	"types": "02,12,13,23",
}
## Least and greatest value of the numbers.
const RANGES: Dictionary[String, Vector2] = {
	"people": Vector2(0, 32),
	"first": Vector2(0, 255),
	"rate": Vector2(1, 240),
	"seconds": Vector2(0, 1e9),
	"loss": Vector2(0, 1),
	"duplicates": Vector2(0, 1),
	"jitter": Vector2(0, 1000),
	"seed": Vector2(0, 1e9),
}
## Numbers without a fraction.
const WHOLE: PackedStringArray = ["people", "first"]
## Metres between people.
const APART_M: float = 1.2
## Seconds between people who play the same file.
const LATER_S: float = 0.7

## What writes each protocol.
static var _writers_of: Dictionary[String, GDScript] = {
	"mvn": MvnWriter,
	"vmc": VmcWriter,
	"slime": SlimeWriter,
	"rokoko": RokokoWriter,
	"axis": AxisWriter,
	"axis-text": AxisWriter,
	"mocopi": MocopiWriter,
	"natnet": NatnetWriter,
	"webcam": WebcamWriter,
}

var _options: Dictionary[String, String] = DEFAULTS.duplicate()
var _kind: String = ""
var _address: String = "127.0.0.1"
var _port: int = 0
var _types: PackedInt32Array = []
var _people: Array[BvhSource] = []
var _writers: Array[StreamWriter] = []
var _peers: Array[PacketPeerUDP] = []
var _late: Array[Array] = []
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func _initialize() -> void:
	if "--help" in OS.get_cmdline_user_args():
		print(USAGE)
		quit(0)
		return
	var fault: String = _read_options()
	if fault == "":
		fault = _open()
	if fault != "":
		printerr("motion-sender: " + fault)
		quit(2)
		return
	_play()
	quit(0)


func _read_options() -> String:
	var fault: String = SenderArguments.read(_options, RANGES, WHOLE, "motion-sender")
	if fault == "":
		fault = _read_receiver()
	return fault if fault != "" else _read_types()


func _read_receiver() -> String:
	var parts: PackedStringArray = _options["to"].split(":")
	_kind = parts[0]
	if not _writers_of.has(_kind) or parts.size() > 3:
		var kinds: String = ", ".join(_writers_of.keys())
		return "--to is %s and perhaps :HOST:PORT, found '%s'" % [kinds, _options["to"]]
	_port = SourceAddress.PORTS[_kind.trim_suffix("-text")]
	if parts.size() == 2 and parts[1].is_valid_int():
		parts = [_kind, _address, parts[1]]
	if parts.size() >= 2:
		_address = SourceAddress.resolve(parts[1])
		if _address == "":
			return "the host '%s' can't be found" % parts[1]
	if parts.size() == 3:
		_port = SourceAddress.port_of(parts[2])
		if _port == 0:
			return "a port is 1 to 65535, found '%s'" % parts[2]
	return ""


func _read_types() -> String:
	for text: String in _options["types"].split(",", false):
		if not text.is_valid_int() or not MvnWriter.TYPES.has(text.to_int()):
			return "there is no type '%s' to send; see ./run motion-sender --help" % text
		_types.append(text.to_int())
	return "--types names none" if _types.is_empty() else ""


func _open() -> String:
	var files: PackedStringArray = _options["bvh"].split(",", false)
	if files.is_empty():
		return "which motion? --bvh FILE"
	var count: int = _options["people"].to_int()
	if count == 0:
		count = files.size()
	if _kind == "natnet" and count > 1:
		return "natnet sends one person"
	var first: int = _options["first"].to_int()
	if first + count > 256:
		return "people have numbers up to 255"
	_random.seed = _options["seed"].to_int()
	for number: int in count:
		var source: BvhSource = BvhSource.new()
		@warning_ignore("integer_division")
		source.start_s = number / files.size() * LATER_S
		source.open(files[number % files.size()], _options["unit"], _options["up"])
		if source.error != "":
			return source.error
		_people.append(source)
		var name: String = _options["name"] + (" %d" % (number + 1) if count > 1 else "")
		_writers.append(_writer(source.get_body(), first + number, name))
		var fault: String = _open_peer()
		if fault != "":
			return fault
	print("sends %s to %s:%d: %d people" % [_kind, _address, _port, count])
	return ""


## A socket for each person, as from a suit each; MVN sends all from one.
func _open_peer() -> String:
	if _kind == "mvn" and not _peers.is_empty():
		_peers.append(_peers[0])
		return ""
	var peer: PacketPeerUDP = PacketPeerUDP.new()
	# Motive answers on its command port.
	var own: int = NatnetReader.COMMAND_PORT if _kind == "natnet" else 0
	if peer.bind(own, "0.0.0.0") != OK:
		return "UDP port %d is in use: is Motive here?" % own
	peer.set_broadcast_enabled(true)
	peer.set_dest_address(_address, _port)
	_peers.append(peer)
	return ""


func _writer(p_size: BodySize, p_number: int, p_name: String) -> StreamWriter:
	var writer: StreamWriter = _writers_of[_kind].new(p_size)
	writer.set_person(p_number, p_name)
	if writer is MvnWriter:
		(writer as MvnWriter).types = _types
	if writer is AxisWriter:
		(writer as AxisWriter).is_text = _kind == "axis-text"
	return writer


func _play() -> void:
	var rate: float = _options["rate"].to_float()
	var length: float = _options["seconds"].to_float()
	var begin: int = Time.get_ticks_usec()
	var unix: int = roundi(Time.get_unix_time_from_system() * 1e6)
	var number: int = 0
	while length <= 0.0 or number < length * rate:
		var due: int = begin + roundi(number * 1e6 / rate)
		while due > Time.get_ticks_usec():
			OS.delay_usec(clampi(due - Time.get_ticks_usec(), 1, 500))
			_post()
		for person: int in _people.size():
			_hear(person)
			var source: BvhSource = _people[person]
			var pose: PoseSample = source.pose_at(source.start_s + number / rate)
			pose.root.x += person * APART_M
			pose.time_usec = unix + roundi(number * 1e6 / rate)
			for datagram: PackedByteArray in _writers[person].write(pose):
				_send(person, datagram)
		_post()
		number += 1


## Answers what the receiver has sent, and goes on with whoever sent it.
func _hear(p_person: int) -> void:
	var peer: PacketPeerUDP = _peers[p_person]
	while peer.get_available_packet_count() > 0:
		var bytes: PackedByteArray = peer.get_packet()
		peer.set_dest_address(peer.get_packet_ip(), peer.get_packet_port())
		for answer: PackedByteArray in _writers[p_person].answer(bytes):
			peer.put_packet(answer)


func _send(p_person: int, p_datagram: PackedByteArray) -> void:
	for _copy: int in 2 if _random.randf() < _options["duplicates"].to_float() else 1:
		var late: float = _random.randf() * _options["jitter"].to_float() * 1000.0
		if _random.randf() >= _options["loss"].to_float():
			_late.append([Time.get_ticks_usec() + roundi(late), p_person, p_datagram])


## Sends what is due, in its order.
func _post() -> void:
	var now: int = Time.get_ticks_usec()
	var waiting: Array[Array] = []
	for parcel: Array in _late:
		if parcel[0] <= now:
			_peers[parcel[1]].put_packet(parcel[2])
		else:
			waiting.append(parcel)
	_late = waiting

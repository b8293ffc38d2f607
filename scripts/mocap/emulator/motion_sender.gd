extends SceneTree
## Plays BVH files by the protocol of other people's suits and programs, so that anybody can try
## without them: [code]./run motion-sender[/code].
##
## Exit code 0; 2 with one line on the error output if the call is wrong or a file cannot be used.

const USAGE: String = """usage: ./run motion-sender --to KIND --bvh FILE[,FILE] [options]

  --to KIND         vmc, slime, rokoko, axis, axis-text, mocopi, natnet or webcam; perhaps with
                    :HOST:PORT behind it (127.0.0.1 and the kind's usual port)
  --bvh FILES       the motion, played in a loop; several people, one a file
  --rate HZ         samples a second, 1 to 240 (60)
  --seconds S       ends after so long (never)
  --loss P          share of the datagrams that are left out, 0 to 1 (0)
  --duplicates P    share of them that are sent twice, 0 to 1 (0)
  --jitter MS       datagrams are late by up to so much, ms, and overtake each other (0)
  --seed N          of what is lost, doubled and late (1)
  --unit U, --up A  the file's unit and up axis, as in ./run bvh

  MVN's own stream: ./run mvn-sender"""
const DEFAULTS: Dictionary[String, String] = {
	"to": "",
	"bvh": "",
	"rate": "60",
	"seconds": "0",
	"loss": "0",
	"duplicates": "0",
	"jitter": "0",
	"seed": "1",
	"unit": "",
	"up": "",
}
## Least and greatest value of the numbers.
const RANGES: Dictionary[String, Vector2] = {
	"rate": Vector2(1, 240),
	"seconds": Vector2(0, 1e9),
	"loss": Vector2(0, 1),
	"duplicates": Vector2(0, 1),
	"jitter": Vector2(0, 1000),
	"seed": Vector2(0, 1e9),
}
const KINDS: PackedStringArray = [
	"vmc", "slime", "rokoko", "axis", "axis-text", "mocopi", "natnet", "webcam"
]
## Metres between people.
const APART_M: float = 1.2

var _options: Dictionary[String, String] = DEFAULTS.duplicate()
var _kind: String = ""
var _address: String = "127.0.0.1"
var _port: int = 0
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
	var fault: String = SenderArguments.read(_options, RANGES, [], "motion-sender")
	return fault if fault != "" else _read_receiver()


func _read_receiver() -> String:
	var parts: PackedStringArray = _options["to"].split(":")
	_kind = parts[0]
	if not KINDS.has(_kind) or parts.size() > 3:
		return "--to is %s and perhaps :HOST:PORT, found '%s'" % [", ".join(KINDS), _options["to"]]
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


func _open() -> String:
	var files: PackedStringArray = _options["bvh"].split(",", false)
	if files.is_empty():
		return "which motion? --bvh FILE"
	_random.seed = _options["seed"].to_int()
	for number: int in files.size():
		var source: BvhSource = BvhSource.new()
		source.open(files[number], _options["unit"], _options["up"])
		if source.error != "":
			return source.error
		var peer: PacketPeerUDP = PacketPeerUDP.new()
		# Motive answers on its command port.
		var own: int = NatnetReader.COMMAND_PORT if _kind == "natnet" else 0
		if peer.bind(own, "0.0.0.0") != OK:
			return "UDP port %d is in use: is Motive here?" % own
		peer.set_broadcast_enabled(true)
		peer.set_dest_address(_address, _port)
		_people.append(source)
		_writers.append(_writer(source.get_body(), number))
		_peers.append(peer)
	if _kind == "natnet" and files.size() > 1:
		return "natnet sends one person"
	print("sends %s to %s:%d: %d people" % [_kind, _address, _port, _people.size()])
	return ""


func _writer(p_size: BodySize, p_number: int) -> StreamWriter:
	match _kind:
		"vmc":
			return VmcWriter.new(p_size)
		"rokoko":
			var rokoko: RokokoWriter = RokokoWriter.new(p_size)
			rokoko.name = "Dismount %d" % (p_number + 1)
			return rokoko
		"mocopi":
			return MocopiWriter.new(p_size)
		"natnet":
			return NatnetWriter.new(p_size)
		"webcam":
			return WebcamWriter.new(p_size)
		"slime":
			var slime: SlimeWriter = SlimeWriter.new()
			slime.mac[5] = p_number + 1
			return slime
	var axis: AxisWriter = AxisWriter.new(p_size)
	axis.is_text = _kind == "axis-text"
	axis.avatar = p_number
	return axis


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
			var pose: PoseSample = _people[person].pose_at(number / rate)
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

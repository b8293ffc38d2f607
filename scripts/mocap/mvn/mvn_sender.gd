extends SceneTree
## Plays BVH files as MVN's network stream, so that anybody can try without a suit:
## [code]./run mvn-sender[/code].
##
## Exit code 0; 2 with one line on the error output if the call is wrong or a file cannot be used.

const USAGE: String = """usage: ./run mvn-sender --bvh FILE[,FILE...] [options]

  --bvh FILES       the motion, played in a loop; several people take turns with several files
  --host ADDRESS    whom to send to (127.0.0.1)
  --port PORT       UDP port there (9763)
  --rate HZ         samples a second, 1 to 240 (60)
  --types LIST      what to send (02,12,13,23): 01 Euler pose, 02 quaternion pose, 03 points,
                    05 Unity3D, 12 meta data, 13 scale, 20 joint angles, 21 linear and 22 angular
                    kinematics, 23 trackers, 24 centre of mass, 25 time code
  --characters N    people, 1 to 32 (1)
  --first N         number of the first character, 0 to 255 (0)
  --name NAME       their name (Dismount)
  --seconds S       ends after so long (never)
  --loss P          percent of the datagrams that are left out, 0 to 100 (0)
  --unit U, --up A  the file's unit and up axis, as in ./run bvh"""
const DEFAULTS: Dictionary[String, String] = {
	"bvh": "",
	"host": "127.0.0.1",
	"port": "%d" % SourceAddress.PORTS["mvn"],
	"rate": "60",
	"types": "02,12,13,23",
	"characters": "1",
	"first": "0",
	"name": "Dismount",
	"seconds": "0",
	"loss": "0",
	"unit": "",
	"up": "",
}
## Least and greatest value of the numbers.
const RANGES: Dictionary[String, Vector2] = {
	"port": Vector2(1, 65535),
	"rate": Vector2(1, 240),
	"characters": Vector2(1, 32),
	"first": Vector2(0, 255),
	"seconds": Vector2(0, 1e9),
	"loss": Vector2(0, 100),
}
## Numbers without a fraction.
const WHOLE: PackedStringArray = ["port", "characters", "first"]
## Types that change seldom are sent once a second.
const SELDOM: Array[int] = [12, 13]
## Metres between people.
const APART_M: float = 1.2

var _options: Dictionary[String, String] = DEFAULTS.duplicate()
var _types: PackedInt32Array = PackedInt32Array()
var _people: Array[BvhSource] = []
var _writers: Array[MvnWriter] = []
var _peer: PacketPeerUDP = PacketPeerUDP.new()


func _initialize() -> void:
	if "--help" in OS.get_cmdline_user_args():
		print(USAGE)
		quit(0)
		return
	var fault: String = _read_options()
	if fault == "":
		fault = _open()
	if fault != "":
		printerr("mvn-sender: " + fault)
		quit(2)
		return
	_play()
	quit(0)


func _read_options() -> String:
	var fault: String = SenderArguments.read(_options, RANGES, WHOLE, "mvn-sender")
	if fault != "":
		return fault
	for text: String in _options["types"].split(",", false):
		if not text.is_valid_int() or not MvnWriter.TYPES.has(text.to_int()):
			return "there is no type '%s' to send; see ./run mvn-sender --help" % text
		_types.append(text.to_int())
	if _types.is_empty():
		return "--types names none"
	if _number("first") + _number("characters") > 256:
		return "characters have numbers up to 255"
	return ""


func _number(p_name: String) -> int:
	return _options[p_name].to_int()


func _open() -> String:
	var files: PackedStringArray = _options["bvh"].split(",", false)
	if files.is_empty():
		return "which motion? --bvh FILE"
	for number: int in _number("characters"):
		var source: BvhSource = BvhSource.new()
		source.start_s = number * 0.7
		source.open(files[number % files.size()], _options["unit"], _options["up"])
		if source.error != "":
			return source.error
		var writer: MvnWriter = MvnWriter.new(source.get_body())
		writer.character = _number("first") + number
		writer.name = _options["name"]
		if _number("characters") > 1:
			writer.name += " %d" % (number + 1)
		_people.append(source)
		_writers.append(writer)
	var address: String = SourceAddress.resolve(_options["host"])
	if address == "" or _peer.set_dest_address(address, _number("port")) != OK:
		return "the host '%s' can't be found" % _options["host"]
	var parts: Array = [address, _number("port"), _people.size(), _options["rate"]]
	print("sends to %s:%d: %d people at %s Hz, types %s" % (parts + [_options["types"]]))
	return ""


func _play() -> void:
	var rate: float = _options["rate"].to_float()
	var length: float = _options["seconds"].to_float()
	var begin: int = Time.get_ticks_usec()
	var number: int = 0
	while length <= 0.0 or number < length * rate:
		var wait: int = begin + roundi(number * 1e6 / rate) - Time.get_ticks_usec()
		if wait > 0:
			OS.delay_usec(wait)
		_send_all(number, number / rate, number % ceili(rate) == 0)
		number += 1


func _send_all(p_number: int, p_time_s: float, p_with_seldom: bool) -> void:
	var loss: float = _options["loss"].to_float() / 100.0
	for person: int in _people.size():
		var source: BvhSource = _people[person]
		var pose: PoseSample = source.pose_at(source.start_s + p_time_s)
		pose.root.x += person * APART_M
		_writers[person].take(pose, p_time_s)
		for type: int in _types:
			if SELDOM.has(type) and not p_with_seldom:
				continue
			var sample: Dictionary = _writers[person].sample(type, p_number, roundi(p_time_s * 1e3))
			for datagram: PackedByteArray in MvnEncoder.encode(sample):
				if loss == 0.0 or randf() >= loss:
					_peer.put_packet(datagram)

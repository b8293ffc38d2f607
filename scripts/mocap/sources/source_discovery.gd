class_name SourceDiscovery
extends RefCounted
## What motion is being sent to this machine: listens on the usual ports of all protocols, only
## while it is asked to, and answers nobody.

## The ports that are listened on besides the usual one, by kind.
const FURTHER_PORTS: Dictionary[String, Array] = {
	"vmc": [39540],
	"axis": [7001, 7002, 7003, 7004],
}
## Greatest number of senders of a port that are listed.
const MAX_SENDERS: int = 8
## Greatest number of datagrams of a port that are read in a frame.
const MAX_DATAGRAMS: int = 512
## Silence after which a sender is no longer listed, s.
const GONE_S: float = 3.0

var _listeners: Array[Listener] = []


## One port.
class Listener:
	var kind: String = ""
	var port: int = 0
	## Why it can't be listened on, or an empty text.
	var fault: String = ""
	var peer: PacketPeerUDP = PacketPeerUDP.new()
	var reader: StreamReader = null
	## By sender: what was heard.
	var heard: Dictionary[String, Voice] = {}


## One sender.
class Voice:
	var is_known: bool = false
	var newest_s: float = 0.0
	## Of its datagrams.
	var rate: SampleRate = SampleRate.new()

	## What is to be read of it.
	func describe(p_sender: String) -> String:
		var detail: String = "from " + p_sender
		if rate.is_known:
			detail += ", %.0f datagrams/s" % rate.hz
		return detail + ("" if is_known else ", not understood")


## Begins to listen. Ports that this program uses itself are left out.
func start(p_own_ports: PackedInt32Array = PackedInt32Array()) -> void:
	stop()
	for kind: String in SourceAddress.PORTS:
		for port: int in ports_of(kind):
			if not p_own_ports.has(port):
				_listen(kind, port)


## The ports of a kind that are listened on, the usual one first.
static func ports_of(p_kind: String) -> PackedInt32Array:
	var ports: PackedInt32Array = [SourceAddress.PORTS[p_kind]]
	ports.append_array(PackedInt32Array(FURTHER_PORTS.get(p_kind, [])))
	return ports


## Ends it: all ports are free again.
func stop() -> void:
	for listener: Listener in _listeners:
		listener.peer.close()
	_listeners.clear()


## Whether it listens.
func is_listening() -> bool:
	return not _listeners.is_empty()


## Goes on, in the main thread, each frame, with the time, s.
func advance(p_now_s: float) -> void:
	for listener: Listener in _listeners:
		for _number: int in MAX_DATAGRAMS:
			if listener.fault != "" or listener.peer.get_available_packet_count() == 0:
				break
			var bytes: PackedByteArray = listener.peer.get_packet()
			var sender: String = listener.peer.get_packet_ip()
			_note(listener, bytes, sender, p_now_s)
		for sender: String in listener.heard.keys():
			if p_now_s - listener.heard[sender].newest_s > GONE_S:
				listener.heard.erase(sender)
			else:
				listener.heard[sender].rate.look(roundi(p_now_s * 1e6))


## What was heard: for each sender what to give [code]--source[/code] ("source"), and "name",
## "state" and "detail" as in [constant DeviceList.KEYS]. Body trackers of other plugins come last.
func list() -> Array[Dictionary]:
	var rows: Array[Dictionary] = []
	for listener: Listener in _listeners:
		var source: String = listener.kind
		if listener.port != SourceAddress.PORTS[listener.kind] and listener.kind != "natnet":
			source += ":%d" % listener.port
		if listener.kind == "webcam":
			source = "webcam:udp:%d" % listener.port
		if listener.fault != "":
			rows.append(_row(listener, "", "in use", listener.fault))
		for sender: String in listener.heard:
			var detail: String = listener.heard[sender].describe(sender)
			var named: String = source
			if listener.kind == "natnet":
				named += ":" + sender
			rows.append(_row(listener, named, "heard", detail))
	for name: String in TrackerSource.list_others():
		rows.append(
			{
				"source": "tracker:" + name,
				"name": "Body tracker " + name,
				"state": "there",
				"detail": "of a plugin or of OpenXR"
			}
		)
	return rows


func _listen(p_kind: String, p_port: int) -> void:
	var listener: Listener = Listener.new()
	listener.kind = p_kind
	listener.port = p_port
	listener.reader = MotionStreams.reader_of(p_kind)
	if listener.peer.bind(p_port, "0.0.0.0", StreamPort.ROOM) != OK:
		listener.fault = "another program has UDP port %d" % p_port
	elif p_kind == "natnet":
		StreamPort.join_group(listener.peer, NatnetReader.GROUP)
	_listeners.append(listener)


static func _note(
	r_listener: Listener, p_bytes: PackedByteArray, p_sender: String, p_now_s: float
) -> void:
	if not r_listener.heard.has(p_sender):
		if r_listener.heard.size() >= MAX_SENDERS:
			return
		r_listener.heard[p_sender] = Voice.new()
	var voice: Voice = r_listener.heard[p_sender]
	voice.rate.add(roundi(p_now_s * 1e6))
	voice.newest_s = p_now_s
	if not voice.is_known:
		voice.is_known = _knows(r_listener, p_bytes, p_sender)


## Whether a datagram is one of the port's protocol.
static func _knows(p_listener: Listener, p_bytes: PackedByteArray, p_sender: String) -> bool:
	match p_listener.kind:
		"mvn":
			return p_bytes.slice(0, 4).get_string_from_ascii() == "MXTP"
		"slime":
			var is_long: bool = p_bytes.size() >= 12 and p_bytes[0] == 0
			return is_long and p_bytes[3] == SlimeDevice.Packet.HANDSHAKE
	p_listener.reader.fault = ""
	p_listener.reader.read(p_bytes, p_sender + ":0")
	return p_listener.reader.fault == ""


static func _row(
	p_listener: Listener, p_source: String, p_state: String, p_detail: String
) -> Dictionary:
	var name: String = p_listener.reader.title() if p_listener.reader != null else "MVN"
	if p_listener.kind == "slime":
		name = "SlimeVR"
	return {
		"source": p_source,
		"name": "%s (UDP port %d)" % [name, p_listener.port],
		"state": p_state,
		"detail": p_detail,
	}

class_name VmcOut
extends RefCounted
## Sends the poses of this client's people to programs that receive the VMC protocol: the first
## one's to a port, the next one's to the port behind it, as that protocol has one person a port.

## Receiver: an IPv4 address, and the port of the first person.
var address: String = ""
var port: int = 0

var _peer: PacketPeerUDP = PacketPeerUDP.new()
var _writers: Dictionary[int, VmcWriter] = {}


## Takes HOST:PORT, HOST or a port alone, which is of this machine. Returns what is wrong, or an
## empty text.
func open(p_text: String) -> String:
	var host: String = p_text
	var usual: String = str(SourceAddress.PORTS["vmc"])
	var number: String = usual
	if p_text.is_valid_int():
		host = "127.0.0.1"
		number = p_text
	elif p_text.contains(":"):
		host = p_text.get_slice(":", 0)
		number = p_text.get_slice(":", 1)
	port = SourceAddress.port_of(number)
	if port == 0 or p_text.count(":") > 1:
		return "--vmc-out is HOST:PORT, such as 127.0.0.1:%s, found '%s'" % [usual, p_text.left(60)]
	address = SourceAddress.resolve(host)
	if address == "":
		return "--vmc-out: the host '%s' can't be found" % host.left(60)
	_peer.set_broadcast_enabled(true)
	Log.info("mocap", "sends poses as VMC to %s:%d" % [address, port])
	return ""


## Sends a pose of one of the people, who has the size that the source knows.
func send(p_person: int, p_pose: PoseSample, p_source: MotionSource) -> void:
	if port + p_person > 65535:
		return
	if not _writers.has(p_person):
		_writers[p_person] = VmcWriter.new(p_source.get_body())
	_peer.set_dest_address(address, port + p_person)
	for datagram: PackedByteArray in _writers[p_person].write(p_pose):
		_peer.put_packet(datagram)


## The size of one of the people has changed, or another one has come.
func forget(p_person: int) -> void:
	_writers.erase(p_person)

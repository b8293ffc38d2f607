extends TestCase
## A stream over a real socket of this machine: people come and go, ports are in use, rubbish is
## told.

const CLIP: String = "res://assets/motion/01_01.bvh"
const PATIENCE: int = 3000

var _stream: PoseStream = null
var _came: Array[MotionSource] = []
var _gone: Array[MotionSource] = []


func goes_by_clock() -> bool:
	return true


func before_each() -> void:
	_came.clear()
	_gone.clear()
	_stream = PoseStream.new(VmcReader.new())
	_stream.appeared.connect(func(one: MotionSource, _name: String) -> void: _came.append(one))
	_stream.vanished.connect(_gone.append)
	equal(_stream.open(0), "")


func after_each() -> void:
	_stream.close()


func test_somebody_comes_over_a_socket_and_goes() -> void:
	var peer: PacketPeerUDP = PacketPeerUDP.new()
	peer.set_dest_address("127.0.0.1", _stream.port.get_port())
	var clip: BvhSource = BvhSource.new()
	clip.open(CLIP)
	var writer: VmcWriter = VmcWriter.new(clip.get_body())
	var number: int = 0
	while _came.is_empty() and number < PATIENCE:
		var pose: PoseSample = clip.pose_at(number / 60.0)
		pose.time_usec = number * 16667
		for datagram: PackedByteArray in writer.write(pose):
			peer.put_packet(datagram)
		number += 1
		await process_frames(1)
		_stream.advance()
	equal(_came.size(), 1)
	var rows: Array[Dictionary] = _stream.list_devices()
	equal(rows.size(), 2)
	for row: Dictionary in rows:
		for key: String in DeviceList.KEYS:
			is_true(row[key] is String)
	contains(rows[1]["name"], "127.0.0.1")
	contains(_stream.describe(), "1 people")
	_stream.close()
	equal(_gone, _came)
	contains(_stream.describe(), "not open")


func test_a_port_in_use_is_reported() -> void:
	var other: PoseStream = PoseStream.new(VmcReader.new())
	var fault: String = other.open(_stream.port.get_port())
	contains(fault, "in use")
	contains(fault, str(_stream.port.get_port()))


func test_rubbish_is_counted_and_told() -> void:
	var peer: PacketPeerUDP = PacketPeerUDP.new()
	peer.set_dest_address("127.0.0.1", _stream.port.get_port())
	peer.put_packet("rubbish".to_ascii_buffer())
	await until(func() -> bool: return _stream.trouble() != "")
	contains(_stream.trouble(), "127.0.0.1")
	contains(_stream.trouble(), "OSC")
	contains(_stream.list_devices()[0]["detail"], "1 bad")
	equal(_came.size(), 0)
	_stream.look(Time.get_unix_time_from_system() + 60.0)
	equal(_stream.trouble(), "", "forgotten after a while")

extends TestCase
## Streams that a client opens: every kind opens at a free port and is told on the panel.


func goes_by_clock() -> bool:
	return true


func test_every_kind_opens_waits_and_closes() -> void:
	var streams: MotionStreams = MotionStreams.new()
	var number: int = 0
	for kind: String in ["vmc", "rokoko", "axis", "mocopi", "webcam:udp:1", "slime"]:
		var address: SourceAddress = SourceAddress.parse(kind)
		address.port = 0
		number += 1
		equal(streams.open(address, number), "", kind)
	is_true(streams.has_any())
	streams.advance()
	equal(streams.list_devices().size(), 6)
	equal(streams.list_ports().size(), 6)
	for text: String in ["VMC", "Rokoko", "Axis Studio", "mocopi", "Webcam", "SlimeVR"]:
		contains(streams.trouble(), text)
	contains(streams.open(SourceAddress.parse("slime"), 9), "once")
	contains(streams.open(SourceAddress.parse("xbus"), 9), "no network stream")
	streams.close()


func test_a_tcp_stream_waits_for_its_server() -> void:
	var server: TCPServer = TCPServer.new()
	equal(server.listen(0, "127.0.0.1"), OK)
	var address: SourceAddress = SourceAddress.parse(
		"axis:tcp:127.0.0.1:%d" % server.get_local_port()
	)
	var streams: MotionStreams = MotionStreams.new()
	var came: Array[MotionSource] = []
	streams.appeared.connect(
		func(one: MotionSource, _name: String, _number: int) -> void: came.append(one)
	)
	equal(streams.open(address, 1), "")
	var clip: BvhSource = BvhSource.new()
	clip.open("res://assets/motion/01_01.bvh")
	var writer: AxisWriter = AxisWriter.new(clip.get_body())
	var peer: StreamPeerTCP = null
	for step: int in 6000:
		if peer == null and server.is_connection_available():
			peer = server.take_connection()
		if peer != null:
			peer.poll()
			peer.put_data(writer.write(clip.pose_at(step / 60.0))[0])
		streams.advance()
		if not came.is_empty():
			break
		await process_frames(1)
	equal(came.size(), 1)
	streams.close()
	server.stop()

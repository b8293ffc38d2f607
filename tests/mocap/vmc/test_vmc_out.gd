extends TestCase
## Poses that this program sends as VMC, heard by a socket of this machine.

const CLIP: String = "res://assets/motion/01_01.bvh"


func goes_by_clock() -> bool:
	return true


func test_two_people_go_to_two_ports() -> void:
	var first: PacketPeerUDP = PacketPeerUDP.new()
	var second: PacketPeerUDP = PacketPeerUDP.new()
	var port: int = 0
	# Two ports side by side that are free.
	for start: int in range(21000, 21400, 2):
		if first.bind(start, "127.0.0.1") == OK and second.bind(start + 1, "127.0.0.1") == OK:
			port = start
			break
		first.close()
		second.close()
	var out: VmcOut = VmcOut.new()
	equal(out.open("127.0.0.1:%d" % port), "")
	var clip: BvhSource = BvhSource.new()
	clip.open(CLIP)
	var peers: Array[PacketPeerUDP] = [first, second]
	for person: int in 2:
		var reader: VmcReader = VmcReader.new()
		var samples: Array[StreamSample] = []
		for step: int in 2:
			var pose: PoseSample = clip.pose_at(1.0 + person + step)
			pose.time_usec = step * 1000000
			out.send(person, pose, clip)
		await until(
			func() -> bool:
				while peers[person].get_available_packet_count() > 0:
					samples.append_array(reader.read(peers[person].get_packet(), "x"))
				return samples.size() == 2
		)
		for step: int in mini(samples.size(), 2):
			var truth: PoseSample = clip.pose_at(1.0 + person + step)
			almost_equal(samples[step].pose.root, truth.root, 1e-4)
			for limb: int in Limbs.COUNT:
				almost_equal(samples[step].pose.orientation(limb), truth.orientation(limb), 1e-4)
	first.close()
	second.close()


func test_an_address_that_is_none_is_reported() -> void:
	for text: String in ["", "host:", "1.2.3.4:99999", "a:1:2", "127.0.0.1:x"]:
		contains(VmcOut.new().open(text), "--vmc-out")
	var out: VmcOut = VmcOut.new()
	equal(out.open("40000"), "")
	equal(out.address, "127.0.0.1")
	equal(out.port, 40000)

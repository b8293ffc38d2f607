extends TestCase
## What motion is being sent to this machine: heard on usual ports, of which some are in use.

const CLIP: String = "res://assets/motion/01_01.bvh"


func goes_by_clock() -> bool:
	return true


func test_what_is_sent_is_heard_and_named_as_an_option() -> void:
	var discovery: SourceDiscovery = SourceDiscovery.new()
	# All ports but two are somebody else's here, so that nothing on this machine disturbs.
	var others: PackedInt32Array = []
	for kind: String in SourceAddress.PORTS:
		for port: int in SourceDiscovery.ports_of(kind):
			if port != 12351 and port != 39540:
				others.append(port)
	discovery.start(others)
	if not _is_free(discovery):
		is_true(true, "another program has the ports")
		discovery.stop()
		return
	var clip: BvhSource = BvhSource.new()
	clip.open(CLIP)
	var pose: PoseSample = clip.pose_at(1.0)
	var peer: PacketPeerUDP = PacketPeerUDP.new()
	var found: Array[Dictionary] = []
	for step: int in 3000:
		pose.time_usec = step * 1000
		peer.set_dest_address("127.0.0.1", 12351)
		peer.put_packet(MocopiWriter.new().write(pose)[1])
		peer.set_dest_address("127.0.0.1", 39540)
		peer.put_packet("rubbish".to_ascii_buffer())
		await process_frames(1)
		discovery.advance(step / 60.0)
		found = discovery.list()
		if found.size() >= 2 and found[1]["detail"].contains("/s"):
			break
	equal(found.size(), 2)
	var by_source: Dictionary = {}
	for row: Dictionary in found:
		by_source[row["source"]] = row
		for key: String in DeviceList.KEYS:
			is_true(row[key] is String)
	# A datagram a step, a step each 60th of a second; some may wait for the next step.
	var rate: String = by_source["mocopi"]["detail"]
	contains(rate, "from 127.0.0.1, ")
	almost_equal(rate.get_slice(", ", 1).to_float(), 60.0, 6.0)
	is_false(by_source["mocopi"]["detail"].contains("not understood"))
	contains(by_source["vmc:39540"]["detail"], "not understood")
	discovery.advance(1000.0)
	equal(discovery.list().size(), 0, "gone after a while")
	discovery.stop()
	is_false(discovery.is_listening())


func test_a_port_in_use_is_told_and_all_are_free_afterwards() -> void:
	var discovery: SourceDiscovery = SourceDiscovery.new()
	var second: SourceDiscovery = SourceDiscovery.new()
	discovery.start()
	second.start()
	var states: PackedStringArray = []
	for row: Dictionary in second.list():
		states.append(row["state"])
	is_true(states.has("in use"))
	second.stop()
	discovery.stop()


static func _is_free(p_discovery: SourceDiscovery) -> bool:
	for row: Dictionary in p_discovery.list():
		if row["state"] == "in use":
			return false
	return true

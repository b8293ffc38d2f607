extends TestCase
## The program that plays motion files in place of other people's suits, as a process of its own.

const SCRIPT: String = "res://scripts/emulation/motion_sender.gd"
const CLIP: String = "res://assets/motion/01_01.bvh"


func test_wrong_calls_end_with_two_and_a_sentence() -> void:
	var calls: Dictionary[String, PackedStringArray] = {}
	calls["vmc, slime"] = PackedStringArray(["--to=vcm", "--bvh=" + CLIP])
	calls["--loss is 0 to 1"] = PackedStringArray(["--to=vmc", "--bvh=" + CLIP, "--loss=5"])
	calls["which motion"] = PackedStringArray(["--to=vmc"])
	for wanted: String in calls:
		var output: Array = []
		equal(OS.execute(OS.get_executable_path(), _arguments(calls[wanted]), output, true), 2)
		contains("".join(output), wanted)


func test_a_clip_is_heard_as_it_is() -> void:
	var peer: PacketPeerUDP = PacketPeerUDP.new()
	equal(peer.bind(0, "127.0.0.1", 1 << 20), OK)
	var call: PackedStringArray = ["--to=mocopi:127.0.0.1:%d" % peer.get_local_port()]
	call.append_array(["--bvh=" + CLIP, "--seconds=0.5", "--duplicates=1"])
	var output: Array = []
	equal(OS.execute(OS.get_executable_path(), _arguments(call), output, true), 0)
	contains("".join(output), "1 people")
	var clip: BvhSource = BvhSource.new()
	clip.open(CLIP)
	var reader: MocopiReader = MocopiReader.new()
	var counts: Dictionary[int, int] = {}
	while peer.get_available_packet_count() > 0:
		for sample: StreamSample in reader.read(peer.get_packet(), "x"):
			counts[sample.counter] = counts.get(sample.counter, 0) + 1
			var truth: PoseSample = clip.pose_at((sample.counter - 1) / 60.0)
			for limb: int in Limbs.COUNT:
				var came: Quaternion = sample.pose.orientation(limb)
				is_true(Rotations.between_deg(came, truth.orientation(limb)) < 0.01)
	equal(counts.size(), 30)
	equal(counts.values().min(), 2, "each comes twice")
	peer.close()


static func _arguments(p_options: PackedStringArray) -> PackedStringArray:
	var project: String = ProjectSettings.globalize_path("res://")
	var arguments: PackedStringArray = ["--headless", "--path", project, "-s", SCRIPT, "--"]
	return arguments + p_options

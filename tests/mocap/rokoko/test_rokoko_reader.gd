extends TestCase
## Rokoko Studio's JSON. The T-pose is that of Rokoko's plugin for Blender; the joints' axes that
## Godot's own Rokoko plugin (GodotXRRokokoTracker) makes of the same rotations agree with it.

const CLIP: String = "res://assets/motion/01_01.bvh"
## Studio's rotation (w, x, y, z) of a bone in its T-pose, and what GodotXRRokokoTracker turns it by
## (x, y, z, w) to get Godot's humanoid axes, with Z mirrored.
const ROLLS: Dictionary[String, Array] = {
	"hip": [0.0, 1.0, 0.0, 0.0],
	"spine": [1.0, 0.0, 0.0, 0.0],
	"head": [1.0, 0.0, 0.0, 0.0],
	"leftShoulder": [-0.7071068, 0.0, 0.7071068, 0.0],
	"leftUpperArm": [1.0, 0.0, 0.0, 0.0],
	"rightLowerArm": [0.7071068, 0.0, 0.7071068, 0.0],
	"leftUpLeg": [0.7071068, 0.0, -0.7071068, 0.0],
	"rightLeg": [0.7071068, 0.0, -0.7071068, 0.0],
	"leftFoot": [0.0, 0.0, 1.0, 0.0],
	"rightToe": [1.0, 0.0, 0.0, 0.0],
}


func test_the_t_pose_is_that_of_two_other_plugins() -> void:
	for bone: String in ROLLS:
		var rest: Array = RokokoReader.REST[bone]
		var roll: Array = ROLLS[bone]
		var mirrored: Quaternion = Quaternion(rest[1], rest[2], -rest[3], -rest[0]).normalized()
		mirrored *= Quaternion(roll[0], roll[1], roll[2], roll[3]).normalized()
		var joint: int = RokokoReader.JOINTS[bone]
		var limb: int = HumanoidAxes.JOINTS.find(joint)
		var name: StringName = HumanoidAxes.OTHERS.get(joint, &"")
		var axes: Quaternion = HumanoidAxes.of_bone(Limbs.BONES[limb] if limb >= 0 else name)
		# There people face -Z.
		almost_equal(mirrored, Quaternion(Vector3.UP, PI) * axes, 1e-4, bone)


func test_a_clip_arrives_as_it_is_plain_and_packed() -> void:
	var clip: BvhSource = _clip()
	var line: LossyLine = LossyLine.new()
	line.loss = 0.0
	line.twice = 0.0
	line.jitter_usec = 0
	var stream: PoseStream = PoseStream.new(RokokoReader.new())
	var person: StreamPerson = line.run(clip, RokokoWriter.new(clip.get_body()), stream, 3.0)
	is_true(line.worst_deg() < 0.01, "%f deg" % line.worst_deg())
	is_true(line.worst_root < 0.001, "%f m" % line.worst_root)
	almost_equal(person.get_hip_height(), clip.get_hip_height(), 0.001)
	equal(person.get_name(), "Dismount")


func test_loss_and_duplicates_are_hardly_seen() -> void:
	var clip: BvhSource = _clip()
	var line: LossyLine = LossyLine.new(8)
	var stream: PoseStream = PoseStream.new(RokokoReader.new())
	var person: StreamPerson = line.run(clip, RokokoWriter.new(clip.get_body()), stream, 3.5)
	is_true(line.errors.percentile(0.95) < 0.1, "p95 %f deg" % line.errors.percentile(0.95))
	is_true(person.stats()["twice"] > 10)


func test_what_is_none_is_reported() -> void:
	var reader: RokokoReader = RokokoReader.new()
	var cases: Dictionary[String, String] = {
		"no JSON": "{",
		"no object": "[1]",
		"exponent": '{"version":"3,0","scene":{"timestamp":1e999}}',
		"JSON v3": '{"version":2,"actors":[]}',
		"actor is no object": '{"version":"3,0","scene":{"timestamp":1,"actors":[7]}}',
		"has no rotation":
		'{"version":"3","scene":{"timestamp":1,"actors":[{"body":{"hip":{"rotation":{"x":1}}}}]}}',
	}
	for wanted: String in cases:
		reader.fault = ""
		equal(reader.read(cases[wanted].to_utf8_buffer(), "x").size(), 0, wanted)
		contains(reader.fault, wanted)
	var deep: PackedByteArray = "[".repeat(60000).to_ascii_buffer()
	equal(reader.read(deep, "x").size(), 0)
	var pose: PoseSample = _clip().pose_at(1.0)
	equal(LossyLine.fuzz(reader, RokokoWriter.new().write(pose), 400), "")


func test_a_name_in_utf_8_is_kept_and_one_that_is_none_is_not() -> void:
	var reader: RokokoReader = RokokoReader.new()
	var writer: RokokoWriter = RokokoWriter.new()
	writer.name = "Zoë"
	var bytes: PackedByteArray = writer.write(_clip().pose_at(1.0))[0]
	equal(reader.read(bytes, "x")[0].name, "Zoë")
	bytes[bytes.find(0xC3)] = 0xFF
	equal(reader.read(bytes, "x")[0].name, "")


func _clip() -> BvhSource:
	var clip: BvhSource = BvhSource.new()
	clip.open(CLIP)
	return clip

extends TestCase
## Frames before and after a motion from which a body would be flung are left out; others are not.

const People: GDScript = preload("res://tests/mocap/people_samples.gd")
## Where the motion takes place, cm: 1.6 m from where the rest pose stands.
const PLACE: Vector3 = Vector3(160.0, 98.0, 0.0)


func test_rest_poses_before_the_motion_are_left_out() -> void:
	for count: int in [1, 2, 7, 60]:
		var frames: Array[Dictionary] = _still(count)
		frames.append_array(_walk(120))
		var rig: BvhRig = _rig(frames)
		equal(BvhTrim.leading(rig), count)
		equal(BvhTrim.trailing(rig), 0)


func test_rest_poses_after_the_motion_are_left_out() -> void:
	for count: int in [1, 2, 7, 60]:
		var frames: Array[Dictionary] = _walk(120)
		frames.append_array(_still(count))
		var rig: BvhRig = _rig(frames)
		equal(BvhTrim.leading(rig), 0)
		equal(BvhTrim.trailing(rig), count)


func test_a_jump_over_several_frames() -> void:
	var frames: Array[Dictionary] = _still(10)
	for step: int in range(1, 4):
		frames.append({"root": Vector3(0.0, 100.0, 0.0).lerp(PLACE, step / 4.0)})
	frames.append_array(_walk(120))
	equal(BvhTrim.leading(_rig(frames)), 13)


func test_a_limb_that_jumps() -> void:
	var frames: Array[Dictionary] = _still(5)
	for step: int in 60:
		frames.append({"LeftUpperArm": Quaternion(Vector3.BACK, -1.2 + 0.01 * step)})
	equal(BvhTrim.leading(_rig(frames)), 5)


func test_the_hips_never_jump_in_what_is_played() -> void:
	var frames: Array[Dictionary] = _still(20)
	frames.append_array(_walk(180))
	frames.append_array(_still(20))
	var person: People.Person = People.Person.new()
	person.frames = frames
	var source: BvhSource = BvhSource.new()
	source.use(People.make(person))
	equal(source.error, "")
	almost_equal(source.get_period(), 179.0 / 60.0 - BvhSource.BLEND_S, 1e-4)
	var before: PoseSample = source.pose_at(0.0)
	# The seam brings the walker back 2.7 m in half a second.
	for step: int in int(source.get_period() * 60.0):
		var sample: PoseSample = source.pose_at(step / 60.0)
		is_true(sample.root.distance_to(before.root) < 0.12, "frame %d" % step)
		before = sample
	contains("\n".join(source.notes), "begins with another pose or place, not played")
	contains("\n".join(source.notes), "ends with another pose or place, not played")


func test_motion_is_played_from_its_beginning() -> void:
	equal(BvhTrim.leading(_rig(_walk(120))), 0, "walking at once")
	equal(BvhTrim.leading(_rig(_walk(120, 13.0))), 0, "running at 8 m/s at once")
	var frames: Array[Dictionary] = _still(30)
	for step: int in 60:
		var speed: float = minf(step / 20.0, 1.0)
		var place: Vector3 = Vector3(0.0, 100.0, 2.0 * speed * step)
		frames.append({"root": place, "LeftUpperArm": Quaternion(Vector3.BACK, -0.02 * step)})
	equal(BvhTrim.leading(_rig(frames)), 0, "a T-pose from which the person walks")
	equal(BvhTrim.trailing(_rig(frames)), 0)
	equal(BvhTrim.leading(_rig(_still(90))), 0, "somebody who stands")


func test_short_clips() -> void:
	for count: int in [1, 2, 3, 4, 5]:
		var rig: BvhRig = _rig(_still(count))
		equal(BvhTrim.leading(rig) + BvhTrim.trailing(rig), 0)


## Frames of the rest pose.
func _still(p_count: int) -> Array[Dictionary]:
	var frames: Array[Dictionary] = []
	for _frame: int in p_count:
		frames.append({"root": Vector3(0.0, 100.0, 0.0)})
	return frames


## Frames of somebody who walks elsewhere, cm a frame.
func _walk(p_count: int, p_speed: float = 1.5) -> Array[Dictionary]:
	var frames: Array[Dictionary] = []
	for frame: int in p_count:
		var swing: Quaternion = Quaternion(Vector3.RIGHT, 0.5 * sin(frame * 0.1))
		var place: Vector3 = PLACE + Vector3(0.0, 0.0, p_speed * frame)
		frames.append({"root": place, "LeftUpperArm": swing, "RightUpperLeg": swing})
	return frames


func _rig(p_frames: Array[Dictionary]) -> BvhRig:
	var person: People.Person = People.Person.new()
	person.frames = p_frames
	var rig: BvhRig = BvhRig.from_clip(People.make(person))
	equal(rig.error, "")
	return rig

extends TestCase
## A person's motion coded tick by tick.


func test_a_motion_is_read_back_within_its_error() -> void:
	for error: float in [0.1, 0.5]:
		var stream: PersonStream = PersonStream.new()
		is_true(stream.setup(PackedInt32Array(Limbs.PARENTS), PersonStream.resolution_for(error)))
		for tick: int in 60:
			var pose: PackedFloat32Array = _wave(tick)
			equal(stream.push(Vector3(0.01 * tick, 1.0, 0.0), pose), tick)
			is_true(WireClip.worst_angle(pose, stream.restore(tick)) <= error)
		var whole: PackedByteArray = stream.encode(50, -1, -1)
		var changes: PackedByteArray = stream.encode(50, 48, 46)
		is_true(stream.decode(whole, 50, -1, -1))
		is_true(stream.decode(stream.encode(50, 44, -1), 50, 44, -1))
		is_true(stream.decode(changes, 50, 48, 46))
		is_true(changes.size() < whole.size())
		is_false(stream.decode(changes.slice(0, changes.size() - 1), 50, 48, 46))
		is_false(stream.decode(changes, 50, 47, 46))


func test_a_stream_refuses_what_makes_no_sense() -> void:
	var stream: PersonStream = PersonStream.new()
	equal(stream.push(Vector3.ZERO, PackedFloat32Array()), -1)
	is_false(stream.setup(PackedInt32Array(), 2600))
	is_false(stream.setup(PackedInt32Array([-1, 1]), 2600))
	is_false(stream.setup(PackedInt32Array([0]), 2600))
	is_true(stream.setup(PackedInt32Array([-1]), 2600))
	equal(stream.push(Vector3.ZERO, PackedFloat32Array([0.0, 0.0, 0.0, NAN])), -1)
	equal(stream.push(Vector3(NAN, 0.0, 0.0), PackedFloat32Array([0.0, 0.0, 0.0, 1.0])), -1)
	equal(stream.push(Vector3.ZERO, PackedFloat32Array([0.0, 0.0, 0.0, 1.0])), 0)
	equal(stream.encode(1, -1, -1).size(), 0)
	is_false(stream.decode(PackedByteArray(), 0, -1, -1))
	equal(stream.restore(7).size(), 0)


func _wave(p_tick: int) -> PackedFloat32Array:
	var pose: PackedFloat32Array = PackedFloat32Array()
	for limb: int in Limbs.COUNT:
		var turn: Quaternion = Quaternion(Vector3.RIGHT, sin(0.05 * p_tick + limb))
		pose.append_array(PackedFloat32Array([turn.x, turn.y, turn.z, turn.w]))
	return pose

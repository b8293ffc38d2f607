extends TestCase
## Codings of single poses, and a person's motion coded tick by tick.

const _ALL: Array[PoseCodec.Coding] = [
	PoseCodec.FLOATS, PoseCodec.THESIS_12, PoseCodec.THESIS_4, PoseCodec.SMALLEST_3
]


func test_every_coding_gives_the_pose_back() -> void:
	# Degrees: what each coding may be off by.
	var limits: Array[float] = [0.001, 0.1, 0.5, 0.01]
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 1
	for coding: PoseCodec.Coding in _ALL:
		var worst: float = 0.0
		for round: int in 100:
			var pose: PackedFloat32Array = _draw(random, Limbs.COUNT)
			var found: PackedFloat32Array = PoseCodec.decode(PoseCodec.encode(pose, coding), coding)
			equal(found.size(), pose.size())
			if found.size() != pose.size():
				return
			worst = maxf(worst, WireClip.worst_angle(pose, found))
		is_true(worst <= limits[coding], "coding %d is off by %f degrees" % [coding, worst])


func test_sizes() -> void:
	var pose: PackedFloat32Array = _draw(RandomNumberGenerator.new(), Limbs.COUNT)
	equal(PoseCodec.encode(pose, PoseCodec.FLOATS).size(), 256)
	equal(PoseCodec.encode(pose, PoseCodec.THESIS_12).size(), 192)
	equal(PoseCodec.encode(pose, PoseCodec.THESIS_4).size(), 64)
	equal(PoseCodec.encode(pose, PoseCodec.SMALLEST_3).size(), 94)
	equal(PoseCodec.encode(pose, PoseCodec.SMALLEST_3, 10).size(), 64)


func test_what_is_no_pose_is_refused() -> void:
	for coding: PoseCodec.Coding in _ALL:
		for bad: float in [NAN, INF, -INF, 3.0]:
			var pose: PackedFloat32Array = _draw(RandomNumberGenerator.new(), 4)
			pose[6] = bad
			equal(PoseCodec.encode(pose, coding).size(), 0)
		equal(PoseCodec.encode(PackedFloat32Array(), coding).size(), 0)
		equal(PoseCodec.encode(PackedFloat32Array([0.0, 0.0, 1.0]), coding).size(), 0)
		equal(PoseCodec.encode(_draw(RandomNumberGenerator.new(), 33), coding).size(), 0)
		equal(PoseCodec.decode(PackedByteArray(), coding).size(), 0)
		equal(PoseCodec.decode(PackedByteArray([1]), coding).size(), 0)
	var rotation: PackedFloat32Array = [0.0, 0.0, 0.0, 1.0]
	for bits: int in [-1, 0, 3, 17, 1000000]:
		equal(PoseCodec.encode(rotation, PoseCodec.SMALLEST_3, bits).size(), 0)


func test_any_bytes_give_unit_quaternions_or_nothing() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 2
	var good: int = 0
	for round: int in 4000:
		var bytes: PackedByteArray = PackedByteArray()
		for _i: int in random.randi_range(1, 64):
			bytes.append(random.randi_range(0, 255))
		var found: PackedFloat32Array = PoseCodec.decode(bytes, _ALL[round % 4])
		for limb: int in found.size() / 4:
			good += 1
			var norm: float = WireClip.rotation_of(found, limb).length()
			if not (absf(norm - 1.0) < 1e-4):
				fail("a quaternion of norm %f" % norm)
	is_true(good > 100)


func test_a_motion_is_read_back_within_its_error() -> void:
	for error: float in [0.1, 0.5]:
		var stream: PersonStream = PersonStream.new()
		is_true(stream.setup(PackedInt32Array(Limbs.PARENTS), PersonStream.resolution_for(error)))
		for tick: int in 60:
			var pose: PackedFloat32Array = _wave(tick)
			equal(stream.push(Vector3(0.01 * tick, 1.0, 0.0), pose), tick)
			is_true(WireClip.worst_angle(pose, stream.restore(tick)) <= error)
			is_true(stream.restore_root(tick).distance_to(Vector3(0.01 * tick, 1.0, 0.0)) < 0.0009)
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


func _draw(p_random: RandomNumberGenerator, p_limbs: int) -> PackedFloat32Array:
	var pose: PackedFloat32Array = PackedFloat32Array()
	for _limb: int in p_limbs:
		var values: Vector4 = Vector4(
			p_random.randfn(), p_random.randfn(), p_random.randfn(), p_random.randfn()
		)
		values = values.normalized()
		pose.append_array(PackedFloat32Array([values.x, values.y, values.z, values.w]))
	return pose


func _wave(p_tick: int) -> PackedFloat32Array:
	var pose: PackedFloat32Array = PackedFloat32Array()
	for limb: int in Limbs.COUNT:
		var turn: Quaternion = Quaternion(Vector3.RIGHT, sin(0.05 * p_tick + limb))
		pose.append_array(PackedFloat32Array([turn.x, turn.y, turn.z, turn.w]))
	return pose

extends TestCase
## What sources say means the same in Godot's frame.

const NORTH: Vector3 = Vector3.BACK
const WEST: Vector3 = Vector3.RIGHT

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 3


func test_north_west_and_up() -> void:
	almost_equal(SourceFrames.vector(Vector3(1, 0, 0)), NORTH)
	almost_equal(SourceFrames.vector(Vector3(0, 1, 0)), WEST)
	almost_equal(SourceFrames.vector(Vector3(0, 0, 1)), Vector3.UP)
	var ned: SourceFrames.Frame = SourceFrames.Frame.XSENS_NED
	almost_equal(SourceFrames.vector(Vector3(1, 0, 0), ned), NORTH)
	almost_equal(SourceFrames.vector(Vector3(0, 1, 0), ned), -WEST)
	almost_equal(SourceFrames.vector(Vector3(0, 0, 1), ned), Vector3.DOWN)
	var enu: SourceFrames.Frame = SourceFrames.Frame.XSENS_ENU
	almost_equal(SourceFrames.vector(Vector3(1, 0, 0), enu), -WEST)
	almost_equal(SourceFrames.vector(Vector3(0, 1, 0), enu), NORTH)
	almost_equal(SourceFrames.vector(Vector3(0, 0, 1), enu), Vector3.UP)


func test_axes_of_motion_files_are_turned_up() -> void:
	var ups: Dictionary[SourceFrames.Frame, Vector3] = {
		SourceFrames.Frame.BVH_Z_UP: Vector3.BACK,
		SourceFrames.Frame.BVH_X_UP: Vector3.RIGHT,
		SourceFrames.Frame.BVH_Y_DOWN: Vector3.DOWN,
		SourceFrames.Frame.BVH_Z_DOWN: Vector3.FORWARD,
		SourceFrames.Frame.BVH_X_DOWN: Vector3.LEFT,
	}
	for frame: SourceFrames.Frame in ups:
		almost_equal(SourceFrames.vector(ups[frame], frame), Vector3.UP)
		var x: Vector3 = SourceFrames.vector(Vector3.RIGHT, frame)
		var y: Vector3 = SourceFrames.vector(Vector3.UP, frame)
		almost_equal(x.cross(y), SourceFrames.vector(Vector3.BACK, frame), 1e-6, "no mirror")
		var turn: Quaternion = Quaternion(Vector3(0.48, 0.6, 0.64), 1.1)
		var turned: Quaternion = SourceFrames.rotation(turn.w, turn.x, turn.y, turn.z, frame)
		var some: Vector3 = Vector3(0.3, -0.8, 0.5)
		almost_equal(
			turned * SourceFrames.vector(some, frame), SourceFrames.vector(turn * some, frame), 1e-5
		)


func test_a_turned_sensor_sees_the_same_in_all_of_xsens_frames() -> void:
	# How a vector in the sensor's axes comes out in the world, by each frame's own matrix.
	for round: int in 200:
		var turned: Quaternion = _any_rotation()
		var own: Vector3 = Vector3(_random.randfn(), _random.randfn(), _random.randfn())
		var world: Vector3 = turned * own
		var wanted: Vector3 = SourceFrames.vector(world)
		for frame: int in [0, 1, 2]:
			var told: Quaternion = _reference(frame) * turned
			var got: Quaternion = SourceFrames.rotation(told.w, told.x, told.y, told.z, frame)
			almost_equal(got * SourceFrames.sensor_vector(own), wanted, 1e-5, "frame %d" % frame)
			almost_equal(SourceFrames.vector(_reference(frame) * world, frame), wanted, 1e-5)


func test_mvn_and_unity_agree_with_the_suit() -> void:
	# A right arm raised to the front by a quarter: in Z up about Y by -90 degrees.
	var raised: Quaternion = Quaternion(Vector3(0, 1, 0), -PI / 2.0)
	var wanted: Quaternion = SourceFrames.rotation(raised.w, raised.x, raised.y, raised.z)
	almost_equal(wanted * Vector3.DOWN, Vector3.BACK, 1e-6, "a hanging arm points ahead")
	var euler: Quaternion = SourceFrames.rotation_from_euler(Vector3(-90, 0, 0))
	var y_up: SourceFrames.Frame = SourceFrames.Frame.MVN_Y_UP
	almost_equal(SourceFrames.rotation(euler.w, euler.x, euler.y, euler.z, y_up), wanted, 1e-6)
	# Unity: left-handed with X to the right; the same motion turns about X by -90 there too.
	var unity: Quaternion = Quaternion(Vector3.RIGHT, -PI / 2.0)
	var frame: SourceFrames.Frame = SourceFrames.Frame.MVN_UNITY
	almost_equal(SourceFrames.rotation(unity.w, unity.x, unity.y, unity.z, frame), wanted, 1e-6)
	# A turn to the left: left-handed frames count it the other way round.
	var left: Quaternion = Quaternion(Vector3.UP, -0.5)
	var turned: Quaternion = SourceFrames.rotation(left.w, left.x, left.y, left.z, frame)
	almost_equal(turned, Quaternion(Vector3.UP, 0.5), 1e-6)
	almost_equal(SourceFrames.position(Vector3(1, 2, 3), frame), Vector3(-1, 2, 3))
	almost_equal(SourceFrames.position(Vector3(100, 200, 300), y_up), Vector3(1, 2, 3))
	almost_equal(SourceFrames.position(Vector3(3, 1, 2)), Vector3(1, 2, 3))


func test_arrays_are_what_single_values_are() -> void:
	for frame: int in SourceFrames.Frame.size():
		var told: PackedFloat32Array = PackedFloat32Array()
		for part: int in 40:
			told.append(_random.randfn())
		var got: PackedFloat32Array = SourceFrames.rotations(told, frame)
		equal(got.size(), 40)
		for at: int in range(0, 40, 4):
			var single: Quaternion = SourceFrames.rotation(
				told[at], told[at + 1], told[at + 2], told[at + 3], frame
			)
			var many: Quaternion = Quaternion(got[at], got[at + 1], got[at + 2], got[at + 3])
			equal(many, single)
	equal(SourceFrames.rotations(PackedFloat32Array([1, 0, 0])).size(), 0)
	var places: PackedVector3Array = SourceFrames.positions([Vector3(1, 2, 3), Vector3(4, 5, 6)])
	equal(places, PackedVector3Array([Vector3(2, 3, 1), Vector3(5, 6, 4)]))
	equal(SourceFrames.sensor_vectors(PackedVector3Array([Vector3(1, 2, 3)]))[0], Vector3(2, 3, 1))


func test_euler_angles_turn_about_x_first() -> void:
	var got: Quaternion = SourceFrames.rotation_from_euler(Vector3(90, 0, 90))
	almost_equal(got * Vector3.UP, Vector3.BACK, 1e-6, "Y goes to Z about X, and stays")
	almost_equal(got * Vector3.RIGHT, Vector3.UP, 1e-6)


func _any_rotation() -> Quaternion:
	var parts: Array[float] = []
	for part: int in 4:
		parts.append(_random.randfn())
	return Quaternion(parts[0], parts[1], parts[2], parts[3]).normalized()


## From north-west-up to each of Xsens' frames.
func _reference(p_frame: int) -> Quaternion:
	if p_frame == SourceFrames.Frame.XSENS_NED:
		return Quaternion(Vector3.RIGHT, PI)
	if p_frame == SourceFrames.Frame.XSENS_ENU:
		return Quaternion(Vector3.BACK, PI / 2.0)
	return Quaternion.IDENTITY

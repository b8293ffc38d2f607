extends TestCase
## Sizes, inertia and faults of a limb's shape.

const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")
## Points of the numerical integration along each edge.
const GRID: int = 60

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 1


func test_shapes_have_the_sizes() -> void:
	var pill: RagdollLimb = _pill(0.08, 0.3)
	var capsule: CapsuleShape3D = RagdollBuilder.make_shape(pill)
	almost_equal(capsule.radius, 0.08)
	almost_equal(capsule.height, 0.46)
	var box: RagdollLimb = _box(Vector3(0.1, 0.2, 0.3))
	equal((RagdollBuilder.make_shape(box) as BoxShape3D).size, Vector3(0.1, 0.2, 0.3))


func test_inertia_against_integration() -> void:
	for _round: int in 4:
		_check_inertia(_pill(_random.randf_range(0.02, 0.15), _random.randf_range(0.0, 0.5)))
		var sizes: Vector3 = NetSamples.vector(_random, 0.4).abs() + Vector3.ONE * 0.02
		_check_inertia(_box(sizes))


func test_known_inertia() -> void:
	# A ball: 2/5 m r^2. A cube: 1/6 m a^2.
	almost_equal(_pill(0.5, 0.0).get_inertia(10.0), Vector3.ONE * 1.0, 1e-5)
	almost_equal(_box(Vector3.ONE).get_inertia(6.0), Vector3.ONE, 1e-5)
	# A long thin rod: 1/12 m l^2 across, almost nothing along.
	var rod: Vector3 = _pill(0.001, 2.0).get_inertia(3.0)
	almost_equal(rod.x, 1.0, 0.01)
	almost_equal(rod.y, 0.0, 1e-4)


func test_faults() -> void:
	var cases: Array[Array] = [
		["bone", &"", "names no bone"],
		["position", Vector3(NAN, 0, 0), "Head has a position that is not finite"],
		["anchor", Vector3(0, INF, 0), "not finite"],
		["orientation", Quaternion(0, 0, 0, 0.5), "not a rotation"],
		["orientation", Quaternion(0, 0, NAN, 1), "not finite"],
		["mass_fraction", 0.0, "Head's mass_fraction is 0.0"],
		["mass_fraction", 1.5, "mass_fraction"],
		["mass_fraction", NAN, "mass_fraction"],
		["radius", 0.0, "radius or length"],
		["radius", NAN, "radius or length"],
		["length", -0.1, "radius or length"],
		["length", INF, "radius or length"],
		["group", &"", "Head is in no strength group"],
		["rest_orientation", Quaternion(1, 1, 0, 0), "rest_orientation is not a rotation"],
		["reset_orientation", Quaternion(NAN, 0, 0, 1), "reset_orientation is not finite"],
		["max_torque", -1.0, "max_torque is -1.0"],
		["max_torque", NAN, "max_torque"],
		["contact_radius", NAN, "contact_radius"],
		["contact_points", PackedVector3Array([Vector3(0, NAN, 0)]), "contact point"],
		["min_angles", Vector3(1, 0, 0), "X angles"],
		["max_angles", Vector3(0, 0, NAN), "Z angles"],
	]
	equal(_pill(0.1, 0.1).find_fault(), "")
	for case: Array in cases:
		var limb: RagdollLimb = _pill(0.1, 0.1)
		if case[0] == "min_angles":
			limb.max_angles = Vector3.ZERO
		limb.set(case[0], case[1])
		contains(limb.find_fault(), case[2], str(case))
	equal(_box(Vector3.ONE).find_fault(), "")
	for size: Vector3 in [Vector3.ZERO, Vector3(1, -1, 1), Vector3(1, 1, NAN), Vector3(INF, 1, 1)]:
		contains(_box(size).find_fault(), "size", str(size))


func test_values_of_a_wrong_type_change_nothing() -> void:
	var limb: RagdollLimb = _pill(0.1, 0.2)
	for name: String in ["radius", "position", "orientation", "contact_points", "min_angles"]:
		var before: Variant = limb.get(name)
		limb.set(name, "much")
		limb.set(name, null)
		equal(limb.get(name), before, name)
	equal(limb.find_fault(), "")


func test_tells_when_it_changes() -> void:
	var limb: RagdollLimb = _pill(0.1, 0.2)
	var count: Array[int] = [0]
	limb.changed.connect(func() -> void: count[0] += 1)
	limb.radius = 0.2
	limb.bone = &"Hips"
	equal(count[0], 2)


func test_joint_axes() -> void:
	var limb: RagdollLimb = _pill(0.1, 0.2)
	limb.anchor = Vector3(0.2, 1.4, 0.0)
	limb.position = Vector3(0.3, 1.3, 0.0)
	# An A-pose's arm, which the reset pose lifts.
	limb.reset_orientation = Quaternion(Vector3.BACK, PI / 4.0)
	almost_equal(Basis(limb.get_joint_axes()), Basis.IDENTITY, 1e-5)
	limb.reset_orientation = Quaternion(Vector3.BACK, -PI / 4.0)
	almost_equal(Basis(limb.get_joint_axes()) * Vector3.RIGHT, Vector3.DOWN, 1e-5)
	almost_equal(Basis(limb.get_joint_axes()) * Vector3.UP, Vector3.BACK, 1e-5)


func _pill(p_radius: float, p_length: float) -> RagdollLimb:
	var limb: RagdollLimb = RagdollLimb.new()
	limb.bone = &"Head"
	limb.group = &"head"
	limb.mass_fraction = 0.1
	limb.radius = p_radius
	limb.length = p_length
	return limb


func _box(p_size: Vector3) -> RagdollLimb:
	var limb: RagdollLimb = _pill(0.0, 0.0)
	limb.type = RagdollLimb.BOX
	limb.size = p_size
	return limb


func _check_inertia(p_limb: RagdollLimb) -> void:
	var half: Vector3 = p_limb.size / 2.0
	var is_box: bool = p_limb.type == RagdollLimb.BOX
	if not is_box:
		half = Vector3(p_limb.radius, p_limb.radius + p_limb.length / 2.0, p_limb.radius)
	var sum: Vector3 = Vector3.ZERO
	var count: int = 0
	for i: int in GRID:
		for j: int in GRID:
			# By symmetry one eighth is enough.
			for k: int in GRID:
				var point: Vector3 = half * Vector3(i + 0.5, j + 0.5, k + 0.5) / GRID
				if not is_box:
					var beyond: float = maxf(point.y - p_limb.length / 2.0, 0.0)
					if Vector3(point.x, beyond, point.z).length() > p_limb.radius:
						continue
				var square: Vector3 = point * point
				sum += Vector3(square.y + square.z, square.x + square.z, square.x + square.y)
				count += 1
	var wanted: Vector3 = sum / count * 5.0
	var got: Vector3 = p_limb.get_inertia(5.0)
	for axis: int in 3:
		var error: float = absf(got[axis] / wanted[axis] - 1.0)
		is_true(error < 0.01, "axis %d: %s instead of %s" % [axis, got, wanted])

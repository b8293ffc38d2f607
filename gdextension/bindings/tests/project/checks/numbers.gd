extends CheckSuite
## The native number types against the engine's: equal to the last bits.

const ROUNDS := 200
## Allowed difference, relative to the values' size. A few units of the last digit.
const TOLERANCE := 1e-6

var _random := RandomNumberGenerator.new()
var _worst := {}


func run() -> void:
	_random.seed = 7
	var probe := MathProbe.new()
	for i in ROUNDS:
		_vectors(probe)
		_quaternions(probe)
		_bases(probe)
		_transforms(probe)
	for operation: String in _worst:
		var difference: float = _worst[operation]
		check(operation, difference <= TOLERANCE, difference)


func _vectors(probe: MathProbe) -> void:
	var a := _vector()
	var b := _vector()
	var expected := {
		"+": a + b,
		"-": a - b,
		"*": a * b,
		"/": a / b,
		"scaled": a * 0.3,
		"negated": -a,
		"dot": a.dot(b),
		"cross": a.cross(b),
		"length": a.length(),
		"length_squared": a.length_squared(),
		"normalized": a.normalized(),
		"zero normalized": Vector3.ZERO.normalized(),
		"angle_to": a.angle_to(b),
		"distance_to": a.distance_to(b),
		"lerp": a.lerp(b, 0.25),
		"limit_length": a.limit_length(0.5),
		"is_finite": a.is_finite(),
	}
	_compare("Vector3", probe.vectors(a, b), expected)


func _quaternions(probe: MathProbe) -> void:
	var a := _rotation()
	var b := _rotation()
	var weight := _random.randf()
	var vector := _vector()
	var expected := {
		"*": a * b,
		"inverse": a.inverse(),
		"normalized": (a * 3.0).normalized(),
		"dot": a.dot(b),
		"length_squared": a.length_squared(),
		"slerp": a.slerp(b, weight),
		"xform": a * vector,
		"angle_to": a.angle_to(b),
		"get_angle": a.get_angle(),
		"get_axis": a.get_axis(),
		"log": a.log(),
		"exp": a.log().exp(),
		"basis": Basis(a),
		"axis angle": Quaternion(vector.normalized(), weight),
		"is_finite": a.is_finite(),
	}
	_compare("Quaternion", probe.quaternions(a, b, weight, vector), expected)


func _bases(probe: MathProbe) -> void:
	var a := _basis()
	var b := _basis()
	var vector := _vector()
	var expected := {
		"*": a * b,
		"transposed": a.transposed(),
		"inverse": a.inverse(),
		"determinant": a.determinant(),
		"orthonormalized": a.orthonormalized(),
		"get_scale": a.get_scale(),
		"get_rotation_quaternion": a.get_rotation_quaternion(),
		"xform": a * vector,
		"xform_inv": vector * a,
		"column": a.y,
	}
	_compare("Basis", probe.bases(a, b, vector), expected)


func _transforms(probe: MathProbe) -> void:
	var a := Transform3D(_basis(), _vector())
	var b := Transform3D(_basis(), _vector())
	var vector := _vector()
	var expected := {
		"*": a * b,
		"inverse": a.orthonormalized().inverse(),
		"affine_inverse": a.affine_inverse(),
		"xform": a * vector,
		"translated_local": a.translated_local(vector),
		"is_finite": a.is_finite(),
	}
	_compare("Transform3D", probe.transforms(a, b, vector), expected)


func _compare(type_name: String, found: Dictionary, expected: Dictionary) -> void:
	for operation: String in expected:
		var key := "%s %s" % [type_name, operation]
		var difference := _difference(found.get(operation), expected[operation])
		_worst[key] = maxf(_worst.get(key, 0.0), difference)


## The largest difference of any number, relative to the largest number.
func _difference(found: Variant, expected: Variant) -> float:
	if typeof(found) != typeof(expected):
		return INF
	var numbers := _numbers(found)
	var wanted := _numbers(expected)
	var size := 1.0
	var worst := 0.0
	for i in wanted.size():
		size = maxf(size, absf(wanted[i]))
		worst = maxf(worst, absf(numbers[i] - wanted[i]))
	return worst / size


func _numbers(value: Variant) -> PackedFloat64Array:
	match typeof(value):
		TYPE_VECTOR3:
			return [value.x, value.y, value.z]
		TYPE_QUATERNION:
			return [value.x, value.y, value.z, value.w]
		TYPE_BASIS:
			return _numbers(value.x) + _numbers(value.y) + _numbers(value.z)
		TYPE_TRANSFORM3D:
			return _numbers(value.basis) + _numbers(value.origin)
	return [float(value)]


func _vector() -> Vector3:
	return Vector3(_random.randfn(), _random.randfn(), _random.randfn())


func _rotation() -> Quaternion:
	return Quaternion(_vector().normalized(), _random.randf_range(-PI, PI))


## Rotates, scales, shears a little and sometimes mirrors.
func _basis() -> Basis:
	var scale := Vector3(_random.randf_range(0.5, 2), _random.randf_range(0.5, 2), -1.5)
	var basis := Basis(_rotation()) * Basis.from_scale(scale)
	basis.x += basis.y * 0.2
	return basis if _random.randf() < 0.3 else Basis(basis.x, basis.y, -basis.z)

class_name TestCase
extends Node
## Base of every test file: checks, expected engine errors and waiting for frames.
##
## A test file is named [code]tests/<feature>/test_<subject>.gd[/code], extends this class and has
## methods named [code]test_*[/code] without parameters, which may [code]await[/code]. Each test
## gets an instance of its own, inside the scene tree. A test fails when a check fails, when it
## checks nothing, when the engine or a script reports an error that it did not expect, and when it
## takes longer than [method time_limit].

## Most failures that are kept of one test.
const MAX_FAILURES: int = 20

# Private names start with _case_, so that a test file's own private names cannot meet them.
var _case_checks: int = 0
var _case_failures: PackedStringArray = PackedStringArray()
var _case_failure_count: int = 0
var _case_expected_errors: PackedStringArray = PackedStringArray()
var _case_allowed_errors: PackedStringArray = PackedStringArray()


## Runs before each test of the file. May await.
func before_each() -> void:
	pass


## Runs after each test of the file, also after a failed one. May await.
func after_each() -> void:
	pass


## Longest time of one test of this file, s; 0 for that of the runner, 600 s. Override to change it.
func time_limit() -> float:
	return 0.0


## Whether frames take as long as for a user, as something that the tests of this file wait for goes
## by the clock: another thread, a socket, the mixer. Else they come as fast as they can.
func goes_by_clock() -> bool:
	return false


## Checks that [param p_value] is true.
func is_true(p_value: bool, p_note: String = "") -> void:
	_case_check(p_value, "expected true, got false", p_note)


## Checks that [param p_value] is false.
func is_false(p_value: bool, p_note: String = "") -> void:
	_case_check(not p_value, "expected false, got true", p_note)


## Checks that [param p_value] is null.
func is_null(p_value: Variant, p_note: String = "") -> void:
	_case_check(p_value == null, "expected null, got %s" % _case_show(p_value), p_note)


## Checks that [param p_value] is not null.
func not_null(p_value: Variant, p_note: String = "") -> void:
	_case_check(p_value != null, "expected something, got null", p_note)


## Checks that both are of the same type and equal.
func equal(p_got: Variant, p_wanted: Variant, p_note: String = "") -> void:
	var same: bool = typeof(p_got) == typeof(p_wanted) and p_got == p_wanted
	_case_check(same, "expected %s, got %s" % [_case_show(p_wanted), _case_show(p_got)], p_note)


## Checks that the two differ.
func not_equal(p_got: Variant, p_other: Variant, p_note: String = "") -> void:
	var same: bool = typeof(p_got) == typeof(p_other) and p_got == p_other
	_case_check(not same, "expected anything but %s" % _case_show(p_other), p_note)


## Checks that no component of the two differs by more than [param p_tolerance].
##
## For numbers, vectors, quaternions (as rotations: q and -q are the same), bases, transforms, and
## arrays of these. NaN is never almost equal to anything.
func almost_equal(
	p_got: Variant, p_wanted: Variant, p_tolerance: float = 1e-5, p_note: String = ""
) -> void:
	var difference: float = Difference.between(p_got, p_wanted)
	# Written so that NaN fails too.
	_case_check(
		difference <= p_tolerance,
		(
			"expected %s within %s, got %s (difference %s)"
			% [_case_show(p_wanted), p_tolerance, _case_show(p_got), difference]
		),
		p_note
	)


## Checks that a text holds a text, an array a value, or a dictionary a key.
func contains(p_whole: Variant, p_part: Variant, p_note: String = "") -> void:
	var holds: bool = false
	if p_whole is String:
		holds = p_part is String and (p_whole as String).contains(p_part)
	else:
		holds = p_part in p_whole
	_case_check(
		holds, "expected %s to contain %s" % [_case_show(p_whole), _case_show(p_part)], p_note
	)


## Fails the test.
func fail(p_message: String) -> void:
	_case_check(false, p_message, "")


## Requires at least one engine or script error that contains [param p_text] before the test ends,
## and forgives every such error. It counts as a check.
func expect_error(p_text: String) -> void:
	_case_checks += 1
	_case_expected_errors.append(p_text)


## Forgives engine and script errors that contain [param p_text]. It does not count as a check.
func allow_error(p_text: String) -> void:
	_case_allowed_errors.append(p_text)


## Waits for the given number of physics steps: [code]await physics_frames(60)[/code].
func physics_frames(p_count: int = 1) -> void:
	for _step: int in p_count:
		await get_tree().physics_frame


## Waits for the given number of drawn frames.
func process_frames(p_count: int = 1) -> void:
	for _frame: int in p_count:
		await get_tree().process_frame


## Waits, frame by frame, until something holds, and fails where it does not. [param p_step], where
## it is given, is called (and awaited) before each look.
func until(
	p_holds: Callable, p_step: Callable = Callable(), p_limit_s: float = Waiting.PATIENCE_S
) -> void:
	var is_so: bool = await Waiting.until(get_tree(), p_holds, p_step, p_limit_s)
	_case_check(is_so, "it did not happen within %s s" % p_limit_s, "")


func _case_check(p_holds: bool, p_message: String, p_note: String) -> void:
	_case_checks += 1
	if p_holds:
		return
	_case_failure_count += 1
	if _case_failures.size() < MAX_FAILURES:
		var note: String = "" if p_note.is_empty() else p_note + ": "
		_case_failures.append("%s%s%s" % [note, p_message, _case_place()])


func _case_place() -> String:
	var own: String = (get_script() as Script).resource_path
	var nearest: String = ""
	for frame: Dictionary in get_stack():
		var source: String = frame["source"]
		if source.ends_with("framework/test_case.gd"):
			continue
		if nearest.is_empty():
			nearest = " (%s:%d)" % [source.trim_prefix("res://"), frame["line"]]
		if source == own:
			return " (%s:%d)" % [source.trim_prefix("res://"), frame["line"]]
	return nearest


func _case_show(p_value: Variant) -> String:
	var text: String = '"%s"' % p_value if p_value is String else str(p_value)
	return text if text.length() <= 400 else text.left(400) + "..."


## How far two values are apart.
class Difference:
	## Largest difference of any component; infinite where they cannot be compared.
	static func between(p_got: Variant, p_wanted: Variant) -> float:
		if p_got is Quaternion and p_wanted is Quaternion:
			var got: Quaternion = p_got
			var wanted: Quaternion = p_wanted
			return minf(_of_floats(got, wanted), _of_floats(-got, wanted))
		var got_parts: Array = _parts(p_got)
		var wanted_parts: Array = _parts(p_wanted)
		if got_parts.is_empty() and wanted_parts.is_empty():
			return 0.0 if typeof(p_got) == typeof(p_wanted) and p_got == p_wanted else INF
		if got_parts.size() != wanted_parts.size():
			return INF
		var largest: float = 0.0
		for index: int in got_parts.size():
			var one: float = _of_parts(got_parts[index], wanted_parts[index])
			if is_nan(one):
				return NAN
			largest = maxf(largest, one)
		return largest

	static func _of_floats(p_got: Quaternion, p_wanted: Quaternion) -> float:
		return between(
			[p_got.x, p_got.y, p_got.z, p_got.w], [p_wanted.x, p_wanted.y, p_wanted.z, p_wanted.w]
		)

	static func _of_parts(p_got: Variant, p_wanted: Variant) -> float:
		var numbers: bool = (
			(p_got is float or p_got is int) and (p_wanted is float or p_wanted is int)
		)
		if not numbers:
			return between(p_got, p_wanted)
		if is_nan(p_got) or is_nan(p_wanted):
			return NAN
		return 0.0 if p_got == p_wanted else absf(p_got - p_wanted)

	static func _parts(p_value: Variant) -> Array:
		match typeof(p_value):
			TYPE_FLOAT, TYPE_INT:
				return [p_value]
			TYPE_VECTOR2:
				return [p_value.x, p_value.y]
			TYPE_VECTOR3:
				return [p_value.x, p_value.y, p_value.z]
			TYPE_VECTOR4, TYPE_COLOR:
				return [p_value[0], p_value[1], p_value[2], p_value[3]]
			TYPE_BASIS:
				return [p_value.x, p_value.y, p_value.z]
			TYPE_TRANSFORM3D:
				return [p_value.basis, p_value.origin]
		return Array(p_value) if typeof(p_value) >= TYPE_ARRAY else []

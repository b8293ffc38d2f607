class_name HeadMount
extends RefCounted
## How a headset sits on a head: the turn from the head's limb to the headset, and the lever from
## the point between the eyes to the pivot of the neck. Solved once from nods and turns, then kept.
##
## With S the suit's head, H the headset's rotation as a head's ([method XrFrame.head_turn]), Y the
## unknown turn of the suit about the vertical: H = Y S M; M and Y by turns, each the mean of what
## the other leaves. The lever l: p + H l = c for all, c being the pivot of somebody who stands
## still; least squares, held near the usual lever.

## The pivot of the neck, seen from the eyes, in the axes of a head that faces +Z, m (common neck
## model: eyes 80.5 mm ahead of it and 75 mm above).
const USUAL_LEVER: Vector3 = Vector3(0.0, -0.075, -0.0805)
## Least range of nods and turns, rad.
const MIN_NOD: float = deg_to_rad(20.0)
const MIN_TURN: float = deg_to_rad(40.0)
## Rms movement of the pivot beyond which the wearer has walked, m.
const MAX_LEFT_M: float = 0.02
## Greatest distance of a lever from the usual one, m.
const MAX_OFF_M: float = 0.06
## Most that a headset is turned on a head, rad.
const MAX_TURN: float = deg_to_rad(35.0)
## Moments that are kept.
const KEPT: int = 120
# Weight of the usual lever, in moments of a turn by 1 rad.
const _USUAL_WEIGHT: float = 1.0
# Most rounds in which turn and heading are found; a few milliseconds.
const _ROUNDS: int = 60

## From the head's limb to the headset's head.
var turn: Quaternion = Quaternion.IDENTITY
## From the eyes to the pivot of the neck, in the axes of a head that faces +Z, m.
var lever: Vector3 = USUAL_LEVER
## Whether it was solved.
var is_solved: bool = false

var _heads: Array[Quaternion] = []
var _suits: Array[Quaternion] = []
var _eyes: PackedVector3Array = PackedVector3Array()


## Takes a moment of somebody who stands and nods or turns the head: the headset (as [method
## XrFrame.head_turn] and its position) and the suit's head, raw.
func add(p_head: Quaternion, p_eyes: Vector3, p_suit: Quaternion) -> void:
	if _heads.size() >= KEPT:
		_heads.pop_front()
		_suits.pop_front()
		_eyes.remove_at(0)
	_heads.append(p_head)
	_suits.append(p_suit)
	_eyes.append(p_eyes)


## Forgets the moments, not what was solved.
func clear() -> void:
	_heads.clear()
	_suits.clear()
	_eyes.clear()


## Solves it from the moments. Returns what is wrong and how to mend it, or an empty text; then
## nothing has changed.
func solve() -> String:
	var reached: Vector2 = _ranges()
	if reached.x < MIN_NOD or reached.y < MIN_TURN:
		var parts: Array = [rad_to_deg(reached.x), rad_to_deg(reached.y)]
		parts.append_array([rad_to_deg(MIN_NOD), rad_to_deg(MIN_TURN)])
		return (
			"the head nodded %.0f and turned %.0f degrees: nod by %.0f and look to both sides (%.0f)"
			% parts
		)
	var found: Quaternion = _solve_turn()
	if Rotations.angle(found) > MAX_TURN:
		return (
			"the headset seems to be turned on the head by %.0f degrees: put it on straight"
			% rad_to_deg(Rotations.angle(found))
		)
	var arm: Vector3 = _solve_lever()
	var left: float = _left_of(arm)
	if left > MAX_LEFT_M:
		return "the neck moved by %.0f mm: nod and turn only the head" % (left * 1000.0)
	if arm.distance_to(USUAL_LEVER) > MAX_OFF_M:
		return "no neck lies %s m from the eyes: nod and turn only the head" % arm
	turn = found
	lever = arm
	is_solved = true
	return ""


## The head's limb under a headset.
func head_of(p_head: Quaternion) -> Quaternion:
	return (p_head * turn.inverse()).normalized()


## The pivot of the neck under a headset, m.
func pivot_of(p_head: Quaternion, p_eyes: Vector3) -> Vector3:
	return p_eyes + p_head * lever


## For files.
func to_dictionary() -> Dictionary:
	return {
		"turn": [turn.x, turn.y, turn.z, turn.w],
		"lever_m": [lever.x, lever.y, lever.z],
	}


## From a file. Returns what is wrong, or an empty text.
func read_dictionary(p_values: Dictionary) -> String:
	var parts: Array[float] = []
	for key: String in ["turn", "lever_m"]:
		var list: Variant = p_values.get(key)
		if not list is Array or (list as Array).size() != (4 if key == "turn" else 3):
			return "a headset's mount has turn (4 numbers) and lever_m (3 numbers)"
		for value: Variant in list as Array:
			if not (value is float or value is int) or not is_finite(value):
				return "a headset's mount is made of numbers, found '%s'" % str(value)
			parts.append(value)
	var rotation: Quaternion = Quaternion(parts[0], parts[1], parts[2], parts[3])
	var arm: Vector3 = Vector3(parts[4], parts[5], parts[6])
	if absf(rotation.length() - 1.0) > 0.01 or Rotations.angle(rotation) > MAX_TURN:
		return (
			"a headset's turn on a head is a rotation by %.0f degrees at most"
			% rad_to_deg(MAX_TURN)
		)
	if arm.distance_to(USUAL_LEVER) > MAX_OFF_M:
		return "the neck's pivot lies near %s m from the eyes, found %s" % [USUAL_LEVER, arm]
	turn = rotation.normalized()
	lever = arm
	is_solved = true
	return ""


## Takes what a file has kept, if there is one; what is wrong with it is logged.
func load_file(p_path: String) -> void:
	if not FileAccess.file_exists(p_path):
		return
	var kept: Variant = JSON.parse_string(FileAccess.get_file_as_string(p_path))
	var fault: String = read_dictionary(kept) if kept is Dictionary else "it is no JSON object"
	if fault != "":
		Log.warning("headset", "%s is not used: %s" % [p_path, fault])


## Keeps it in a file.
func save_file(p_path: String) -> void:
	var file: FileAccess = FileAccess.open(p_path, FileAccess.WRITE)
	if file != null:
		file.store_string(JSON.stringify(to_dictionary()))


## How far the headset nodded and turned: its range, rad.
func _ranges() -> Vector2:
	if _heads.is_empty():
		return Vector2.ZERO
	var low: Vector2 = Vector2(INF, INF)
	var high: Vector2 = -low
	var first: float = Rotations.facing_of(_heads[0])
	for head: Quaternion in _heads:
		var ahead: Vector3 = head * Vector3.BACK
		var here: Vector2 = Vector2(
			asin(clampf(ahead.y, -1.0, 1.0)), angle_difference(first, Rotations.facing_of(head))
		)
		low = low.min(here)
		high = high.max(here)
	return high - low


func _solve_turn() -> Quaternion:
	var mount: Quaternion = Quaternion.IDENTITY
	var heading: float = Rotations.yaw_of(_heads[0] * _suits[0].inverse())
	for _round: int in _ROUNDS:
		var turned: float = 0.0
		for at: int in _heads.size():
			var rest: Quaternion = _heads[at] * (_suits[at] * mount).inverse()
			turned += angle_difference(heading, Rotations.yaw_of(rest)) / _heads.size()
		heading += turned
		var back: Quaternion = Rotations.yaw(-heading)
		var step: Vector3 = Vector3.ZERO
		for at: int in _heads.size():
			var rest: Quaternion = (_suits[at] * mount).inverse() * back * _heads[at]
			step += Rotations.vector(rest) / _heads.size()
		mount = (mount * Rotations.from_vector(step)).normalized()
		if step.length() < 1e-5 and absf(turned) < 1e-5:
			break
	return mount


func _solve_lever() -> Vector3:
	var mean: Basis = Basis(Vector3.ZERO, Vector3.ZERO, Vector3.ZERO)
	var middle: Vector3 = Vector3.ZERO
	for at: int in _heads.size():
		mean = _plus(mean, Basis(_heads[at]), 1.0 / _heads.size())
		middle += _eyes[at] / _heads.size()
	# Normal equations of (H - mean H) l = -(p - mean p), and of l = the usual one.
	var matrix: Basis = Basis.from_scale(Vector3.ONE * _USUAL_WEIGHT)
	var right: Vector3 = USUAL_LEVER * _USUAL_WEIGHT
	for at: int in _heads.size():
		var turned: Basis = _plus(Basis(_heads[at]), mean, -1.0)
		matrix = _plus(matrix, turned.transposed() * turned, 1.0)
		right -= turned.transposed() * (_eyes[at] - middle)
	return matrix.inverse() * right


## How far from its mean the pivot is, rms, m.
func _left_of(p_lever: Vector3) -> float:
	var middle: Vector3 = Vector3.ZERO
	for at: int in _heads.size():
		middle += (_eyes[at] + _heads[at] * p_lever) / _heads.size()
	var sum: float = 0.0
	for at: int in _heads.size():
		sum += (_eyes[at] + _heads[at] * p_lever).distance_squared_to(middle)
	return sqrt(sum / _heads.size())


static func _plus(p_first: Basis, p_second: Basis, p_weight: float) -> Basis:
	return Basis(
		p_first.x + p_second.x * p_weight,
		p_first.y + p_second.y * p_weight,
		p_first.z + p_second.z * p_weight
	)

extends ContactScene
## An arm that is commanded 0.38 m into a static wall.
##
## Penetration is how far the surface of a hand or lower arm is behind the wall's face, largest
## over the whole case. Cases: a punch with a straight arm (0.4 s from the hip to full reach), a
## stretched arm that the walking body (1 m/s) pushes into the wall, and the clip's own furthest
## reach with either hand. Then the arm is held in the wall for a second. The wall of the scripted cases begins above the feet, which would be in it.

const _DEPTH_M: float = 0.38
const _GOAL_MM: Dictionary[int, float] = {60: 20.0, 120: 10.0}
const _HOLD_S: float = 1.0
## Before the clip's furthest reach, s, and how long of that the body takes to come near, if it has
## to be kept clear of the wall at first.
const _LEAD_S: float = 1.5
const _APPROACH_S: float = 1.2
const _CLEAR_M: float = 0.02

var _world: ContactWorld = null
var _person: ContactPerson = null
## The wall's face: points behind it have a larger dot product with the normal than the distance.
var _normal: Vector3 = Vector3.BACK
var _distance: float = 0.0
var _deepest: float = 0.0


func play(p_performer: ContactPerformer) -> void:
	await _play_script(p_performer, "wall punch", _punch, _stand, 0.6)
	await _play_script(p_performer, "wall walk", _stretch, _walk, 1.2)
	for side: String in ["Left", "Right"]:
		await _play_clip(p_performer, side)


## The right fist goes from beside the hip straight ahead.
func _punch(p_time_s: float) -> PoseSample:
	var length: float = _person.arm_length("Right")
	var from: Vector3 = Vector3(0.0, -0.6, -0.1) * length
	var share: float = ContactPoses.smooth((p_time_s - 0.2) / 0.4)
	return ContactPoses.fist_at(_person, from.lerp(Vector3(0.0, 0.0, 0.98 * length), share))


func _stretch(_time_s: float) -> PoseSample:
	return ContactPoses.fist_at(_person, Vector3(0.0, 0.0, 0.98 * _person.arm_length("Right")))


func _stand(_time_s: float) -> Vector3:
	return _person.standing_hips()


## Ends where one who does not walk stands.
func _walk(p_time_s: float) -> Vector3:
	return _person.standing_hips() + Vector3(0.0, 0.0, minf(p_time_s - 1.0, 0.0))


func _play_script(
	p_performer: ContactPerformer,
	p_scene: String,
	p_pose: Callable,
	p_place: Callable,
	p_seconds: float
) -> void:
	_enter(p_performer)
	_normal = Vector3.BACK
	var end: Array[Transform3D] = _person.targets(p_pose.call(10.0), p_place.call(10.0))
	_distance = _reach(_arm("Right"), end) - _DEPTH_M
	await _push(p_performer, p_scene, p_pose, p_place, p_seconds, 0.4 * _person.standing_hips().y)


## The moment at which a hand is furthest from the hips, in the direction in which it is there. The
## hips stay above their place of that moment, so that it is the arm that meets the wall.
func _play_clip(p_performer: ContactPerformer, p_side: String) -> void:
	_enter(p_performer)
	var best: float = _find_reach(p_performer, p_side)
	var hips: Vector3 = p_performer.hips_at(best, _person)
	var start: float = maxf(best - _LEAD_S, 0.0)
	_distance = _reach(_arm(p_side), _targets(p_performer, best, hips)) - _DEPTH_M
	var pose: Callable = func(time: float) -> PoseSample:
		return p_performer.source.pose_at(minf(start + time, best))
	var first: Array[Transform3D] = _targets(p_performer, start, hips)
	var back: float = maxf(_reach(range(_person.count), first) - _distance + _CLEAR_M, 0.0)
	var place: Callable = func(time: float) -> Vector3:
		var height: float = p_performer.hips_at(minf(start + time, best), _person).y
		var left: float = back * (1.0 - ContactPoses.smooth(time / _APPROACH_S))
		return Vector3(hips.x, height, hips.z) - _normal * left
	var scene: String = "wall clip %s" % p_side.to_lower()
	await _push(p_performer, scene, pose, place, best - start + 0.3, -5.0)


func _enter(p_performer: ContactPerformer) -> void:
	_world = make_world()
	_person = p_performer.enter(_world, root)


func _find_reach(p_performer: ContactPerformer, p_side: String) -> float:
	var hand: int = _person.find(StringName(p_side + "Hand"))
	var furthest: float = 0.0
	var best: float = 0.0
	for step: int in int(p_performer.duration() * 30.0):
		var bodies: Array[Transform3D] = _targets(p_performer, step / 30.0, Vector3.ZERO)
		var away: Vector3 = bodies[hand].origin * Vector3(1.0, 0.0, 1.0)
		if away.length() > furthest:
			furthest = away.length()
			best = step / 30.0
			_normal = away.normalized()
	return best


func _targets(
	p_performer: ContactPerformer, p_moment: float, p_hips: Vector3
) -> Array[Transform3D]:
	return _person.targets(p_performer.source.pose_at(p_moment), p_hips)


func _arm(p_side: String) -> Array:
	return [
		_person.find(StringName(p_side + "Hand")), _person.find(StringName(p_side + "LowerArm"))
	]


func _reach(p_limbs: Array, p_bodies: Array[Transform3D]) -> float:
	var furthest: float = -INF
	for limb: int in p_limbs:
		furthest = maxf(furthest, _person.reach(limb, p_bodies[limb], _normal))
	return furthest


func _push(
	p_performer: ContactPerformer,
	p_scene: String,
	p_pose: Callable,
	p_place: Callable,
	p_seconds: float,
	p_bottom: float
) -> void:
	var middle: Vector3 = _normal * (_distance + 0.5) + _sideways(p_place.call(p_seconds))
	middle.y = p_bottom + 5.0
	_world.add_block(Vector3(10.0, 10.0, 1.0), Transform3D(Basis.looking_at(_normal), middle))
	_world.add_person(_person, p_pose, p_place)
	_deepest = 0.0
	await _world.run(p_seconds + _HOLD_S, _measure)
	var case: String = name_case(p_scene, p_performer)
	var goal: float = _GOAL_MM.get(hz, 0.0)
	report.at_most(case, "arm in wall", _deepest * 1000.0, "mm", goal, _GOAL_MM.has(hz))
	await end_world(_world)


func _measure() -> bool:
	var bodies: Array[Transform3D] = _person.bodies()
	_deepest = maxf(_deepest, _reach(_arm("Left") + _arm("Right"), bodies) - _distance)
	return false


## What of a place lies beside the normal, so that the wall is before the person.
func _sideways(p_place: Vector3) -> Vector3:
	var flat: Vector3 = p_place * Vector3(1.0, 0.0, 1.0)
	return flat - _normal * flat.dot(_normal)

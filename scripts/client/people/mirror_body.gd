class_name MirrorBody
extends Node3D
## The body that the session will show of somebody's motion, before there is a session: the same
## avatar, fitted to the same card, moved by the same samples ([OwnBody]); only nothing of the
## server's world is in its way.
##
## Without a motion it stands still, in the N-pose.

## Who is shown has another body, of this height, m.
signal made(p_height: float)

## How fast the floor may rise to the lower foot, m/s: who jumps is seen to jump.
const _RISE: float = 0.12
const _FEET: Array[int] = [Limbs.LEFT_FOOT, Limbs.RIGHT_FOOT]
## Floats of a limb: position and quaternion.
const _FLOATS: int = 7

## Height of the floor that the feet stand on, m.
var floor_height: float = 0.0
## How it is shown; null before [method show_motion].
var view: ActorView = null

var _default: PackedScene = null
var _rate: float = 60.0
var _motion: ClientMotion = null
# What the body was made for.
var _card: PersonCard = null
var _body: OwnBody = OwnBody.new()
# Points of the feet's soles, in the frames of their limbs, m.
var _soles: Array[PackedVector3Array] = []
# The pose of somebody who has no motion.
var _at_rest: PoseSample = null


## Takes the scene of who wears the default avatar, and how many samples come a second.
func _init(p_default: PackedScene, p_rate: float) -> void:
	_default = p_default
	_rate = p_rate


## Shows the motion of somebody, or nobody's: null; then as this avatar.
func show_motion(p_motion: ClientMotion, p_avatar: String) -> void:
	var card: PersonCard = PersonCard.of("", 0.0)
	card.avatar = p_avatar
	if p_motion != null:
		card.take_size(p_motion.card.hip_height, p_motion.card.lengths)
	if p_motion == _motion and _card != null and card.is_same_body(_card):
		return
	_motion = p_motion
	_card = card
	_make()


## Goes on to the moment of a frame, µs of [method Time.get_ticks_usec], after a time, s. Returns
## whether there is a pose.
func advance(p_now_usec: int, p_delta: float) -> bool:
	if _motion != null:
		for sample: PoseSample in _motion.taken:
			_body.add_sample(sample)
	var moment: int = p_now_usec + MotionSender.unix_ahead()
	var floats: PackedFloat32Array = _body.evaluate(p_now_usec / 1e6, moment)
	if floats.is_empty() or not view.pose_floats(floats):
		return false
	view.node.visible = true
	floor_height = minf(_lowest(floats), floor_height + _RISE * p_delta)
	return true


func _make() -> void:
	if view != null:
		view.node.free()
	var person: Ragdoll = AvatarStore.scene_of(_card.avatar, _default).instantiate()
	person.visible = false
	# It is nobody in the session's world.
	person.remove_from_group(Ragdoll.PEOPLE)
	if not _card.lengths.is_empty():
		person.fit(_card.lengths, _card.hip_height)
	var joints: PersonSkeleton = person.get_joints()
	var hips: float = person.get_hip_height()
	_find_soles(person.profile)
	add_child(person)
	view = ActorView.new(person, joints)
	var own_hips: float = _motion.source.get_hip_height() if _motion != null else hips
	_body.setup(joints, hips / own_hips, _rate)
	floor_height = INF
	made.emit(RestSkeleton.new(person.get_skeleton()).height())
	if _motion == null:
		_at_rest = CalibrationGuide.countdown(ResetPose.Kind.N).pose_at(0.0)
		_at_rest.root = Vector3(0.0, hips, 0.0)
		_body.add_sample(_at_rest)
	elif _motion.newest != null:
		_body.add_sample(_motion.newest)


func _find_soles(p_profile: RagdollProfile) -> void:
	_soles.clear()
	for foot: int in _FEET:
		var limb: RagdollLimb = p_profile.find(Limbs.BONES[foot])
		var turn: Quaternion = limb.reset_orientation * limb.rest_orientation.inverse()
		var points: PackedVector3Array = []
		for point: Vector3 in limb.contact_points:
			points.append(turn * (point - limb.position))
		_soles.append(points)


## Height of the lower sole, m.
func _lowest(p_floats: PackedFloat32Array) -> float:
	var lowest: float = INF
	for foot: int in _FEET.size():
		var at: int = _FEET[foot] * _FLOATS
		var turn: Quaternion = Quaternion(
			p_floats[at + 3], p_floats[at + 4], p_floats[at + 5], p_floats[at + 6]
		)
		for point: Vector3 in _soles[foot]:
			lowest = minf(lowest, p_floats[at + 1] + (turn * point).y)
	return lowest

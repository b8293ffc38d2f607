class_name PeopleSounds
extends RefCounted
## Steps, cloth and gear of the people who are displayed: from their poses, at no byte.

## Distance from the listener beyond which people are silent, m.
const MAX_DISTANCE_M: float = 45.0
## Distance from the ankle down to the sole, and height above it from which a ray looks for the
## ground, m.
const _SOLE_M: float = 0.09
const _ABOVE_M: float = 0.35
const _BELOW_M: float = 0.14
## Speed of a foot at which a step has its recorded level, m/s.
const _STEP_SPEED: float = 1.1
## Speed above which gear rattles at each step, m/s.
const _RUN_SPEED: float = 2.2
## Speed of hands beside the hips above which cloth rubs, m/s, and least time between two such
## sounds, s.
const _HAND_SPEED: float = 1.3
const _CLOTH_S: float = 0.35
## Time for which people must have been seen before they make sounds, s: at first their speed is
## unknown.
const _MIN_SEEN_S: float = 0.5

var _voices: SoundVoices = null
var _walkers: Dictionary[int, Walker] = {}
var _query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.new()


## Plays on such voices.
func _init(p_voices: SoundVoices) -> void:
	_voices = p_voices
	_query.collision_mask = PhysicsLayers.STATIC | PhysicsLayers.PROPS


## Looks at everybody after a time, s; [param p_own] is the listener's own person, or -1.
func advance(p_people: Dictionary[int, ActorView], p_own: int, p_delta: float) -> void:
	var ear: Vector3 = _voices.ear()
	for person: int in _walkers.keys():
		if not p_people.has(person):
			_walkers.erase(person)
	for person: int in p_people:
		var view: ActorView = p_people[person]
		if not view.node.visible or view.hips().distance_to(ear) > MAX_DISTANCE_M:
			_walkers.erase(person)
			continue
		if not _walkers.has(person):
			_walkers[person] = Walker.new()
		_advance_one(_walkers[person], view, 6.0 if person == p_own else 0.0, p_delta)


func _advance_one(
	p_walker: Walker, p_view: ActorView, p_priority_db: float, p_delta: float
) -> void:
	var feet: PackedVector3Array = p_view.feet()
	if feet.size() < 2:
		return
	var hips: Vector3 = p_view.hips()
	p_walker.contacts.advance(hips, feet, p_delta)
	p_walker.seen_s += p_delta
	if p_walker.seen_s < _MIN_SEEN_S:
		return
	for foot: int in 2:
		if p_walker.contacts.landed[foot] > 0.0:
			_step(feet[foot], p_walker.contacts, foot, p_priority_db)
	_rub(p_walker, hips, p_view.hands(), p_delta)


func _step(p_foot: Vector3, p_contacts: FootContacts, p_side: int, p_priority_db: float) -> void:
	_query.from = p_foot + Vector3.UP * _ABOVE_M
	_query.to = p_foot - Vector3.UP * (_SOLE_M + _BELOW_M)
	var hit: Dictionary = _voices.get_world_3d().direct_space_state.intersect_ray(_query)
	if hit.is_empty() or not is_instance_valid(hit["collider"]):
		return
	var place: Vector3 = hit["position"]
	var ground: ContactMaterial = ContactMaterial.at(hit["collider"], place)
	var speed: float = p_contacts.landed[p_side]
	var gain: float = clampf(20.0 * log(speed / _STEP_SPEED) / log(10.0), -14.0, 9.0)
	# Who walks faster sets the feet down harder, which their height alone does not tell.
	gain += clampf(p_contacts.pace - 1.4, -1.0, 3.0) * 2.0
	var name: StringName = ImpactSounds.step_name(StringName(ground.sound))
	var voice: SoundVoice = _voices.play(name, place, gain)
	if voice != null:
		voice.priority_db = p_priority_db
	if p_contacts.pace > _RUN_SPEED:
		_voices.play(&"gear", place + Vector3.UP, gain)


static func _speed_of(p_from: Vector3, p_to: Vector3, p_delta: float) -> float:
	return p_from.distance_to(p_to) / p_delta if p_from.is_finite() else 0.0


## Cloth where a hand moves fast beside the hips.
func _rub(p_walker: Walker, p_hips: Vector3, p_hands: PackedVector3Array, p_delta: float) -> void:
	p_walker.cloth_s += p_delta
	for side: int in mini(p_hands.size(), 2):
		var arm: Vector3 = p_hands[side] - p_hips
		var speed: float = _speed_of(p_walker.arms[side], arm, maxf(p_delta, 1e-3))
		p_walker.arms[side] = arm
		if speed > _HAND_SPEED and speed < 15.0 and p_walker.cloth_s > _CLOTH_S:
			p_walker.cloth_s = 0.0
			var gain: float = linear_to_db(minf(speed / 2.0, 3.0))
			_voices.play(&"cloth", p_hands[side], gain)


## What is remembered of somebody.
class Walker:
	extends RefCounted
	var contacts: FootContacts = FootContacts.new()
	var arms: PackedVector3Array = [Vector3.INF, Vector3.INF]
	var cloth_s: float = 0.0
	var seen_s: float = 0.0

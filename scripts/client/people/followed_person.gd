class_name FollowedPerson
extends RefCounted
## The person that a client's camera follows: the own person, else the one who came first, until the
## user chooses.

## How far a click may be from somebody's trunk, m.
const _REACH_M: float = 0.6

## The chosen person, or -1: nobody was chosen.
var chosen: int = -1
## The person of this client, or -1.
var own: int = -1


## Whom the camera follows of those who are shown, or -1 where nobody is.
func find(p_people: Dictionary[int, ActorView]) -> int:
	for actor: int in [chosen, own]:
		if p_people.has(actor) and p_people[actor].node.visible:
			return actor
	for actor: int in p_people:
		if p_people[actor].node.visible:
			return actor
	return -1


## Chooses the one behind the one who is followed.
func choose_next(p_people: Dictionary[int, ActorView]) -> void:
	var shown: Array[int] = []
	for actor: int in p_people:
		if p_people[actor].node.visible:
			shown.append(actor)
	if not shown.is_empty():
		chosen = shown[(shown.find(find(p_people)) + 1) % shown.size()]


## Chooses whom a ray meets first, if anybody. Returns whether it does.
func choose_at(p_people: Dictionary[int, ActorView], p_from: Vector3, p_direction: Vector3) -> bool:
	var nearest: float = INF
	for actor: int in p_people:
		var view: ActorView = p_people[actor]
		var middle: Vector3 = view.hips().lerp(view.head_joint(), 0.5)
		var along: float = (middle - p_from).dot(p_direction)
		var off: float = (middle - p_from - p_direction * along).length()
		if view.node.visible and along > 0.0 and along < nearest and off < _REACH_M:
			nearest = along
			chosen = actor
	return nearest < INF

class_name NearbySessions
extends RefCounted
## Finds who is near enough to a client's person to hear that person speak: the audience of a
## [StreamRelay].


## The other sessions that have somebody within a distance (m) of the first person of a session.
## Empty where the session has no body.
static func find(
	p_people: Array[ServerPerson], p_session: int, p_range_m: float
) -> PackedInt32Array:
	var own: int = p_people.find_custom(
		func(person: ServerPerson) -> bool: return person.session == p_session
	)
	var near: Dictionary[int, bool] = {}
	for other: ServerPerson in p_people if own >= 0 else ([] as Array[ServerPerson]):
		var is_other: bool = other.session > 0 and other.session != p_session
		if is_other and other.hips().distance_to(p_people[own].hips()) <= p_range_m:
			near[other.session] = true
	return PackedInt32Array(near.keys())

class_name NearbySessions
extends RefCounted
## Finds who is near enough to a client's person to hear that person speak: the audience of a
## [StreamRelay].


## The other sessions that have somebody within a distance (m) of the first person of a session.
## Empty where the session has no body.
static func find(
	p_people: Array[ServerPerson], p_session: int, p_range_m: float
) -> PackedInt32Array:
	var near: Dictionary[int, bool] = {}
	for own: ServerPerson in p_people:
		if own.session != p_session:
			continue
		for other: ServerPerson in p_people:
			var is_other: bool = other.session > 0 and other.session != p_session
			if is_other and other.hips().distance_to(own.hips()) <= p_range_m:
				near[other.session] = true
		break
	return PackedInt32Array(near.keys())

class_name TetherNote
extends RefCounted
## Text that says to a wearer that the own body cannot follow: how far away the motion is, and in
## which direction.

## Length below which a tether is not mentioned, m.
const MIN_M: float = 0.1

const _DIRECTIONS: Array[String] = ["ahead of you", "to your left", "behind you", "to your right"]


## The text for the screen; empty if the body is where its motion is. [param p_tether] goes from the
## motion to the body, in the world, m; [param p_heading] is the body's, rad about the vertical.
static func describe(p_tether: Vector2, p_heading: float) -> String:
	var length: float = p_tether.length()
	if length < MIN_M:
		return ""
	# Direction to the motion, from the body's front, which is +Z, to its left, +X.
	var angle: float = atan2(-p_tether.x, -p_tether.y) - p_heading
	var direction: String = _DIRECTIONS[posmod(roundi(angle / (PI / 2.0)), 4)]
	return "Held back: your motion is %.1f m %s" % [length, direction]

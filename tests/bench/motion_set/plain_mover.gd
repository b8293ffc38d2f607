extends RefCounted
## A mover without a world: goes to the wished velocity with a limited acceleration and turns with a
## limited rate, on level ground.

## m/s² while speeding up and slowing down.
const ACCELERATION: float = 14.0
## rad/s.
const TURN_RATE: float = TAU

## m.
var position: Vector3 = Vector3.ZERO
## m/s.
var velocity: Vector3 = Vector3.ZERO
## rad about +Y, 0 faces +Z.
var heading: float = 0.0
## m/s in the world.
var wished_velocity: Vector3 = Vector3.ZERO
## rad.
var wished_heading: float = 0.0
## One of [enum MotionMatcher.Stance].
var stance: int = MotionMatcher.STAND


## A tick of so many seconds.
func advance(p_delta: float) -> void:
	velocity = velocity.move_toward(wished_velocity, ACCELERATION * p_delta)
	position += velocity * p_delta
	var turn: float = wrapf(wished_heading - heading, -PI, PI)
	heading = wrapf(heading + clampf(turn, -TURN_RATE * p_delta, TURN_RATE * p_delta), -PI, PI)


## Shows a matcher what it does.
func show(p_matcher: MotionMatcher, p_delta: float) -> void:
	p_matcher.advance(
		p_delta, position, velocity, heading, wished_velocity, wished_heading, stance, true
	)


## Wishes to go by a speed, m/s, in a direction from where it faces, rad.
func wish(p_speed: float, p_direction: float, p_heading: float) -> void:
	wished_heading = p_heading
	wished_velocity = Vector3(0, 0, p_speed).rotated(Vector3.UP, p_heading + p_direction)


## The same moment.
func copy() -> RefCounted:
	var other: RefCounted = get_script().new()
	for name: String in [
		"position", "velocity", "heading", "wished_velocity", "wished_heading", "stance"
	]:
		other.set(name, get(name))
	return other

extends RefCounted
## Measures how well a shown body fits its mover: whether its feet slide, where it is, where it
## faces.

## Ticks over which headings are averaged: trunks swing with every step.
const WINDOW: int = 36
## Ticks after a change of the wish in which place and heading are not held to their goals.
const SETTLING: int = 30

## Whether its soles slide.
var slide: SoleSlide = SoleSlide.new()
## Distances of the hips from the mover on the ground, m.
var distances: PackedFloat64Array = PackedFloat64Array()
## Differences of the chest's mean heading from the mover's, rad.
var headings: PackedFloat64Array = PackedFloat64Array()
## Ticks, and those without a foot on the ground.
var ticks: int = 0
var flying: int = 0

var _window: PackedFloat64Array = PackedFloat64Array()
var _since: int = 0


## Says that another walker comes.
func begin() -> void:
	slide.begin()
	changed()


## Says that the wish has changed.
func changed() -> void:
	_since = 0
	_window.clear()


## Looks at a tick.
func look(p_matcher: MotionMatcher, p_position: Vector3, p_heading: float, p_delta: float) -> void:
	ticks += 1
	flying += 0 if slide.look(p_matcher.get_soles(), p_delta) else 1
	_since += 1
	_look_at_trunk(p_matcher, p_position, p_heading)


func _look_at_trunk(p_matcher: MotionMatcher, p_position: Vector3, p_heading: float) -> void:
	var pose: PoseSample = PoseSample.new()
	pose.orientations = p_matcher.get_orientations()
	var front: Vector3 = pose.orientation(Limbs.CHEST) * Vector3.BACK
	_window.append(wrapf(atan2(front.x, front.z) - p_heading, -PI, PI))
	if _window.size() > WINDOW:
		_window.remove_at(0)
	if _since < SETTLING:
		return
	var apart: Vector3 = p_matcher.get_root() - p_position
	distances.append(Vector2(apart.x, apart.z).length())
	if _window.size() == WINDOW:
		var sum: float = 0.0
		for value: float in _window:
			sum += value
		headings.append(absf(sum / WINDOW))

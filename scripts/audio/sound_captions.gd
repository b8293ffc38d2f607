class_name SoundCaptions
extends RefCounted
## Captions for users who cannot hear: which sound, from which direction, how far. The same caption
## is not repeated within a few seconds.

## A caption is to be shown; [param p_bearing] is 0 ahead, positive to the right, rad.
signal shown(p_text: String, p_bearing: float)

## Time after which the same caption from the same direction is repeated, s.
const AGAIN_S: float = 4.0
## Level below which a sound has no caption, dB over full scale.
const MIN_LEVEL_DB: float = -42.0
const _SIDES: PackedStringArray = [
	"ahead",
	"ahead right",
	"right",
	"behind right",
	"behind",
	"behind left",
	"left",
	"ahead left",
]

var _said_ms: Dictionary[String, int] = {}


## Takes a sound of [signal SoundVoices.captioned], heard by who looks like this.
func take(p_text: String, p_place: Vector3, p_level_db: float, p_ear: Transform3D) -> void:
	if p_level_db < MIN_LEVEL_DB or p_text == "":
		return
	var bearing: float = bearing_of(p_place, p_ear)
	var key: String = p_text + side_of(bearing)
	var now: int = Time.get_ticks_msec()
	if now - _said_ms.get(key, -100000) < AGAIN_S * 1000.0:
		return
	_said_ms[key] = now
	if _said_ms.size() > 64:
		_said_ms.clear()
	var away: float = p_ear.origin.distance_to(p_place)
	shown.emit("%s, %s, %s" % [p_text, side_of(bearing), describe_distance(away)], bearing)


## In which direction a position is: 0 ahead, positive to the right, rad.
static func bearing_of(p_place: Vector3, p_ear: Transform3D) -> float:
	var to: Vector3 = p_ear.basis.orthonormalized().inverse() * (p_place - p_ear.origin)
	return atan2(to.x, -to.z)


## The same in words.
static func side_of(p_bearing: float) -> String:
	return _SIDES[posmod(roundi(p_bearing / (PI / 4.0)), 8)]


## A distance (m) in as many digits as an ear can tell.
static func describe_distance(p_away: float) -> String:
	if p_away < 3.0:
		return "near"
	var step: float = 5.0 if p_away < 50.0 else (10.0 if p_away < 200.0 else 50.0)
	return "%d m" % roundi(snappedf(p_away, step))

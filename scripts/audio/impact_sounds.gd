class_name ImpactSounds
extends RefCounted
## Sounds of things that hit and rub one another, by what they are made of (the sound key of a
## contact material) and how hard.

## Impulse below which an impact is not heard, and above which it gets no louder, N s.
const MIN_IMPULSE: float = 0.15
const MAX_IMPULSE: float = 2000.0
## Level of an impact of 1 N s relative to its sound, dB, and of the softer material relative to the
## harder one.
const _UNIT_DB: float = -14.0
const _SECOND_DB: float = -5.0
## Most scrapes at once.
const MAX_SCRAPES: int = 12
## Time that a scrape goes on without news, s (they come each 0.1 s, and one may be lost), time
## after which it fades meanwhile, s, and how fast, dB/s.
const SCRAPE_S: float = 0.32
const _FADE_FROM_S: float = 0.22
const _FADE_DB_S: float = 300.0
## Speed (m/s) and force (N) at which a scrape has its recorded level.
const _SCRAPE_SPEED: float = 1.0
const _SCRAPE_FORCE: float = 200.0
## Heavy things sound deeper: share of the pitch for each tenfold impulse, and the bounds.
const _DEEPER: float = 0.10
## What stands for a kind that has no scrape or no step of its own.
const _SCRAPE_AS: Dictionary[StringName, StringName] = {
	&"dirt": &"sand",
	&"gravel": &"sand",
	&"flesh": &"cloth",
	&"glass": &"concrete",
}
const _STEP_AS: Dictionary[StringName, StringName] = {
	&"cloth": &"dirt",
	&"flesh": &"dirt",
	&"rubber": &"wood",
	&"glass": &"concrete",
}
const _KINDS: Array[StringName] = [
	&"cloth",
	&"concrete",
	&"dirt",
	&"flesh",
	&"glass",
	&"gravel",
	&"metal",
	&"rubber",
	&"sand",
	&"wood",
]

var _voices: SoundVoices = null
var _scrapes: Dictionary[int, SoundVoice] = {}
var _silent_s: Dictionary[int, float] = {}


## Plays on such voices.
func _init(p_voices: SoundVoices) -> void:
	_voices = p_voices


## Plays an impact of two materials (sound keys) at a position (m), N s. [param p_pair] stands for
## the two things: what they do within 50 ms is one sound; 0: of the position.
func play_impact(
	p_first: StringName, p_second: StringName, p_place: Vector3, p_impulse: float, p_pair: int = 0
) -> void:
	if not (is_finite(p_impulse) and p_place.is_finite()) or p_impulse < MIN_IMPULSE:
		return
	var impulse: float = minf(p_impulse, MAX_IMPULSE)
	var gain: float = gain_of(impulse)
	var pitch: float = clampf(1.0 - _DEEPER * log(impulse / 10.0) / log(10.0), 0.75, 1.2)
	var pair: int = p_pair if p_pair != 0 else hash(p_place.snappedf(0.25))
	var first: StringName = kind_of(p_first)
	var second: StringName = kind_of(p_second)
	_voices.play_merged(pair, StringName("impact_" + first), p_place, gain, pitch)
	if second != first:
		_voices.play_merged(
			pair ^ 0x5bd1e995, StringName("impact_" + second), p_place, gain + _SECOND_DB, pitch
		)


## How much louder or softer than its sound an impact is, dB: 6 dB for each doubling.
static func gain_of(p_impulse: float) -> float:
	return _UNIT_DB + linear_to_db(clampf(p_impulse, MIN_IMPULSE, MAX_IMPULSE))


## Two things rub at a position (m) with a speed (m/s) and a force (N). Call it as long as they do,
## with the same number of the pair.
func set_scrape(
	p_pair: int,
	p_first: StringName,
	p_second: StringName,
	p_place: Vector3,
	p_speed: float,
	p_force: float
) -> void:
	if not (is_finite(p_speed) and is_finite(p_force) and p_place.is_finite()):
		return
	if not _scrapes.has(p_pair):
		if _scrapes.size() >= MAX_SCRAPES or p_speed < 0.05:
			return
		var kind: StringName = scrape_kind(p_first, p_second)
		var voice: SoundVoice = _voices.start_loop(StringName("scrape_%s_loop" % kind), null)
		if voice == null:
			return
		_scrapes[p_pair] = voice
	var speed: float = clampf(p_speed / _SCRAPE_SPEED, 0.0, 4.0)
	var force: float = clampf(p_force / _SCRAPE_FORCE, 0.0, 10.0)
	_scrapes[p_pair].place = p_place
	_scrapes[p_pair].gain_db = linear_to_db(maxf(speed * sqrt(force), 1e-4))
	_scrapes[p_pair].pitch = clampf(0.8 + 0.2 * speed, 0.8, 1.35)
	_silent_s[p_pair] = 0.0


## Lets scrapes fade and end of which there is no news. Call it each frame, with the time since
## the last, s.
func advance(p_delta: float) -> void:
	for pair: int in _scrapes.keys():
		_silent_s[pair] += p_delta
		if _silent_s[pair] > _FADE_FROM_S:
			# The next news set it anew.
			_scrapes[pair].gain_db -= _FADE_DB_S * p_delta
		if _silent_s[pair] > SCRAPE_S:
			_scrapes[pair].stop()
			_scrapes.erase(pair)
			_silent_s.erase(pair)


## How many scrapes are going on.
func scrape_count() -> int:
	return _scrapes.size()


## A kind that has sounds: another counts as concrete.
static func kind_of(p_key: StringName) -> StringName:
	return p_key if _KINDS.has(p_key) else &"concrete"


## Which of two materials is heard where they rub: the one that rings.
static func scrape_kind(p_first: StringName, p_second: StringName) -> StringName:
	var kinds: Array[StringName] = [kind_of(p_first), kind_of(p_second)]
	for ringing: StringName in [&"metal", &"wood", &"gravel", &"sand", &"dirt", &"rubber"]:
		if kinds.has(ringing):
			return _SCRAPE_AS.get(ringing, ringing)
	return _SCRAPE_AS.get(kinds[0], kinds[0])


## The sound of a step on a material.
static func step_name(p_key: StringName) -> StringName:
	var kind: StringName = kind_of(p_key)
	return StringName("step_" + _STEP_AS.get(kind, kind))

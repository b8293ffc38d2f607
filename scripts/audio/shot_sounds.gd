class_name ShotSounds
extends RefCounted
## Sounds of guns and bursts: near and far takes, the time that sound needs, cracks of bullets.

## Between these distances the far take comes in place of the near one, m.
const NEAR_M: float = 120.0
const FAR_M: float = 400.0


## Plays what is heard of a blast: [param p_name] is that of its takes without _near and _far,
## [param p_age_s] how long it is past.
static func play_blast(
	p_voices: SoundVoices,
	p_name: String,
	p_place: Vector3,
	p_age_s: float = 0.0,
	p_gain_db: float = 0.0
) -> void:
	if not p_place.is_finite():
		return
	var away: float = p_voices.ear().distance_to(p_place)
	var delay: float = maxf(away / SoundVoices.SOUND_SPEED - p_age_s, 0.0)
	var share: float = clampf(inverse_lerp(NEAR_M, FAR_M, away), 0.0, 1.0)
	if share < 1.0:
		var near_db: float = linear_to_db(cos(share * PI / 2.0))
		p_voices.play(StringName(p_name + "_near"), p_place, p_gain_db + near_db, 1.0, delay)
	if share > 0.0:
		var far_db: float = linear_to_db(sin(share * PI / 2.0))
		p_voices.play(StringName(p_name + "_far"), p_place, p_gain_db + far_db, 1.0, delay)


## Plays the crack of a bullet or dart where the listener is beside its path. Returns whether it
## is heard.
static func play_crack(
	p_voices: SoundVoices,
	p_muzzle: Vector3,
	p_velocity: Vector3,
	p_reach_m: float,
	p_age_s: float = 0.0,
	p_gain_db: float = 0.0
) -> bool:
	if not (p_muzzle.is_finite() and p_velocity.is_finite()):
		return false
	var crack: BulletCrack = BulletCrack.of_shot(p_muzzle, p_velocity, p_reach_m, p_voices.ear())
	if not crack.is_heard:
		return false
	var delay: float = maxf(crack.delay_s - p_age_s, 0.0)
	p_voices.play(&"bullet_crack", crack.place, p_gain_db, 1.0, delay)
	return true

class_name BulletCrack
extends RefCounted
## When and from where the shock wave of a bullet reaches an ear: only those beside its path hear
## it, before the muzzle.

## Distance from the path beyond which the crack is not heard, m.
const MAX_BESIDE_M: float = 150.0
## Distance from the muzzle below which the crack is one with the blast, m.
const MIN_AHEAD_M: float = 8.0

## Whether the ear hears it.
var is_heard: bool = false
## How long after the shot, s.
var delay_s: float = 0.0
## From where, m.
var place: Vector3 = Vector3.ZERO
## How near the path is to the ear, m.
var beside_m: float = 0.0


## Works it out for a shot from a muzzle (m) with a velocity (m/s), which flies so far (m), at an
## ear. The path is straight and the speed stays: true enough for some hundred metres.
static func of_shot(
	p_muzzle: Vector3, p_velocity: Vector3, p_reach_m: float, p_ear: Vector3
) -> BulletCrack:
	var crack: BulletCrack = BulletCrack.new()
	var speed: float = p_velocity.length()
	if not is_finite(speed) or speed <= SoundVoices.SOUND_SPEED * 1.02:
		return crack
	var ahead: Vector3 = p_velocity / speed
	var along: float = (p_ear - p_muzzle).dot(ahead)
	crack.beside_m = (p_ear - p_muzzle - ahead * along).length()
	# Half the angle of Mach's cone.
	var angle: float = asin(SoundVoices.SOUND_SPEED / speed)
	var from_m: float = along - crack.beside_m * tan(angle)
	crack.place = p_muzzle + ahead * from_m
	crack.delay_s = (from_m / speed + p_ear.distance_to(crack.place) / SoundVoices.SOUND_SPEED)
	crack.is_heard = (from_m > MIN_AHEAD_M and from_m < p_reach_m and crack.beside_m < MAX_BESIDE_M)
	return crack

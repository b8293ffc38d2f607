class_name FiringSound
extends RefCounted
## Plays the sounds of a shooter's shots: the muzzle, delayed by the speed of sound, the crack of
## passing rounds, and the impacts.

## Length of the path of a bullet and of a shell along which its crack is computed, m.
const _REACH_M: float = 900.0
## Share of bullets that ricochet from a hard surface, and the keys of hard surfaces.
const _RICOCHET_SHARE: float = 0.18
const _HARD: Array[StringName] = [&"metal", &"concrete"]
## Impulse for which the sounds of a bullet's and of a shell's impact were made, N s.
const _BULLET_IMPULSE: float = 12.0
const _SHELL_IMPULSE: float = 900.0

var _voices: SoundVoices = null
var _shells: Shells = null


## Follows the guns of some shells.
func _init(p_voices: SoundVoices, p_shells: Shells) -> void:
	_voices = p_voices
	_shells = p_shells
	p_shells.fired.connect(_on_fired)
	p_shells.struck.connect(_on_struck)


func _on_fired(
	p_ammunition: Ammunition, p_place: Vector3, p_velocity: Vector3, _gun: Node3D
) -> void:
	if not is_instance_valid(_voices):
		return
	var is_bullet: bool = p_ammunition.kind == Ammunition.Kind.BULLET
	ShotSounds.play_blast(_voices, "machine_gun" if is_bullet else "cannon", p_place)
	var louder: float = 0.0 if is_bullet else 12.0
	ShotSounds.play_crack(_voices, p_place, p_velocity, _REACH_M, 0.0, louder)


func _on_struck(
	p_place: Vector3, _normal: Vector3, p_surface: StringName, p_ammunition: Ammunition
) -> void:
	if not is_instance_valid(_voices) or not p_place.is_finite():
		return
	var delay: float = _voices.travel_s(p_place)
	if p_ammunition.blast_radius > 0.0:
		ShotSounds.play_blast(_voices, "explosion", p_place)
		return
	var kind: StringName = ImpactSounds.kind_of(StringName(ContactMaterial.named(p_surface).sound))
	var is_bullet: bool = p_ammunition.kind == Ammunition.Kind.BULLET
	var impulse: float = _BULLET_IMPULSE if is_bullet else _SHELL_IMPULSE
	var gain: float = ImpactSounds.gain_of(impulse)
	_voices.play(StringName("impact_" + kind), p_place, gain, 1.15 if is_bullet else 0.8, delay)
	if is_bullet and _HARD.has(kind) and randf() < _RICOCHET_SHARE:
		_voices.play(&"ricochet", p_place, 0.0, 1.0, delay)

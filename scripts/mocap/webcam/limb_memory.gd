class_name LimbMemory
extends RefCounted
## Limbs that come out of sight and into it again: nothing jumps. What was lost stays as it was for
## a moment, then eases to where it rests; what is found again eases to where it is seen.

## How long a lost limb stays as it was, s, and how fast it then comes to rest, 1/s.
const HOLD_S: float = 0.4
const REST_RATE: float = 2.0
## How long a limb takes from what was remembered to what is seen, s, and back.
const BLEND_S: float = 0.2

# Rotation of each mount to the one above, how much of it is what is seen, and how long it is lost.
var _locals: Dictionary[int, Quaternion] = {}
var _shares: PackedFloat32Array = PackedFloat32Array()
var _lost_s: PackedFloat32Array = PackedFloat32Array()


func _init() -> void:
	_shares.resize(BodyMounts.COUNT)
	_lost_s.resize(BodyMounts.COUNT)


## Changes the mounts of a filled [LimbFiller] of which some are known, a time, s, after the last.
## Those that are not known are taken as at rest.
func ease(r_filler: LimbFiller, p_known: PackedByteArray, p_step_s: float) -> void:
	for mount: int in BodyMounts.COUNT:
		var above: int = BodyMounts.PARENTS[mount]
		if above < 0 or mount == BodyMounts.LEFT_SHOULDER or mount == BodyMounts.RIGHT_SHOULDER:
			continue
		var base: Quaternion = _base_of(above, r_filler)
		var now: Quaternion = (base.inverse() * r_filler.rotations[mount]).normalized()
		var is_known: bool = p_known[mount] != 0
		_lost_s[mount] = 0.0 if is_known else _lost_s[mount] + p_step_s
		var step: float = p_step_s / BLEND_S
		_shares[mount] = clampf(_shares[mount] + (step if is_known else -step), 0.0, 1.0)
		var local: Quaternion = now
		if not _locals.has(mount):
			_shares[mount] = 1.0 if is_known else 0.0
		elif is_known:
			local = _locals[mount].slerp(now, _shares[mount])
		elif _lost_s[mount] < HOLD_S:
			local = _locals[mount]
		else:
			local = _locals[mount].slerp(now, minf(REST_RATE * p_step_s, 1.0))
		_locals[mount] = local.normalized()
		r_filler.set_mount(mount, (base * local).normalized())


## What a mount hangs on: arms on the chest.
static func _base_of(p_above: int, p_filler: LimbFiller) -> Quaternion:
	var is_blade: bool = p_above == BodyMounts.LEFT_SHOULDER or p_above == BodyMounts.RIGHT_SHOULDER
	return p_filler.rotations[BodyMounts.STERNUM if is_blade else p_above]

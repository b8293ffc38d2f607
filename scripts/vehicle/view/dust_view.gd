class_name DustView
extends RefCounted
## Dust that one side's wheels throw up where they touch the ground, by speed and by what the ground
## is made of.

## Speed at which dust begins, and at which there is most, m/s.
const _SLOW: float = 0.8
const _FAST: float = 9.0
## Part of the slip that is added to the speed.
const _SLIP_SHARE: float = 0.7
## Time between two looks at the ground's material, s.
const _LOOK_S: float = 0.2

## Dust that this vehicle throws up, as a share of a tank's, 0 to 1.
var share: float = 1.0
## Dust that is thrown up now, as a share of the most, 0 to 1.
var amount: float = 0.0
## Key of the ground under the rearmost wheel that touches it.
var surface: StringName = ContactMaterial.NO_KEY

var _puffs: LayeredEffect = null
var _first: int = 0
var _count: int = 0
var _until_look: float = 0.0


## Adds the effect below [param p_parent] for the wheels from [param p_first] on.
func configure(p_parent: Node3D, p_first: int, p_count: int) -> void:
	_puffs = LayeredEffect.make("track_dust", false)
	_first = p_first
	_count = p_count
	p_parent.add_child(_puffs)


## Follows the wheels. [param p_track] is the speed of the track, [param p_ground] that of the
## vehicle over the ground, m/s; [param p_vehicle] is where it stands.
func advance(
	p_probe: GroundProbe, p_vehicle: Transform3D, p_track: float, p_ground: float, p_delta: float
) -> void:
	var rear: int = -1
	var front: int = -1
	for wheel: int in range(_first, _first + _count):
		if p_probe.touching[wheel] == 1:
			rear = wheel if rear < 0 else rear
			front = wheel
	_until_look -= p_delta
	if rear < 0:
		amount = 0.0
	else:
		if _until_look <= 0.0:
			_until_look = _LOOK_S
			surface = p_probe.surface_of(rear if p_track >= 0.0 else front)
		var speed: float = absf(p_track) + absf(p_track - p_ground) * _SLIP_SHARE
		var pace: float = clampf((speed - _SLOW) / (_FAST - _SLOW), 0.0, 1.0)
		amount = ContactMaterial.named(surface).dust * pace * share
		if amount > 0.0:
			_place(p_probe.points[rear], p_probe.points[front], p_vehicle, p_track)
			_puffs.set_input(&"speed", speed)
	_show()


## Nobody sees it, or it touches nothing.
func stop() -> void:
	amount = 0.0
	_show()


func _place(p_rear: Vector3, p_front: Vector3, p_vehicle: Transform3D, p_track: float) -> void:
	var ahead: Vector3 = -p_vehicle.basis.z * (1.0 if p_track >= 0.0 else -1.0)
	# Most of it rises behind, where the track leaves the ground.
	var middle: Vector3 = p_rear.lerp(p_front, 0.35 if p_track >= 0.0 else 0.65)
	_puffs.global_transform = Transform3D(
		Basis.looking_at(ahead, p_vehicle.basis.y), middle + p_vehicle.basis.y * 0.15
	)
	_puffs.set_input(&"reach", maxf(p_rear.distance_to(p_front) * 1.2, 0.4))


func _show() -> void:
	_puffs.emitting = amount > 0.02
	if _puffs.emitting:
		_puffs.share = maxf(amount, 0.05)
		_puffs.set_input(&"earth", ContactMaterial.named(surface).dust_color)

class_name DustView
extends RefCounted
## Dust that one side's wheels throw up where they touch the ground, by speed and by what the ground
## is made of.

## Speed from which on there is dust, and of the most dust, m/s.
const _SLOW: float = 0.8
const _FAST: float = 9.0
## Share of slip that counts as speed.
const _SLIP_SHARE: float = 0.7
## How often it looks what the ground is made of, s.
const _LOOK_S: float = 0.2

## Share of a tank's dust that such a vehicle throws up, 0 to 1.
var share: float = 1.0
## Share of the most dust, 0 to 1, that is thrown up now.
var amount: float = 0.0
## Key of the ground under the rearmost wheel that touches it.
var surface: StringName = ContactMaterial.NO_KEY

var _puffs: GPUParticles3D = null
var _motion: ParticleProcessMaterial = null
var _first: int = 0
var _count: int = 0
var _until_look: float = 0.0


## Adds [param p_puffs] below [param p_parent] for the wheels from [param p_first] on.
func configure(p_parent: Node3D, p_puffs: GPUParticles3D, p_first: int, p_count: int) -> void:
	_puffs = p_puffs
	_motion = p_puffs.process_material as ParticleProcessMaterial
	_first = p_first
	_count = p_count
	p_parent.add_child(p_puffs)


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
		amount = GroundLooks.dust_of(surface) * pace * share
		if amount > 0.0:
			_place(p_probe.points[rear], p_probe.points[front], p_vehicle, p_track)
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
	_motion.emission_box_extents.z = maxf(p_rear.distance_to(p_front) * 0.6, 0.2)


func _show() -> void:
	var is_dusty: bool = amount > 0.02
	if _puffs.emitting != is_dusty:
		_puffs.emitting = is_dusty
	if is_dusty:
		_puffs.amount_ratio = clampf(amount * Quality.tier.weather, 0.05, 1.0)
		var color: Color = GroundLooks.colour_of(surface)
		color.a = lerpf(0.55, 1.0, amount)
		if not _motion.color.is_equal_approx(color):
			_motion.color = color

class_name FiringView
extends Node3D
## What is seen of a vehicle's shots: the barrel recoils, flash and smoke at the muzzle, dust below
## it, tracers, and what flies up where something is hit. It costs no bytes beside the events.

const _EFFECTS: String = "res://scenes/vehicle/firing/effects/"
## How many of each effect there are.
const _COUNTS: Dictionary[StringName, int] = {
	&"muzzle_flash": 3,
	&"muzzle_smoke": 2,
	&"muzzle_dust": 2,
	&"impact_dust": 6,
	&"impact_sparks": 5,
	&"blast": 2,
	&"blast_smoke": 2,
}
## Every so many rounds of a machine gun shine.
const _TRACER_EVERY: int = 5
## Light of a flash, and how fast it fades, 1/s.
const _FLASH_ENERGY: float = 8.0
const _FLASH_FADE: float = 22.0
## Dust rises below a muzzle that is no higher than this above the ground, m.
const _DUST_HEIGHT_M: float = 4.0
## Farther away flashes and bursts are not shown, m.
const _AWAY_M: float = 1500.0
## Size of a bullet's burst beside a shell's, and of the flash of a machine gun.
const _BULLET_SIZE: float = 0.3
## Width of marks, m: of a bullet, of a dart, of what bursts.
const _MARKS_M: Array[float] = [0.9, 5.0, 0.14]
## Surfaces that give sparks, and those that give no dust.
const _SPARKING: Array[StringName] = [&"metal", &"stone", &"rock", &"concrete", &"asphalt"]
const _DUST_COLOURS: Dictionary[StringName, Color] = {
	&"plaster": Color(0.62, 0.52, 0.38),
	&"concrete": Color(0.42, 0.40, 0.36),
	&"stone": Color(0.42, 0.38, 0.32),
	&"asphalt": Color(0.25, 0.23, 0.2),
	&"brick": Color(0.42, 0.24, 0.14),
	&"wood": Color(0.34, 0.22, 0.11),
	&"metal": Color(0.2, 0.19, 0.18),
	&"person": Color(0.3, 0.25, 0.2),
}

## Tracers in the air.
var tracers: Tracers = Tracers.new()
## Marks in walls and ground.
var marks: ImpactMarks = ImpactMarks.new()

var _shells: Shells = null
var _pools: Dictionary[StringName, BurstPool] = {}
var _flash: OmniLight3D = OmniLight3D.new()
var _rounds: int = 0


## One for the guns of a vehicle; it is to be added below the vehicle.
static func create(p_shells: Shells) -> FiringView:
	var view: FiringView = FiringView.new()
	view._shells = p_shells
	return view


func _ready() -> void:
	for effect: StringName in _COUNTS:
		_pools[effect] = BurstPool.new(self, load(_EFFECTS + effect + ".tscn"), _COUNTS[effect])
	tracers.configure(self, _shells.vehicle)
	marks.configure(self)
	_flash.light_color = Color(1.0, 0.72, 0.4)
	_flash.omni_range = 14.0
	_flash.light_specular = 0.2
	_flash.top_level = true
	_flash.visible = false
	add_child(_flash)
	for gun: VehicleGun in _shells.guns:
		gun.fired.connect(_on_fired.bind(gun))
	_shells.struck.connect(_on_struck)


func _process(p_delta: float) -> void:
	marks.advance(p_delta)
	tracers.advance(p_delta, _eye(), get_world_3d().direct_space_state)
	if _flash.visible:
		_flash.light_energy *= exp(-_FLASH_FADE * p_delta)
		_flash.visible = _flash.light_energy > 0.05


func _on_fired(
	p_ammunition: Ammunition, p_place: Vector3, p_velocity: Vector3, p_gun: VehicleGun
) -> void:
	_rounds += 1
	var is_bullet: bool = p_ammunition.kind == Ammunition.Kind.BULLET
	if p_ammunition.has_tracer and (not is_bullet or _rounds % _TRACER_EVERY == 0):
		tracers.add(p_ammunition, p_place, p_velocity)
	var muzzle: Transform3D = p_gun.global_transform.orthonormalized()
	if not is_bullet:
		var view: VehicleView = _find_view()
		if view != null:
			view.show_shot()
	if _eye().distance_to(muzzle.origin) > _AWAY_M:
		return
	_pools[&"muzzle_flash"].play(muzzle, _BULLET_SIZE if is_bullet else 1.0)
	_flash.global_position = muzzle.origin - muzzle.basis.z
	_flash.light_energy = _FLASH_ENERGY * (_BULLET_SIZE if is_bullet else 1.0)
	_flash.visible = true
	if not is_bullet:
		_pools[&"muzzle_smoke"].play(muzzle)
		_raise_dust(muzzle.origin)


## A ring of dust where the blast of the muzzle meets soft ground.
func _raise_dust(p_muzzle: Vector3) -> void:
	var query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		p_muzzle, p_muzzle + Vector3.DOWN * _DUST_HEIGHT_M, PhysicsLayers.STATIC
	)
	var hit: Dictionary = get_world_3d().direct_space_state.intersect_ray(query)
	if hit.is_empty():
		return
	var place: Vector3 = hit["position"]
	var surface: StringName = StringName(ContactMaterial.at(hit["collider"], place).key)
	var share: float = GroundLooks.dust_of(surface)
	if share > 0.05:
		var normal: Vector3 = hit["normal"]
		var colour: Color = GroundLooks.colour_of(surface)
		colour.a = lerpf(0.3, 1.0, share)
		_pools[&"muzzle_dust"].play(
			Transform3D(ImpactMarks.upward(normal), place + normal * 0.2), 1.0, colour
		)


func _on_struck(
	p_place: Vector3, p_normal: Vector3, p_surface: StringName, p_ammunition: Ammunition
) -> void:
	tracers.end(p_ammunition, p_place)
	if _eye().distance_to(p_place) > _AWAY_M or not p_normal.is_normalized():
		return
	var is_bullet: bool = p_ammunition.kind == Ammunition.Kind.BULLET
	var size: float = _BULLET_SIZE if is_bullet else 1.3
	var at: Transform3D = Transform3D(ImpactMarks.upward(p_normal), p_place)
	var colour: Color = _DUST_COLOURS.get(p_surface, GroundLooks.colour_of(p_surface))
	_pools[&"impact_dust"].play(at, size, colour)
	if p_surface in _SPARKING:
		_pools[&"impact_sparks"].play(at, size)
	if p_ammunition.blast_radius > 0.0:
		var large: float = p_ammunition.blast_radius / 12.0
		_pools[&"blast"].play(at, large)
		_pools[&"blast_smoke"].play(at, large)
		_flash.global_position = p_place + p_normal
		_flash.light_energy = _FLASH_ENERGY
		_flash.visible = true
	# What moves takes no mark along.
	if p_surface != &"person" and _is_level(p_place, p_normal):
		marks.make(p_place, p_normal, _MARKS_M[p_ammunition.kind])


func _is_level(p_place: Vector3, p_normal: Vector3) -> bool:
	var query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		p_place + p_normal * 0.1, p_place - p_normal * 0.2, PhysicsLayers.STATIC
	)
	return not get_world_3d().direct_space_state.intersect_ray(query).is_empty()


func _find_view() -> VehicleView:
	for child: Node in get_parent().get_children():
		if child is VehicleView:
			return child
	return null


func _eye() -> Vector3:
	var camera: Camera3D = get_viewport().get_camera_3d()
	return camera.global_position if camera != null else global_position

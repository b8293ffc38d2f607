class_name FiringView
extends Node3D
## Shows a shooter's shots: flash and smoke at the muzzle, dust below it, tracers, and the effects
## of impacts. All of it follows from the events: it needs no bytes of its own.

## How many of each effect are made beforehand, for all shooters of a level.
const _PREPARED: Dictionary[String, int] = {
	"muzzle_flash": 6,
	"muzzle_smoke": 3,
	"muzzle_dust": 3,
	"impact": 10,
	"impact_metal": 6,
	"impact_wood": 4,
	"impact_soft": 4,
	"impact_glass": 2,
	"sparks": 6,
	"debris": 3,
	"explosion": 3,
}
## Rounds of a machine gun from one tracer to the next.
const _TRACER_EVERY: int = 5
## Light of a flash, and how fast it fades, 1/s.
const _FLASH_ENERGY: float = 8.0
const _FLASH_FADE: float = 22.0
## Dust rises below a muzzle that is no higher than this above the ground, m.
const _DUST_HEIGHT_M: float = 4.0
## Distance from which on flashes and bursts are not shown, m.
const _MAX_DISTANCE_M: float = 1500.0
## Size of a bullet's burst beside a shell's, and of the flash of a machine gun.
const _BULLET_SIZE: float = 0.3
const _BULLET_FLASH: float = 0.15
## Blast radius at which a burst's effect has the size that it was made in, m.
const _BLAST_M: float = 12.0
## Width of marks, m: of a bullet, of a dart, of what bursts.
const _MARKS_M: Array[float] = [0.9, 5.0, 0.14]
## Depth below an impact to which the ground is searched, m: pieces of the impact bounce on it.
const _GROUND_M: float = 20.0
## Materials whose impacts have no effect of their own, and whose they take instead.
const _EFFECT_KEYS: Dictionary[String, String] = {
	"person": "soft", "cloth": "soft", "leaf": "soft", "rubber": "soft"
}

## Tracers in the air.
var tracers: Tracers = Tracers.new()
## Marks in walls and ground.
var marks: ImpactMarks = ImpactMarks.new()

var _shells: Shells = null
var _player: EffectPlayer = null
var _flash: OmniLight3D = OmniLight3D.new()
var _rounds: int = 0
## How long it stays after the shooter is gone, s; negative while the shooter is there.
var _left_s: float = -1.0


## A view for a shooter's guns. It belongs into the shooter's world, but not below the shooter: see
## [method show_shots].
static func create(p_shells: Shells) -> FiringView:
	var view: FiringView = FiringView.new()
	view._shells = p_shells
	return view


## Shows the shots of some shells from the next frame on, where there is a display: once, however
## often it is called.
static func show_shots(p_shells: Shells) -> void:
	if not p_shells.is_shown and DisplayServer.get_name() != "headless":
		p_shells.is_shown = true
		begin.call_deferred(p_shells)


## Adds a view where the shooter's world plays its effects: shots stay visible when the shooter is
## gone.
static func begin(p_shells: Shells) -> void:
	if p_shells.is_inside_tree():
		EffectPlayer.of(p_shells.shooter).add_child(create(p_shells))


func _ready() -> void:
	_player = EffectPlayer.of(self)
	for effect: String in _PREPARED:
		_player.prepare(effect, _PREPARED[effect])
	tracers.configure(self, _shells.shooter)
	marks.configure(self)
	_flash.light_color = Color(1.0, 0.72, 0.4)
	_flash.omni_range = 14.0
	_flash.light_specular = 0.2
	_flash.top_level = true
	_flash.visible = false
	add_child(_flash)
	_shells.fired.connect(_on_fired)
	_shells.struck.connect(_on_struck)
	_shells.tree_exiting.connect(_on_shooter_gone)


func _process(p_delta: float) -> void:
	marks.advance(p_delta)
	tracers.advance(p_delta, _eye(), get_world_3d().direct_space_state)
	if _flash.visible:
		_flash.light_energy *= exp(-_FLASH_FADE * p_delta)
		_flash.visible = _flash.light_energy > 0.05
	if _left_s >= 0.0:
		_left_s -= p_delta
		if _left_s < 0.0:
			queue_free()


func _on_fired(
	p_ammunition: Ammunition, p_place: Vector3, p_velocity: Vector3, p_gun: Node3D
) -> void:
	_rounds += 1
	var is_bullet: bool = p_ammunition.kind == Ammunition.Kind.BULLET
	if p_ammunition.has_tracer and (not is_bullet or _rounds % _TRACER_EVERY == 0):
		tracers.add(p_ammunition, p_place, p_velocity)
	var muzzle: Transform3D = p_gun.global_transform.orthonormalized()
	if _eye().distance_to(muzzle.origin) > _MAX_DISTANCE_M:
		return
	_player.play("muzzle_flash", muzzle, _BULLET_FLASH if is_bullet else 1.0)
	_flash.global_position = muzzle.origin - muzzle.basis.z
	_flash.light_energy = _FLASH_ENERGY * (_BULLET_SIZE if is_bullet else 1.0)
	_flash.visible = true
	if not is_bullet:
		_player.play("muzzle_smoke", muzzle)
		_raise_dust(muzzle.origin)


## A ring of dust where the blast of the muzzle meets soft ground.
func _raise_dust(p_muzzle: Vector3) -> void:
	var hit: Dictionary = _cast(p_muzzle, p_muzzle + Vector3.DOWN * _DUST_HEIGHT_M)
	if hit.is_empty():
		return
	var place: Vector3 = hit["position"]
	var ground: ContactMaterial = ContactMaterial.at(hit["collider"], place)
	if ground.dust <= 0.05:
		return
	var normal: Vector3 = hit["normal"]
	_player.play(
		"muzzle_dust",
		Transform3D(ImpactMarks.upward(normal), place + normal * 0.2),
		1.0,
		{&"earth": ground.dust_color, &"amount": lerpf(0.3, 1.0, ground.dust)}
	)


func _on_struck(
	p_place: Vector3, p_normal: Vector3, p_surface: StringName, p_ammunition: Ammunition
) -> void:
	tracers.end(p_ammunition, p_place)
	if _eye().distance_to(p_place) > _MAX_DISTANCE_M or not p_normal.is_normalized():
		return
	var is_bullet: bool = p_ammunition.kind == Ammunition.Kind.BULLET
	var size: float = _BULLET_SIZE if is_bullet else 1.3
	var at: Transform3D = Transform3D(ImpactMarks.upward(p_normal), p_place)
	_show_impact(at, size, ContactMaterial.named(p_surface), not is_bullet)
	if p_ammunition.blast_radius > 0.0:
		_player.play("explosion", at, p_ammunition.blast_radius / _BLAST_M)
		_flash.global_position = p_place + p_normal
		_flash.light_energy = _FLASH_ENERGY
		_flash.visible = true
	# What moves takes no mark along.
	if p_surface != ContactMaterial.PERSON and _is_level(p_place, p_normal):
		marks.make(p_place, p_normal, _MARKS_M[p_ammunition.kind])


## What flies up where something is hit, by what that is made of.
func _show_impact(
	p_at: Transform3D, p_size: float, p_material: ContactMaterial, p_has_debris: bool
) -> void:
	var effect: String = "impact_" + _EFFECT_KEYS.get(p_material.key, p_material.key)
	if not EffectLibrary.shared().has(effect):
		effect = "impact"
	var inputs: Dictionary[StringName, Variant] = {
		&"tint": p_material.dust_color, &"ground": _ground_below(p_at)
	}
	_player.play(effect, p_at, p_size, inputs)
	if p_material.sparks > 0.0:
		_player.play("sparks", p_at, p_size * p_material.sparks, inputs)
	if p_has_debris:
		_player.play("debris", p_at, p_size, inputs)


## Height of the ground below an impact, m.
func _ground_below(p_at: Transform3D) -> float:
	var from: Vector3 = p_at.origin + p_at.basis.y * 0.2
	var hit: Dictionary = _cast(from, from + Vector3.DOWN * _GROUND_M)
	return (hit["position"] as Vector3).y if not hit.is_empty() else p_at.origin.y - _GROUND_M


## The marks stay until they have faded.
func _on_shooter_gone() -> void:
	_left_s = ImpactMarks.LASTING_S if marks.made > 0 else Shells.LIFE_S


func _is_level(p_place: Vector3, p_normal: Vector3) -> bool:
	return not _cast(p_place + p_normal * 0.1, p_place - p_normal * 0.2).is_empty()


## What a ray meets of what never moves.
func _cast(p_from: Vector3, p_to: Vector3) -> Dictionary:
	var query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		p_from, p_to, PhysicsLayers.STATIC
	)
	return get_world_3d().direct_space_state.intersect_ray(query)


func _eye() -> Vector3:
	var camera: Camera3D = get_viewport().get_camera_3d()
	return camera.global_position if camera != null else global_position

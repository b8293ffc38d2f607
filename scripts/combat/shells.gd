@tool
@icon("res://scenes/combat/icons/shells.svg")
class_name Shells
extends Node
## Simulates the rounds of one shooter's guns on the server, and signals on every machine what is
## fired and where it hits.
##
## The path of a shell is not sent: the event [constant FIRED] carries its start, and each client
## computes its flight by the same arithmetic. Bullets of machine guns have no such event, only some
## of their impacts.

## A shell or bullet hit something: on every machine, on a client at the tick that it shows.
signal struck(
	p_position: Vector3, p_normal: Vector3, p_surface: StringName, p_ammunition: Ammunition
)
## A shell left the muzzle (not a machine gun's bullet): on every machine.
signal launched(p_ammunition: Ammunition, p_position: Vector3, p_velocity: Vector3)
## A gun has fired, see [signal Gun.fired]: on every machine. The node is the gun.
signal fired(p_ammunition: Ammunition, p_position: Vector3, p_velocity: Vector3, p_gun: Node3D)

## What was hit: goes over the wire with an impact.
enum Struck {
	## The level.
	GROUND,
	## Something that can be moved.
	THING,
	## A person.
	PERSON,
	## A vehicle.
	VEHICLE,
}

## Group of the bodies that count as vehicles.
const VEHICLES: StringName = &"vehicles"
## Events: a shell is fired; a shell has hit; a bullet has hit.
const FIRED: StringName = &"fired"
const IMPACT: StringName = &"impact"
const BULLET_IMPACT: StringName = &"bullet_impact"
## How many values each has.
const _VALUES: Dictionary[StringName, int] = {FIRED: 7, IMPACT: 8, BULLET_IMPACT: 8}
## Time after which a shell is removed, s, and depth below the level's origin, m.
const LIFE_S: float = 10.0
const LOWEST_M: float = -400.0
## Greatest speed of a round that the event can carry, m/s.
const MAX_SPEED: float = 2600.0
## Most shells of a shooter in the air: what comes first hits first.
const MAX_FLYING: int = 256
## Most impacts of bullets that are sent in a tick.
const MAX_BULLET_IMPACTS: int = 3
## Surfaces by their number on the wire. Append only; the first stands for what is not here.
const SURFACES: Array[StringName] = [
	&"stone",
	&"plaster",
	&"concrete",
	&"brick",
	&"wood",
	&"metal",
	&"cloth",
	&"dirt",
	&"sand",
	&"asphalt",
	&"rock",
	&"leaf",
	&"gravel",
	&"glass",
	&"rubber",
	&"person",
]

## The body that fires: its own shells do not meet it.
@export var shooter: PhysicsBody3D = null:
	set(p_value):
		shooter = p_value
		update_configuration_warnings()
## Its entity, whose events tell of shots and hits.
@export var entity: Entity = null:
	set(p_value):
		entity = p_value
		update_configuration_warnings()

## All kinds of rounds that its guns fire, by their number on the wire.
var kinds: Array[Ammunition] = []
## All bodies of the shooter, where it has more than one: [code]func() -> Array[RID][/code].
var own_bodies: Callable = Callable()
## Whether [FiringView] shows its shots.
var is_shown: bool = false

var _flying: Array[Shell] = []
var _query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.new()
var _bullet_impacts: int = 0


func _ready() -> void:
	if Engine.is_editor_hint() or shooter == null or entity == null:
		return
	_query.collision_mask = PhysicsLayers.ALL
	_query.hit_from_inside = false
	entity.happened.connect(_on_happened)


func _physics_process(p_delta: float) -> void:
	_bullet_impacts = 0
	if Engine.is_editor_hint() or _flying.is_empty():
		return
	_query.exclude = own_bodies.call() if own_bodies.is_valid() else [shooter.get_rid()]
	var space: PhysicsDirectSpaceState3D = shooter.get_world_3d().direct_space_state
	var left: Array[Shell] = []
	for shell: Shell in _flying:
		if _move(shell, space, p_delta):
			left.append(shell)
	_flying = left


func _get_configuration_warnings() -> PackedStringArray:
	if shooter == null:
		return ["It needs the body whose guns fire: choose one in the inspector."]
	if entity == null:
		return ["It needs the Entity of that body: choose one in the inspector."]
	for event: StringName in [FIRED, IMPACT, BULLET_IMPACT]:
		if entity.type != null and entity.type.find_event(event) < 0:
			return ["The type '%s' needs an event '%s'." % [entity.type.name, event]]
	return []


## Takes a gun's kinds of rounds. Guns call it as they become ready: on all machines in one order.
func register(p_kinds: Array[Ammunition]) -> void:
	for ammunition: Ammunition in p_kinds:
		if not kinds.has(ammunition):
			kinds.append(ammunition)


## Fires a round on the server: from the breech, through the muzzle (m, world), with a velocity
## (m/s, world). Returns false where that makes no sense.
func launch(
	p_ammunition: Ammunition, p_breech: Vector3, p_muzzle: Vector3, p_velocity: Vector3
) -> bool:
	var is_sound: bool = p_breech.is_finite() and p_muzzle.is_finite() and p_velocity.is_finite()
	var kind: int = kinds.find(p_ammunition)
	if kind < 0 or not is_sound or p_velocity.length() > MAX_SPEED:
		return false
	if _flying.size() >= MAX_FLYING:
		return false
	var values: PackedFloat32Array = _quantized(kind, p_muzzle, p_velocity)
	var flight: ShellFlight = p_ammunition.make_flight()
	if flight == null or not flight.launch(_place_of(values), _velocity_of(values)):
		return false
	var shell: Shell = Shell.new()
	shell.ammunition = p_ammunition
	shell.flight = flight
	shell.from = p_breech
	_flying.append(shell)
	if p_ammunition.kind != Ammunition.Kind.BULLET:
		_tell(FIRED, values)
	return true


## Shells in the air.
func flying() -> Array[Shell]:
	return _flying


## The number of a surface on the wire.
static func number_of(p_surface: StringName) -> int:
	return maxi(SURFACES.find(p_surface), 0)


## Yaw and pitch of a direction, rad: from -Z, anticlockwise seen from above; up is positive.
static func angles_of(p_direction: Vector3) -> Vector2:
	if p_direction.is_zero_approx():
		return Vector2.ZERO
	var level: float = Vector2(p_direction.x, p_direction.z).length()
	return Vector2(atan2(-p_direction.x, -p_direction.z), atan2(p_direction.y, level))


## The unit vector of such angles.
static func direction_of(p_angles: Vector2) -> Vector3:
	var level: float = cos(p_angles.y)
	return Vector3(-level * sin(p_angles.x), sin(p_angles.y), -level * cos(p_angles.x))


## Whether it flies on.
func _move(p_shell: Shell, p_space: PhysicsDirectSpaceState3D, p_delta: float) -> bool:
	p_shell.flight.advance(p_delta)
	var place: Vector3 = p_shell.flight.get_position()
	_query.from = p_shell.from
	_query.to = place
	var hit: Dictionary = p_space.intersect_ray(_query)
	p_shell.from = place
	if hit.is_empty():
		return p_shell.flight.get_age() < LIFE_S and place.y > LOWEST_M
	_strike(p_shell, hit, p_space)
	return false


func _strike(p_shell: Shell, p_hit: Dictionary, p_space: PhysicsDirectSpaceState3D) -> void:
	var ammunition: Ammunition = p_shell.ammunition
	var velocity: Vector3 = p_shell.flight.get_velocity()
	var place: Vector3 = p_hit["position"]
	var normal: Vector3 = p_hit["normal"]
	var collider: Variant = p_hit["collider"]
	var what: Struck = Struck.GROUND
	var surface: StringName = ContactMaterial.NO_KEY
	# What was freed in this tick is still in the space.
	if is_instance_valid(collider):
		what = _what_is(collider)
		surface = _surface_of(collider, place, what)
		var impulse: float = ammunition.mass * ammunition.impulse_factor
		ShellHits.push(collider, velocity * impulse, place)
		var armour: Armour = null
		if what == Struck.VEHICLE:
			armour = Armour.find_in(collider as Node)
		if armour != null:
			armour.take_hit(ammunition, velocity, place, normal)
	if ammunition.blast_radius > 0.0:
		ShellHits.burst(p_space, place + normal * 0.05, ammunition)
	_tell_impact(ammunition, place, normal, surface, what)


func _tell_impact(
	p_ammunition: Ammunition,
	p_place: Vector3,
	p_normal: Vector3,
	p_surface: StringName,
	p_what: Struck
) -> void:
	var event: StringName = IMPACT
	if p_ammunition.kind == Ammunition.Kind.BULLET:
		event = BULLET_IMPACT
		_bullet_impacts += 1
		if _bullet_impacts > MAX_BULLET_IMPACTS:
			return
	var angles: Vector2 = angles_of(p_normal)
	_tell(
		event,
		[
			kinds.find(p_ammunition),
			p_place.x,
			p_place.y,
			p_place.z,
			angles.x,
			angles.y,
			number_of(p_surface),
			p_what,
		]
	)


func _tell(p_event: StringName, p_values: PackedFloat32Array) -> void:
	if entity.is_authority() and entity.type.find_event(p_event) >= 0:
		entity.send_event(p_event, p_values)


func _on_happened(p_event: StringName, p_values: PackedFloat32Array) -> void:
	# A server of another version may have other values and other rounds.
	if not _VALUES.has(p_event) or p_values.size() < _VALUES[p_event]:
		return
	var kind: int = int(p_values[0])
	if kind < 0 or kind >= kinds.size():
		return
	if p_event != FIRED:
		var surface: StringName = SURFACES[clampi(int(p_values[6]), 0, SURFACES.size() - 1)]
		var normal: Vector3 = direction_of(Vector2(p_values[4], p_values[5]))
		struck.emit(_place_of(p_values), normal, surface, kinds[kind])
		return
	var velocity: Vector3 = _velocity_of(p_values)
	launched.emit(kinds[kind], _place_of(p_values), velocity)


## The values of a shot as clients get them: the server flies the same shell.
func _quantized(p_kind: int, p_muzzle: Vector3, p_velocity: Vector3) -> PackedFloat32Array:
	var angles: Vector2 = angles_of(p_velocity)
	var values: PackedFloat32Array = [
		p_kind, p_muzzle.x, p_muzzle.y, p_muzzle.z, angles.x, angles.y, p_velocity.length()
	]
	var event: int = entity.type.find_event(FIRED) if entity.type != null else -1
	if event >= 0:
		var fields: Array[EntityField] = entity.type.events[event].fields
		for index: int in mini(fields.size(), values.size()):
			values[index] = fields[index].quantize(values[index])
	return values


static func _place_of(p_values: PackedFloat32Array) -> Vector3:
	return Vector3(p_values[1], p_values[2], p_values[3])


static func _velocity_of(p_values: PackedFloat32Array) -> Vector3:
	return direction_of(Vector2(p_values[4], p_values[5])) * p_values[6]


static func _what_is(p_collider: Object) -> Struck:
	if p_collider is Node and (p_collider as Node).is_in_group(VEHICLES):
		return Struck.VEHICLE
	if p_collider is PhysicalBone3D:
		return Struck.PERSON
	return Struck.THING if p_collider is RigidBody3D else Struck.GROUND


static func _surface_of(p_collider: Object, p_place: Vector3, p_what: Struck) -> StringName:
	match p_what:
		Struck.VEHICLE:
			return &"metal"
		Struck.PERSON:
			return ContactMaterial.PERSON
	return StringName(ContactMaterial.at(p_collider, p_place).key)

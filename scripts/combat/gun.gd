@tool
@icon("res://scenes/combat/icons/gun.svg")
class_name Gun
extends Marker3D
## A gun of whatever carries it: it stands at the muzzle and fires along its own -Z.
##
## On the server it takes the commands of its seat, loads, fires through [Shells] and kicks what
## carries it: a subclass such as [code]VehicleGun[/code] says what that is. What everybody may know
## of it are fields of the entity. A machine gun ([member is_automatic]) fires while its trigger is
## held: it lets go when its seat is left, and after [constant MAX_BURST_S] unless it is commanded
## again, as a client may vanish with a finger on it.

## A round leaves the muzzle (m and m/s, world): on every machine, on a client when it is seen. The
## rounds of a machine gun are a client's own guess, as they cost no bytes.
signal fired(p_ammunition: Ammunition, p_position: Vector3, p_velocity: Vector3)

## How long the kick of a large gun lasts: its barrel recoils meanwhile, s.
const KICK_S: float = 0.05
## The longest burst for one command, s.
const MAX_BURST_S: float = 5.0
## Most rounds that a machine gun makes up for in a tick.
const _MAX_IN_TICK: int = 4

## The entity of what carries it.
@export var entity: Entity = null
## What flies its rounds.
@export var shells: Shells = null:
	set(p_value):
		shells = p_value
		update_configuration_warnings()
## The seat of whoever fires it.
@export var seat: Seat = null
## The kinds of rounds that it fires.
@export var ammunition: Array[Ammunition] = []:
	set(p_value):
		ammunition = p_value
		update_configuration_warnings()
## How many there are of each kind.
@export var stowed: PackedInt32Array = [40]
## Length of the barrel behind the muzzle, m.
@export_range(0.1, 10.0, 0.01, "suffix:m") var barrel_length: float = 5.3
## How far shots scatter: the standard deviation in each direction, mrad.
@export_range(0.0, 20.0, 0.01, "suffix:mrad") var dispersion: float = 0.2
## Seed of the scatter: the same shots scatter alike again.
@export var scatter_seed: int = 1

@export_group("Loading")
## How long it takes to load, s.
@export_range(0.0, 60.0, 0.1, "suffix:s") var loading_time: float = 6.0
## Whether it fires on while the trigger is held.
@export var is_automatic: bool = false
## Rounds in a minute, of one that is automatic.
@export_range(30.0, 3000.0, 10.0, "suffix:1/min") var rate: float = 600.0

@export_group("Names in the type")
## Command that fires it; with a value, 0 or 1, where it is automatic.
@export var fire_command: StringName = &"fire"
## Command with the kind of round to load from now on.
@export var load_command: StringName = &"load"
## Field from 0, empty, to 1, loaded. Empty names have no field.
@export var loaded_field: StringName = &"loaded"
## Field with the kind of round that is loaded.
@export var ammunition_field: StringName = &"ammunition"
## Field with how many rounds of it are left.
@export var rounds_field: StringName = &"rounds"
## Field that says whether it fires, where it is automatic.
@export var firing_field: StringName = &""

## How far it is loaded, 0 to 1.
var loaded: float = 1.0
## The kind of round that is loaded: an index of [member ammunition].
var chosen: int = 0
## Rounds left of each kind. On the server.
var left: PackedInt32Array = []
## Whether it fires at this moment, where it is automatic.
var is_firing: bool = false

var _chance: RandomNumberGenerator = RandomNumberGenerator.new()
var _held_s: float = 0.0
var _until_round: float = 0.0
var _kick: Vector3 = Vector3.ZERO
var _kick_s: float = 0.0


func _ready() -> void:
	if Engine.is_editor_hint():
		return
	_chance.seed = scatter_seed
	left = stowed.duplicate()
	left.resize(ammunition.size())
	if entity == null or shells == null:
		return
	for kind: Ammunition in ammunition:
		if kind == null or kind.find_fault() != "":
			var why: String = "it is missing" if kind == null else kind.find_fault()
			Log.error("combat", "%s cannot fire a round: %s" % [get_path(), why])
	shells.register(ammunition)
	shells.launched.connect(_on_launched)
	FiringView.show_shots(shells)
	entity.commanded.connect(_on_commanded)
	entity.field_changed.connect(_on_field_changed)
	entity.started.connect(_on_started)
	if seat != null:
		seat.occupied.connect(_on_seat_changed)


func _process(p_delta: float) -> void:
	# The server's own shots are seen where it has a display.
	if Engine.is_editor_hint() or not is_firing or entity == null or entity.is_authority():
		return
	for _round: int in _rounds_due(p_delta):
		_tell_fired(ammunition[chosen], global_position, _velocity())


func _physics_process(p_delta: float) -> void:
	if Engine.is_editor_hint() or entity == null or not entity.is_authority():
		return
	_give_kick(p_delta)
	if is_automatic:
		_fire_on(p_delta)
	elif loaded < 1.0 and rounds() > 0 and not is_dead():
		loaded = 1.0 if loading_time <= 0.0 else minf(loaded + p_delta / loading_time, 1.0)
		_set_field(loaded_field, loaded)


func _get_configuration_warnings() -> PackedStringArray:
	if entity == null:
		return ["It needs the Entity of what carries it: choose one in the inspector."]
	if shells == null:
		return ["It needs a Shells node that flies its rounds: choose one in the inspector."]
	if ammunition.is_empty() or ammunition.has(null):
		return ["It needs at least one kind of Ammunition, and no empty ones."]
	for kind: Ammunition in ammunition:
		if kind.find_fault() != "":
			return ["Its ammunition '%s' makes no sense: %s." % [kind.title, kind.find_fault()]]
	return []


## Rounds left of the kind that is chosen.
func rounds() -> int:
	return left[chosen] if chosen < left.size() else 0


## Whether nothing can be fired any more, as what carries it is knocked out.
func is_dead() -> bool:
	return false


## Velocity that what carries it has at the muzzle, m/s.
func carried_velocity() -> Vector3:
	return Vector3.ZERO


## Gives what carries it an impulse (N s, world) at a position (m, world).
func kick(_impulse: Vector3, _place: Vector3) -> void:
	pass


## Fires one round, on the server. Returns false where it is not loaded, empty or dead.
func fire() -> bool:
	if loaded < 1.0 or not _shoot():
		return false
	loaded = 0.0
	_set_field(loaded_field, loaded)
	return true


## Loads another kind of round from now on: on the server. What there is not is refused.
func load_kind(p_kind: int) -> bool:
	if p_kind < 0 or p_kind >= ammunition.size() or p_kind == chosen:
		return false
	chosen = p_kind
	loaded = 0.0
	_set_field(ammunition_field, chosen)
	_set_field(loaded_field, loaded)
	_set_field(rounds_field, rounds())
	return true


## Presses or releases the trigger of a machine gun: on the server.
func hold_trigger(p_is_held: bool) -> void:
	_held_s = MAX_BURST_S if p_is_held and is_automatic else 0.0


func _fire_on(p_delta: float) -> void:
	_held_s = maxf(_held_s - p_delta, 0.0)
	var is_on: bool = _held_s > 0.0 and rounds() > 0 and not is_dead()
	if is_on != is_firing:
		is_firing = is_on
		_set_field(firing_field, 1.0 if is_on else 0.0)
	if not is_on:
		# A trigger that is pressed again and again fires no faster.
		_until_round = maxf(_until_round - p_delta, 0.0)
		return
	for _round: int in _rounds_due(p_delta):
		if not _shoot():
			return


func _rounds_due(p_delta: float) -> int:
	var due: int = 0
	_until_round -= p_delta
	while _until_round <= 0.0 and due < _MAX_IN_TICK:
		_until_round += 60.0 / rate
		due += 1
	_until_round = maxf(_until_round, 0.0)
	return due


func _shoot() -> bool:
	if is_dead() or rounds() <= 0:
		return false
	var kind: Ammunition = ammunition[chosen]
	var along: Vector3 = global_basis.z.normalized()
	var muzzle: Vector3 = global_position
	var velocity: Vector3 = _velocity()
	if not shells.launch(kind, muzzle + along * barrel_length, muzzle, velocity):
		return false
	left[chosen] -= 1
	_set_field(rounds_field, rounds())
	_kick = along * kind.recoil()
	_kick_s = KICK_S
	if is_automatic:
		_kick_s = 0.0
		kick(_kick, muzzle)
		_tell_fired(kind, muzzle, velocity)
	return true


## What a round has at the muzzle: its own speed, scattered, and that of what carries the gun.
func _velocity() -> Vector3:
	var turned: Vector2 = Vector2(_chance.randfn(), _chance.randfn()) * dispersion * 1e-3
	var ahead: Vector3 = global_basis * Vector3(turned.x, turned.y, -1.0)
	return ahead.normalized() * ammunition[chosen].muzzle_speed + carried_velocity()


## Part of the kick at each tick, in the line of the bore.
func _give_kick(p_delta: float) -> void:
	if _kick_s <= 0.0:
		return
	var share: float = minf(p_delta / _kick_s, 1.0)
	kick(_kick * share, global_position)
	_kick -= _kick * share
	_kick_s -= p_delta


func _tell_fired(p_kind: Ammunition, p_place: Vector3, p_velocity: Vector3) -> void:
	fired.emit(p_kind, p_place, p_velocity)
	shells.fired.emit(p_kind, p_place, p_velocity, self)


## A shell, not a machine gun's bullet, has left one of the muzzles.
func _on_launched(p_kind: Ammunition, p_place: Vector3, p_velocity: Vector3) -> void:
	if ammunition.has(p_kind):
		_tell_fired(p_kind, p_place, p_velocity)


func _set_field(p_field: StringName, p_value: float) -> void:
	if p_field != &"" and entity.is_authority() and entity.type.find_field(p_field) >= 0:
		entity.set_value(p_field, p_value)


func _on_commanded(p_session: int, p_command: StringName, p_values: PackedFloat32Array) -> void:
	# The server has checked the seat by the type; a type that names none is no reason to obey.
	if p_command != fire_command and p_command != load_command:
		return
	if seat != null and seat.occupant() != p_session:
		Log.limited("combat", "gun", "a gun obeys nobody outside its seat")
	elif p_command == load_command:
		load_kind(int(p_values[0]))
	elif is_automatic:
		hold_trigger(p_values[0] > 0.5)
	else:
		fire()


func _on_seat_changed(_session: int) -> void:
	if entity.is_authority():
		hold_trigger(false)


func _on_started() -> void:
	if entity.is_authority():
		_set_field(ammunition_field, chosen)
		_set_field(loaded_field, loaded)
		_set_field(rounds_field, rounds())
		return
	for field: StringName in [loaded_field, ammunition_field, rounds_field, firing_field]:
		if field != &"" and entity.type.find_field(field) >= 0:
			_on_field_changed(field, entity.get_value(field))


func _on_field_changed(p_field: StringName, p_value: float) -> void:
	if p_field == &"" or entity.is_authority():
		return
	match p_field:
		loaded_field:
			loaded = p_value
		ammunition_field:
			chosen = clampi(roundi(p_value), 0, maxi(ammunition.size() - 1, 0))
			# The events do not say how many rounds of another kind are left.
			if rounds_field != &"" and entity.type.find_field(rounds_field) >= 0:
				_on_field_changed(rounds_field, entity.get_value(rounds_field))
		rounds_field:
			if chosen < left.size():
				left[chosen] = roundi(p_value)
		firing_field:
			is_firing = p_value > 0.5

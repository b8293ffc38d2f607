class_name BinauralRenderer
extends SpatialRenderer
## Makes voices heard by the two ears of a measured head: for headphones.
##
## Each voice has a player and a bus of its own with a [BinauralEffect]; the bus sends to where the
## voice belongs. Buses are made once and stay.

## The measured head: KEMAR, Gardner and Martin, MIT Media Lab 1994.
const HEAD: String = "res://assets/sound/head/mit_kemar.sofa"
## Buses of voices are named by it and a number.
const BUS_PREFIX: String = "Ears "
## Frames after which a voice that fades is silent.
const _FADE_FRAMES: int = 2
## Level that makes a mono voice as loud as the engine's panning makes it, dB: a head's filters
## have their power over both ears.
const _LEVEL_DB: float = 0.0

## Who listens; null: the camera of the viewport.
var listener: Node3D = null
## Why there is no binaural sound, or an empty text.
var error: String = ""

var _players: Array[AudioStreamPlayer] = []
var _effects: Array[BinauralEffect] = []
var _places: PackedVector3Array = []
var _begin_s: PackedFloat32Array = []
var _buses: Array[StringName] = []
## Slots in use, and those that fade with the frame in which they began to.
var _used: Dictionary[int, bool] = {}
var _fading: Dictionary[int, int] = {}
var _free: PackedInt32Array = []
var _frame: int = 0


func _init(p_capacity: int = 32) -> void:
	capacity = p_capacity


func _ready() -> void:
	var head: BinauralHead = BinauralHead.new()
	error = head.open(FileAccess.get_file_as_bytes(HEAD), AudioServer.get_mix_rate())
	if error != "":
		error = "%s: %s" % [HEAD, error]
		capacity = 0
		return
	# Some more than can sound are there for those that fade.
	for index: int in capacity + PannedRenderer.SPARE:
		_add_slot(index, head)


func _process(_delta: float) -> void:
	_frame += 1
	for slot: int in _fading.keys():
		if _frame - _fading[slot] > _FADE_FRAMES:
			_players[slot].stop()
			_players[slot].stream = null
			_fading.erase(slot)
			_free.append(slot)
	# The head turns even where the voices stay.
	var ears: Transform3D = _ears()
	for slot: int in _used:
		_turn(slot, ears)


func begin(p_stream: AudioStream, p_bus: StringName, p_from_s: float) -> int:
	if _free.is_empty() or _used.size() >= capacity:
		return -1
	var slot: int = _free[_free.size() - 1]
	_free.resize(_free.size() - 1)
	_players[slot].stream = p_stream
	_begin_s[slot] = p_from_s
	_used[slot] = true
	_send(slot, p_bus)
	return slot


func update(
	p_slot: int, p_place: Vector3, p_level_db: float, p_pitch: float, p_bus: StringName
) -> void:
	_places[p_slot] = p_place
	_players[p_slot].volume_db = minf(p_level_db, 6.0) + _LEVEL_DB
	if absf(_players[p_slot].pitch_scale - p_pitch) > 1e-3:
		_players[p_slot].pitch_scale = p_pitch
	_send(p_slot, p_bus)


func start(p_slot: int) -> void:
	_turn(p_slot, _ears())
	_players[p_slot].play(_begin_s[p_slot])


func release(p_slot: int) -> void:
	_players[p_slot].volume_db = -80.0
	_fading[p_slot] = _frame
	_used.erase(p_slot)


func sounding() -> int:
	return _used.size()


func _add_slot(p_index: int, p_head: BinauralHead) -> void:
	var bus_name: String = BUS_PREFIX + str(p_index)
	var bus: int = AudioServer.get_bus_index(bus_name)
	if bus < 0:
		bus = AudioServer.bus_count
		AudioServer.add_bus()
		AudioServer.set_bus_name(bus, bus_name)
		AudioServer.add_bus_effect(bus, BinauralEffect.new())
	var effect: BinauralEffect = AudioServer.get_bus_effect(bus, 0)
	effect.set_head(p_head)
	var player: AudioStreamPlayer = AudioStreamPlayer.new()
	player.bus = bus_name
	add_child(player)
	_players.append(player)
	_effects.append(effect)
	_places.append(Vector3.ZERO)
	_begin_s.append(0.0)
	_buses.append(&"")
	_free.append(p_index)


func _send(p_slot: int, p_bus: StringName) -> void:
	if _buses[p_slot] != p_bus:
		_buses[p_slot] = p_bus
		AudioServer.set_bus_send(AudioServer.get_bus_index(BUS_PREFIX + str(p_slot)), p_bus)


func _turn(p_slot: int, p_ears: Transform3D) -> void:
	# What is in the head has no direction: ahead.
	var way: Vector3 = (_places[p_slot] - p_ears.origin) * p_ears.basis
	_effects[p_slot].set_direction(way if way.length() > 0.05 else Vector3.FORWARD)


func _ears() -> Transform3D:
	var ears: Node3D = listener if is_instance_valid(listener) else null
	if ears == null:
		ears = get_viewport().get_camera_3d()
	return ears.global_transform.orthonormalized() if ears != null else Transform3D.IDENTITY

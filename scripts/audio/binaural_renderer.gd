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

## Who listens; null: the camera of the viewport.
var listener: Node3D = null
## Why there is no binaural sound, or an empty text.
var error: String = ""

var _players: Array[AudioStreamPlayer] = []
var _effects: Array[BinauralEffect] = []
var _places: PackedVector3Array = []
var _buses: Array[StringName] = []


func _init(p_capacity: int = 32) -> void:
	capacity = p_capacity


func _ready() -> void:
	var head: BinauralHead = BinauralHead.new()
	error = head.open(FileAccess.get_file_as_bytes(HEAD), AudioServer.get_mix_rate())
	if error != "":
		error = "%s: %s" % [HEAD, error]
		capacity = 0
		return
	for index: int in capacity + SPARE:
		_add_slot(index, head)


func _process(p_delta: float) -> void:
	super(p_delta)
	# The head turns even where the voices stay.
	var ears: Transform3D = _ears()
	for slot: int in _used:
		_turn(slot, ears)


func update(
	p_slot: int, p_place: Vector3, p_level_db: float, p_pitch: float, p_bus: StringName
) -> void:
	_places[p_slot] = p_place
	_players[p_slot].volume_db = minf(p_level_db, 6.0)
	if absf(_players[p_slot].pitch_scale - p_pitch) > 1e-3:
		_players[p_slot].pitch_scale = p_pitch
	_send(p_slot, p_bus)


func start(p_slot: int) -> void:
	_turn(p_slot, _ears())
	_players[p_slot].play(_used[p_slot])


func _load(p_slot: int, p_stream: AudioStream, p_bus: StringName) -> void:
	_players[p_slot].stream = p_stream
	_send(p_slot, p_bus)


func _mute(p_slot: int) -> void:
	_players[p_slot].volume_db = FADED_DB


func _clear(p_slot: int) -> void:
	_players[p_slot].stop()
	_players[p_slot].stream = null


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
	_buses.append(&"")
	_free.append(p_index)


func _send(p_slot: int, p_bus: StringName) -> void:
	if _buses[p_slot] != p_bus:
		_buses[p_slot] = p_bus
		AudioServer.set_bus_send(AudioServer.get_bus_index(BUS_PREFIX + str(p_slot)), p_bus)


func _turn(p_slot: int, p_ears: Transform3D) -> void:
	# What is in the head has no direction: ahead.
	var offset: Vector3 = (_places[p_slot] - p_ears.origin) * p_ears.basis
	_effects[p_slot].set_direction(offset if offset.length() > 0.05 else Vector3.FORWARD)


func _ears() -> Transform3D:
	var ears: Node3D = listener if is_instance_valid(listener) else null
	if ears == null:
		ears = get_viewport().get_camera_3d()
	return ears.global_transform.orthonormalized() if ears != null else Transform3D.IDENTITY

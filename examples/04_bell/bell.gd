extends Node3D
## A bell that trainees and instructors ring: Godot's own @rpc, spawner and synchronizer in a level.
##
## The server counts and adds a note to the board for each ring; the count is synchronized, the
## notes are spawned at every client, and everybody hears the bell by a call of the server's.

## Somebody has rung; for whoever makes a sound of it.
signal rung(p_name: String)

## Notes on the board; older ones are taken down.
const MAX_NOTES: int = 8

## How often the bell was rung. The synchronizer sends it to everybody.
@export var count: int = 0:
	set(p_value):
		count = p_value
		if _label != null:
			_label.text = "%d rings" % count

@onready var _shared: SharedNodes = SharedNodes.above(self)
@onready var _spawner: MultiplayerSpawner = $Spawner
@onready var _board: Node3D = $Board
@onready var _label: Label3D = $Label


func _ready() -> void:
	_spawner.spawn_function = _make_note
	_shared.call_refused.connect(func(_method: StringName, why: String) -> void: _label.text = why)


## Called by the button at a client: asks the server to ring.
func press() -> void:
	ring.rpc_id(1)


## On the server: somebody rings. The permissions of the shared node say who may.
@rpc("any_peer", "call_local", "reliable")
func ring() -> void:
	if not multiplayer.is_server():
		return
	count += 1
	var who: String = _shared.caller_name if _shared.caller_name != "" else "the server"
	_spawner.spawn("%d: %s" % [count, who])
	if _board.get_child_count() > MAX_NOTES:
		_board.get_child(0).queue_free()
	_sound.rpc(who)


@rpc("authority", "call_local", "reliable")
func _sound(p_name: String) -> void:
	Log.info("bell", "%s rings" % p_name)
	rung.emit(p_name)


func _make_note(p_text: Variant) -> Node:
	var note: Label3D = Label3D.new()
	note.text = str(p_text).left(60)
	note.position.y = 0.25 * (count % MAX_NOTES)
	note.billboard = BaseMaterial3D.BILLBOARD_FIXED_Y
	return note

extends SceneTree
## The clients of [code]./run bench moving[/code]: started by bench_moving.py, never by itself.
##
## All join at once, stay, and move their people by a clip. It prints a line of JSON a second.

const MovingClient: GDScript = preload("moving_client.gd")
## Frames a second: each client is polled in each.
const FRAMES: int = 60
const CLIP: String = "res://assets/motion/01_01.bvh"

var _arguments: BenchArguments = null
var _clients: Array[MovingClient] = []
var _began_usec: int = 0
var _second: int = 0
var _frames: int = 0
var _stop: StopSignal = StopSignal.new()


func _initialize() -> void:
	var rows: Dictionary = {"port": 7777, "clients": 1, "people": 0, "observers": 0}
	_arguments = BenchArguments.parse(OS.get_cmdline_user_args(), rows)
	PhysicsServer3D.set_active(false)
	Engine.max_fps = FRAMES
	_stop.watch()
	var fault: String = MovingClient.prepare(ProjectSettings.globalize_path(CLIP))
	if fault != "":
		Log.error("bench", fault)
		quit(1)
		return
	for number: int in _arguments.value("observers"):
		_add("observer %d" % number, [])
	for number: int in _arguments.value("clients"):
		_add("trainee %d" % number, _heights(number))
	_began_usec = Time.get_ticks_usec()


func _process(_p_delta: float) -> bool:
	_frames += 1
	for client: MovingClient in _clients:
		client.poll()
	var now: int = Time.get_ticks_usec()
	if (now - _began_usec) / 1000000 > _second:
		_second = (now - _began_usec) / 1000000
		_tell()
	if _stop.is_raised():
		for client: MovingClient in _clients:
			client.close()
		return true
	return false


func _add(p_name: String, p_heights: PackedFloat32Array) -> void:
	var client: MovingClient = MovingClient.new(p_name, _arguments.value("port"), p_heights)
	client.first = _clients.size() * p_heights.size()
	client.save_work()
	client.open()
	_clients.append(client)


func _heights(p_number: int) -> PackedFloat32Array:
	var heights: PackedFloat32Array = []
	for person: int in _arguments.value("people"):
		heights.append(0.8 + 0.02 * ((p_number * _arguments.value("people") + person) % 17))
	return heights


## A line of what has been seen so far.
func _tell() -> void:
	var row: Dictionary = {
		"usec": Time.get_ticks_usec(), "frames": _frames, "joined": 0, "bodies": 0, "snapshots": []
	}
	for client: MovingClient in _clients:
		row["joined"] += 1 if client.is_joined() else 0
		row["bodies"] += client.bodies()
		row["snapshots"].append(client.snapshots)
		if client.refusal != "" or client.told != "":
			row["told"] = client.refusal + client.told
	print(JSON.stringify(row))

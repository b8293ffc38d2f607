extends SceneTree
## The clients of [code]./run bench joins[/code] and [code]moving[/code]: never started by itself.
##
## It prints a line of JSON a second. --plan=join: all join at once and stay. --plan=churn: each
## joins, stays for a second, leaves, and so on. --plan=lists: they send lists of people of other
## sizes 60 times a second. --plan=single: they join one after the other, a second apart.
## --plan=hostile: one of --role=NAME sends all sorts of valid messages, by the seed --seed.
## --plan=levels: an instructor asks for another level 20 times a second. --plan=move: as join, and
## people move by a clip, beside --observers=N. With --begin=FILE all wait until that file is there.

const JoinClient: GDScript = preload("join_client.gd")
const MovingClient: GDScript = preload("../moving/moving_client.gd")
const CLIP: String = "res://assets/motion/01_01.bvh"
const HostileClient: GDScript = preload("res://tests/server/hostile_client.gd")
const STAY_S: float = 1.0

var _arguments: BenchArguments = null
var _clients: Array[JoinClient] = []
var _hostile: HostileClient = null
var _since_usec: Dictionary[JoinClient, int] = {}
var _began_usec: int = 0
var _next: int = 0
var _listed_usec: int = 0
var _lists: int = 0
var _second: int = 0
var _frames: int = 0
var _stop: StopSignal = StopSignal.new()


func _initialize() -> void:
	_arguments = (
		BenchArguments
		. parse(
			OS.get_cmdline_user_args(),
			{
				"plan": "join",
				"port": 7777,
				"clients": 1,
				"people": 0,
				"observers": 0,
				"seconds": 10.0,
				"begin": "",
				"seed": 1,
				"role": "trainee",
			}
		)
	)
	PhysicsServer3D.set_active(false)
	# Each client is polled in each frame.
	Engine.max_fps = 60 if _moves() else 120
	_stop.watch()
	var fault: String = MovingClient.prepare(CLIP) if _moves() else ""
	if fault != "":
		Log.error("bench", fault)
		quit(1)
		return
	for number: int in _arguments.value("observers"):
		_add("observer %d" % number, [])
	for number: int in _arguments.value("clients"):
		_add("%s %d" % [_arguments.value("plan"), number], _heights(number))
	_began_usec = Time.get_ticks_usec()


func _process(_p_delta: float) -> bool:
	_frames += 1
	var now: int = Time.get_ticks_usec()
	if not FileAccess.file_exists(_arguments.value("begin")) and _arguments.value("begin") != "":
		_began_usec = now
		return _stop.is_raised()
	for client: JoinClient in _clients:
		client.poll()
	match _arguments.value("plan"):
		"single":
			if _next < _clients.size() and now - _began_usec > _next * 1000000:
				_open_next(now)
		"churn":
			_churn(now)
		"hostile", "levels":
			_trouble(now)
		_:
			while _next < _clients.size():
				_open_next(now)
	if _arguments.value("plan") == "lists" and now - _listed_usec > 16667:
		_listed_usec = now
		_send_other_list()
	if (now - _began_usec) / 1000000 > _second:
		_second = (now - _began_usec) / 1000000
		_tell()
	if _stop.is_raised() or now - _began_usec > int(_arguments.value("seconds") * 1e6):
		for client: JoinClient in _clients:
			client.close()
		if _hostile != null:
			_hostile.leave()
		return true
	return false


func _moves() -> bool:
	return _arguments.value("plan") == "move"


func _add(p_name: String, p_heights: PackedFloat32Array) -> void:
	var kind: GDScript = MovingClient if _moves() else JoinClient
	var client: JoinClient = kind.new(p_name, _arguments.value("port"), p_heights)
	if _moves():
		(client as MovingClient).first = _clients.size() * p_heights.size()
		(client as MovingClient).save_work()
	_clients.append(client)


func _heights(p_number: int) -> PackedFloat32Array:
	var heights: PackedFloat32Array = []
	for person: int in _arguments.value("people"):
		heights.append(0.8 + 0.02 * ((p_number * _arguments.value("people") + person) % 17))
	return heights


func _open_next(p_now_usec: int) -> void:
	_since_usec[_clients[_next]] = p_now_usec
	_clients[_next].open()
	_next += 1


func _churn(p_now_usec: int) -> void:
	# The first turns are spread over the time of a stay.
	if (
		_next < _clients.size()
		and p_now_usec - _began_usec > int(STAY_S * 1e6) * _next / _clients.size()
	):
		_open_next(p_now_usec)
	for client: JoinClient in _since_usec:
		if client.is_joined() and p_now_usec - _since_usec[client] > int(STAY_S * 1e6):
			_since_usec[client] = p_now_usec
			client.close()
			client.open()


func _trouble(p_now_usec: int) -> void:
	if _hostile == null:
		_hostile = HostileClient.new(_arguments.value("port"), _arguments.value("seed"), _role())
		if _arguments.value("plan") == "levels":
			_hostile.only = [&"level"]
	_hostile.advance(p_now_usec / 1e6)


func _role() -> Roles.Role:
	for role: Roles.Role in Roles.Role.values():
		if Roles.name_of(role) == _arguments.value("role"):
			return role
	return Roles.Role.TRAINEE


func _send_other_list() -> void:
	_lists += 1
	for client: JoinClient in _clients:
		for index: int in client.heights.size():
			client.heights[index] = 0.85 if _lists % 2 == 0 else 0.95
		if client.is_joined():
			client.declare()


## A line of what was seen in the last second.
func _tell() -> void:
	var row: Dictionary = {
		"second": _second,
		"usec": Time.get_ticks_usec(),
		"frames": _frames,
		"joined": 0,
		"joins": 0,
		"bodies": 0,
		"snapshots": [],
		"gaps_ms": [],
	}
	for client: JoinClient in _clients:
		row["joined"] += 1 if client.is_joined() else 0
		row["joins"] += client.joins
		row["snapshots"].append(client.snapshots)
		row["gaps_ms"].append(client.gap_s * 1000.0)
		row["people"] = client.people()
		row["bodies"] += client.bodies()
		if client.refusal != "" or client.told != "":
			row["told"] = client.refusal + client.told
		client.gap_s = 0.0
	if _hostile != null:
		row["joins"] = _hostile.joins
		row["sent"] = _hostile.messages()
	row["frame_ms"] = 1000.0 / maxf(Engine.get_frames_per_second(), 1.0)
	print(JSON.stringify(row))

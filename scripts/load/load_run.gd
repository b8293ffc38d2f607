class_name LoadRun
extends Node
## Many clients in one process, without displays: what [code]./run load[/code] puts on a server.
##
## They join one after the other, a few at a time. When all have and some time has passed they are
## counted for [code]--duration[/code] seconds; then the report is written, and they stay until the
## process is ended, so that the server can be looked at while they are there.

## The run has ended: the exit code of the program.
signal left(p_exit_code: int)

## The stage of the run.
enum Stage {
	## Not everybody is there yet.
	JOINING,
	## Everybody has joined.
	SETTLING,
	## The clients count.
	COUNTING,
	## The report is written.
	DONE,
}

## Rate of polling each client, as displays of 60 frames per second would, 1/s.
const POLLS_PER_SECOND: float = 60.0
## Polls of all clients together, 1/s: with more of them each is polled less often.
const MAX_POLLS: float = 3840.0
## Frames in which clients are polled that are due: not all at once, 1/s.
const FRAMES_PER_SECOND: int = 240
## Time between two that join, µs.
const JOIN_USEC: int = 50000
## Time from the last one's joining to the counting, s.
const SETTLE_S: float = 3.0
## How many may be joining at a time.
const MAX_JOINING: int = 4
## Time in which at least one has to join, s.
const PATIENCE_S: float = 30.0

var _options: Options = null
var _clients: Array[LoadClient] = []
var _agreement: LoadAgreement = LoadAgreement.new()
var _stop: StopSignal = StopSignal.new()
var _report: ReportFile = null
var _stage: Stage = Stage.JOINING
var _since_usec: int = 0
var _opened: int = 0
var _opened_usec: int = 0
var _here: int = 0
var _tables: SharedTables = SharedTables.new()
var _joining: Array[LoadClient] = []
var _polls: int = 0
var _next: int = 0
var _polled_usec: int = 0


## Takes over the options. Call it before the node enters the tree.
func configure(p_options: Options) -> void:
	_options = p_options


func _ready() -> void:
	PhysicsServer3D.set_active(false)
	Engine.max_fps = FRAMES_PER_SECOND
	_report = ReportFile.new(_options.file("report"))
	var fault: String = _make_clients()
	if fault != "":
		_give_up(StateStream.EXIT_OPTIONS, fault)
		return
	_stop.watch()
	_since_usec = Time.get_ticks_usec()


func _process(_p_delta: float) -> void:
	if _stop.is_raised():
		left.emit(0)
		return
	if not _poll_due():
		return
	match _stage:
		Stage.JOINING:
			_join()
		Stage.SETTLING:
			if _age_s() > SETTLE_S:
				_begin_counting()
		Stage.COUNTING:
			if _options.seconds("duration") > 0.0 and _age_s() > _options.seconds("duration"):
				_finish()


func _exit_tree() -> void:
	if _stage == Stage.COUNTING:
		_report.write(_make_report())
	for client: LoadClient in _clients:
		client.close()


## How often each client is polled, 1/s.
func _poll_rate() -> float:
	return minf(POLLS_PER_SECOND, MAX_POLLS / _clients.size())


## Polls those whose turn it is, each once at most. Returns whether the run goes on.
func _poll_due() -> bool:
	var now: int = Time.get_ticks_usec()
	var each_usec: float = 1e6 / (_poll_rate() * _clients.size())
	var due: int = int((now - _polled_usec) / each_usec)
	_polled_usec += int(due * each_usec)
	for _turn: int in mini(due, _clients.size()):
		_next = (_next + 1) % _clients.size()
		_polls += 1
		if _next < _opened:
			_clients[_next].poll()
		if _clients[_next].refusal != "":
			_give_up(StateStream.EXIT_REFUSED, _clients[_next].refusal)
			return false
	# A client that joins needs many round trips, and would wait for its turn in each.
	for client: LoadClient in _joining:
		client.poll()
	return true


func _make_clients() -> String:
	var trainees: int = _options.number("trainees")
	var walkers: int = _options.number("walkers")
	var total: int = LoadOptions.count_clients(_options)
	if total == 0:
		return "there are no clients: ask for --trainees, --walkers or --observers"
	var trust: ServerTrust = ServerTrust.of_options(_options)
	if trust.find_fault() != "":
		return trust.find_fault()
	var first: BvhSource = BvhSource.new()
	if trainees > 0:
		if _options.file("bvh") == "":
			return "trainees need a motion source: --bvh=FILE"
		first.open(_options.file("bvh"), _options.text("unit"), _options.text("up"))
		if first.error != "":
			return first.error
	for i: int in total:
		var is_trainee: bool = i < trainees
		var is_walker: bool = not is_trainee and i < trainees + walkers
		var number: int = i - (0 if is_trainee else trainees if is_walker else trainees + walkers)
		var role: String = "trainee" if is_trainee else "walker" if is_walker else "observer"
		var who: String = "%s %d" % [role, number]
		var client: LoadClient = LoadClient.new(who, _options, _agreement, _tables)
		client.trust_by(trust)
		var angle: float = TAU * i / total
		client.look_from(Vector3(4.0 * sin(angle), 1.6, 4.0 * cos(angle)))
		if is_trainee:
			var source: BvhSource = BvhSource.new()
			source.use(first.rig.clip)
			# Each at another moment of the clip.
			source.start_s = first.rig.clip.duration() * number / trainees
			client.wear(source)
		elif is_walker:
			client.walk(number)
		_clients.append(client)
	return ""


func _join() -> void:
	var now: int = Time.get_ticks_usec()
	var here: int = 0
	_joining.clear()
	for number: int in _opened:
		here += 1 if _clients[number].is_joined() else 0
		if _clients[number].is_joining():
			_joining.append(_clients[number])
	var is_due: bool = _joining.size() < MAX_JOINING and now - _opened_usec > JOIN_USEC
	if is_due and _opened < _clients.size():
		_clients[_opened].open()
		_opened += 1
		_opened_usec = now
	if here > _here:
		_here = here
		_since_usec = now
	if here == _clients.size():
		_joining.clear()
		_enter(Stage.SETTLING, "%d clients have joined" % here)
	elif _age_s() > PATIENCE_S:
		var parts: Array = [_clients.size(), here, _options.text("host"), _options.number("port")]
		_give_up(StateStream.EXIT_NO_SERVER, "of %d clients only %d could join %s:%d" % parts)


func _begin_counting() -> void:
	for client: LoadClient in _clients:
		client.begin_counting()
	_agreement.restart()
	_polls = 0
	_enter(Stage.COUNTING, "counting")


func _finish() -> void:
	_report.write(_make_report())
	_enter(Stage.DONE, "counted")


func _enter(p_stage: Stage, p_words: String) -> void:
	_stage = p_stage
	_since_usec = Time.get_ticks_usec()
	Log.info("load", p_words)


func _make_report() -> Dictionary:
	var rows: Array[Dictionary] = []
	for client: LoadClient in _clients:
		rows.append(client.report())
	return {
		"role": "load",
		"seconds": _age_s(),
		"polls_per_second": _polls / float(_clients.size()) / maxf(_age_s(), 0.001),
		"polls_wanted": _poll_rate(),
		"compared_poses": _agreement.compared,
		"different_poses": _agreement.different,
		"clients": rows,
		"groups":
		{
			"trainees": _group("trainee"),
			"walkers": _group("walker"),
			"observers": _group("observer"),
		},
	}


## Ages and delays of all clients of a role together.
func _group(p_role: String) -> Dictionary:
	var ages: LatencyHistogram = LatencyHistogram.new()
	var delays: LatencyHistogram = LatencyHistogram.new()
	var count: int = 0
	for client: LoadClient in _clients:
		if client.name.begins_with(p_role):
			count += 1
			ages.merge(client.stats.ages)
			delays.merge(client.stats.probe.total)
	return {"clients": count, "age": ages.stats(), "latency": delays.stats()}


func _age_s() -> float:
	return (Time.get_ticks_usec() - _since_usec) / 1e6


func _give_up(p_code: int, p_why: String) -> void:
	Log.error("load", p_why)
	set_process(false)
	left.emit(p_code)

extends SceneTree
## Many people who fight, hug, fall and get up among dropping crates, for long: whether energy stays
## bounded, and whether two processes come to the same state.
##
## Options: --people=16, --minutes=10 (simulated), --root=soft|inertial|grounded (default
## grounded), --hz=60, --alone (no second process). Goals: nobody ever has more energy than a fall
## from standing gives, the second half has no more than the first, the fingerprints are equal.

const Melee: GDScript = preload("endurance/melee.gd")
const _BOXING: String = "res://assets/motion/Boxing_Toes.bvh"
const _ROOTS: Dictionary[String, RagdollMotor.RootMode] = {
	"soft": RagdollMotor.ROOT_SOFT,
	"inertial": RagdollMotor.ROOT_INERTIAL,
	"grounded": RagdollMotor.ROOT_GROUNDED,
}
## A body of 80 kg whose centre falls by 1 m, J.
const _MOST_ENERGY: float = 785.0
## Energy of the second half of the rounds by that of the first.
const _MOST_GROWTH: float = 1.2
## Ticks between two looks at the energy.
const _LOOK_EVERY: int = 2

var _arguments: BenchArguments = null
var _report: BenchReport = null
var _melee: Melee = null
## Highest energy of a person, of all people together (J), hips (m), and all people's energy by
## rounds.
var _highest: float = 0.0
var _all_highest: float = 0.0
var _top: float = -INF
var _rounds: Array[Statistics] = []


func _initialize() -> void:
	_arguments = BenchArguments.parse(
		OS.get_cmdline_user_args(),
		{"people": 16, "minutes": 10.0, "root": "grounded", "hz": 60, "alone": false}
	)
	_run.call_deferred()


func _run() -> void:
	var fault: String = _find_fault()
	if fault != "":
		printerr(fault)
		quit(2)
		return
	var other: Dictionary = {} if _arguments.value("alone") else _start_other()
	_report = BenchReport.new("endurance", _arguments.value("json"))
	var source: BvhSource = BvhSource.new()
	source.open(_BOXING)
	Engine.physics_ticks_per_second = _arguments.value("hz")
	_melee = Melee.new()
	root.add_child(_melee)
	_melee.begin(_arguments.value("people"), _ROOTS[_arguments.value("root")], source)
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	for tick: int in int(_arguments.value("minutes") * 60.0 / delta):
		await physics_frame
		if tick % _LOOK_EVERY == 0:
			_look(int(tick * delta / Melee.ROUND_S))
		_melee.drive(tick * delta, delta)
	await physics_frame
	_tell(_melee.fingerprint(), other)
	quit(_report.finish())


func _find_fault() -> String:
	if _arguments.error != "":
		return _arguments.error
	if not _ROOTS.has(_arguments.value("root")):
		return "--root is one of %s" % ", ".join(_ROOTS.keys())
	if _arguments.value("people") < 2 or _arguments.value("people") > 256:
		return "--people is between 2 and 256, found %d" % _arguments.value("people")
	if _arguments.value("hz") < 10 or _arguments.value("hz") > 1000:
		return "a tick rate is between 10 and 1000, found %d" % _arguments.value("hz")
	if not _arguments.value("minutes") > 0.0:
		return "--minutes is more than 0, found %s" % _arguments.value("minutes")
	return ""


## The same in another process at the same time.
func _start_other() -> Dictionary:
	var script: String = (get_script() as GDScript).resource_path
	var options: PackedStringArray = [
		"--headless", "--path", ProjectSettings.globalize_path("res://")
	]
	options.append_array(["-s", script, "--", "--alone", "--json"])
	for option: String in ["people", "minutes", "root", "hz"]:
		options.append("--%s=%s" % [option, _arguments.value(option)])
	return OS.execute_with_pipe(OS.get_executable_path(), options)


func _look(p_round: int) -> void:
	if p_round == _rounds.size():
		_rounds.append(Statistics.new())
	var all: float = 0.0
	for person: ContactPerson in _melee.people:
		var energy: float = person.energy()
		_highest = maxf(_highest, energy)
		all += energy
		var hips: Transform3D = PhysicsServer3D.body_get_state(
			person.ragdoll.get_bodies()[0], PhysicsServer3D.BODY_STATE_TRANSFORM
		)
		_top = maxf(_top, hips.origin.y)
	_all_highest = maxf(_all_highest, all)
	_rounds[p_round].add(all)


func _tell(p_fingerprint: int, p_other: Dictionary) -> void:
	var parts: Array = [_arguments.value("people"), _arguments.value("root")]
	var case: String = (
		"%d people, %s, " % parts + "%s min" % String.num(_arguments.value("minutes"), 1)
	)
	var at_most: BenchReport.Goal = BenchReport.Goal.AT_MOST
	_report.add(case, "highest energy of a person", _highest, "J", at_most, _MOST_ENERGY)
	_report.add(case, "highest energy of all", _all_highest, "J")
	# The last round is hardly ever whole.
	var half: int = (_rounds.size() - 1) / 2
	if half > 0:
		var growth: float = _mean_energy(half, half * 2) / maxf(_mean_energy(0, half), 1.0)
		_report.add(case, "mean energy, second by first half", growth, "", at_most, _MOST_GROWTH)
	_report.add(case, "highest hips", _top, "m")
	_report.add(case, "guards acted", _melee.guarded, "ticks")
	_report.add(case, "fingerprint", p_fingerprint, "")
	if p_other.is_empty():
		return
	var same: float = 1.0 if _other_fingerprint(p_other) == float(p_fingerprint) else 0.0
	_report.add(case, "the same in two processes", same, "", BenchReport.Goal.AT_LEAST, 1.0)


func _mean_energy(p_from: int, p_to: int) -> float:
	var sum: float = 0.0
	for number: int in range(p_from, p_to):
		sum += _rounds[number].mean()
	return sum / (p_to - p_from)


func _other_fingerprint(p_other: Dictionary) -> float:
	var output: FileAccess = p_other["stdio"]
	while OS.is_process_running(p_other["pid"]):
		OS.delay_msec(100)
	for line: String in output.get_as_text().split("\n"):
		var row: Variant = JSON.parse_string(line) if line.begins_with("{") else null
		if row is Dictionary and row.get("metric") == "fingerprint":
			return row["value"]
	return -1.0

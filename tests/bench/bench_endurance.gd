extends Bench
## Many people who fight, hug, fall and get up among dropping crates, for long: whether energy stays
## bounded, and whether two processes come to the same state.
##
## Options: --people=16, --minutes=10 (simulated), --root=soft|inertial|grounded (default
## grounded), --hz=60, --alone (no second process). Goals: nobody ever has more energy than a fall
## from standing gives, the second half has no more than the first, the fingerprints are equal.

const Melee: GDScript = preload("endurance/melee.gd")
const _BOXING: String = "res://assets/motion/Boxing_Toes.bvh"
const _ROOTS: Array[String] = ["soft", "inertial", "grounded"]
## A body of 80 kg whose centre falls by 1 m, J.
const _MOST_ENERGY: float = 785.0
## Energy of the second half of the rounds by that of the first.
const _MOST_GROWTH: float = 1.2
## Ticks between two looks at the energy.
const _LOOK_EVERY: int = 2

var _melee: Melee = null
## Highest energy of a person, J, and all people's energy by rounds.
var _highest: float = 0.0
var _rounds: Array[Statistics] = []


func options() -> Dictionary:
	return {
		"people": [16, 2, 256],
		"minutes": [10.0, 0.001, 10000.0],
		"root": ["grounded", _ROOTS],
		"hz": [60, 10, 1000],
		"alone": false
	}


func measure() -> void:
	var other: Dictionary = {} if option("alone") else _start_other()
	var source: BvhSource = BvhSource.new()
	source.open(_BOXING)
	Engine.physics_ticks_per_second = option("hz")
	_melee = Melee.new()
	root.add_child(_melee)
	_melee.begin(option("people"), root_mode(), source)
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	for tick: int in int(option("minutes") * 60.0 / delta):
		await physics_frame
		if tick % _LOOK_EVERY == 0:
			_look(int(tick * delta / Melee.ROUND_S))
		_melee.drive(tick * delta, delta)
	await physics_frame
	_tell(_melee.fingerprint(), other)


## The same in another process at the same time.
func _start_other() -> Dictionary:
	var script: String = (get_script() as GDScript).resource_path
	var command: PackedStringArray = [
		"--headless", "--path", ProjectSettings.globalize_path("res://")
	]
	command.append_array(["-s", script, "--", "--alone", "--json"])
	for name: String in ["people", "minutes", "root", "hz"]:
		command.append("--%s=%s" % [name, option(name)])
	return OS.execute_with_pipe(OS.get_executable_path(), command)


func _look(p_round: int) -> void:
	if p_round == _rounds.size():
		_rounds.append(Statistics.new())
	var all: float = 0.0
	for person: ContactPerson in _melee.people:
		var energy: float = person.energy()
		_highest = maxf(_highest, energy)
		all += energy
	_rounds[p_round].add(all)


func _tell(p_fingerprint: int, p_other: Dictionary) -> void:
	var parts: Array = [option("people"), option("root")]
	var case: String = "%d people, %s, " % parts + "%s min" % String.num(option("minutes"), 1)
	report.at_most(case, "highest energy of a person", _highest, "J", _MOST_ENERGY)
	# The last round is hardly ever whole.
	var half: int = (_rounds.size() - 1) / 2
	if half > 0:
		var growth: float = _mean_energy(half, half * 2) / maxf(_mean_energy(0, half), 1.0)
		report.at_most(case, "mean energy, second by first half", growth, "", _MOST_GROWTH)
	report.add(case, "fingerprint", p_fingerprint, "")
	if p_other.is_empty():
		return
	var same: float = 1.0 if _other_fingerprint(p_other) == float(p_fingerprint) else 0.0
	report.at_least(case, "the same in two processes", same, "", 1.0)


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

extends Bench
## What a server tick costs with many people: motor, physics step, read-out.
##
## Options: --people=16 (again for more cases), --bvh=FILE, --hz=60, --seconds=10 (simulated),
## --root=soft|grounded (default soft).
## Goals, at 60 Hz: 16 and 64 people leave half of a tick, a motor takes at most 12 us of it, 128
## people fit into a tick, and nobody costs more among many than alone.

const _ROOTS: Array[String] = ["soft", "grounded"]
const _GOAL_FREE: float = 50.0
const _GOAL_FREE_PEOPLE: Array[int] = [16, 64]
const _GOAL_MOTOR_US: float = 12.0
## Of people who stand on their own feet.
const _GOAL_GROUNDED_US: float = 25.0
const _GOAL_MOTOR_PEOPLE: int = 64
const _GOAL_REAL_TIME_PEOPLE: int = 128
const _GOAL_FLAT: float = 1.2
const _WARM_UP: int = 60

## Cost of a person in each case, us.
var _costs: Dictionary[int, float] = {}


func options() -> Dictionary:
	return {
		"people": ["", 1, 1024],
		"bvh": "res://assets/motion/01_01.bvh",
		"hz": [60, 10, 1000],
		"seconds": 10.0,
		"root": ["soft", _ROOTS]
	}


func measure() -> void:
	var source: BvhSource = report.open_clip(option("bvh"))
	if source == null:
		return
	# The first frame's step is still to come: nobody is to be there yet.
	await process_frame
	Engine.physics_ticks_per_second = option("hz")
	for people: String in values("people", ["1", "4", "16", "64", "128"]):
		await _run_case(people.to_int(), source)
	_compare_costs()


func _run_case(p_people: int, p_source: BvhSource) -> void:
	var crowd: BenchCrowd = BenchCrowd.new(p_people, p_source, root, root_mode())
	var motors: Statistics = Statistics.new()
	var ticks: Statistics = Statistics.new()
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	var last: int = 0
	for tick: int in int(option("seconds") / delta) + _WARM_UP:
		await physics_frame
		var begin: int = Time.get_ticks_usec()
		if tick > _WARM_UP:
			ticks.add((begin - last) / 1000.0)
		crowd.push(tick * delta)
		last = Time.get_ticks_usec()
		crowd.drive(tick * delta, delta)
		if tick > _WARM_UP:
			motors.add(float(Time.get_ticks_usec() - last) / p_people)
	crowd.leave()
	await process_frame
	_add_stats(p_people, ticks, motors)


func _add_stats(p_people: int, p_ticks: Statistics, p_motors: Statistics) -> void:
	var is_named: bool = Engine.physics_ticks_per_second == 60
	var name: String = "%d people, %d Hz" % [p_people, Engine.physics_ticks_per_second]
	var tick_ms: float = 1000.0 / Engine.physics_ticks_per_second
	var middle: float = p_ticks.percentile(0.5)
	var in_time: bool = is_named and p_people == _GOAL_REAL_TIME_PEOPLE
	var quick: bool = is_named and p_people == _GOAL_MOTOR_PEOPLE
	var half: bool = is_named and _GOAL_FREE_PEOPLE.has(p_people)
	report.add(name, "tick p50", middle, "ms")
	report.at_most(name, "tick p99", p_ticks.percentile(0.99), "ms", tick_ms, in_time)
	var is_grounded: bool = option("root") == "grounded"
	var most: float = _GOAL_GROUNDED_US if is_grounded else _GOAL_MOTOR_US
	report.at_most(name, "motor p50, each", p_motors.percentile(0.5), "us", most, quick)
	report.at_least(name, "tick left over", 100.0 * (1.0 - middle / tick_ms), "%", _GOAL_FREE, half)
	_costs[p_people] = 1000.0 * middle / p_people
	report.add(name, "tick p50, each", _costs[p_people], "us")


## What a person costs in the largest case, by what one costs in the smallest.
func _compare_costs() -> void:
	var people: Array = _costs.keys()
	people.sort()
	if people.size() < 2:
		return
	var name: String = "%d people by %d" % [people[-1], people[0]]
	var is_named: bool = people[0] == 1 and people[-1] == _GOAL_REAL_TIME_PEOPLE
	var ratio: float = _costs[people[-1]] / _costs[people[0]]
	report.at_most(name, "cost of a person", ratio, "", _GOAL_FLAT, is_named)

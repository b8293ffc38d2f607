class_name GroundRises
extends RefCounted
## Many people who lie as they fell, each on a floor of its own, and get up.

## How many there are in a world.
const PEOPLE: int = 10

## How they fall: push at the chest, N·s, and turn about the vertical, N·m·s.
const _PUSHES: Vector2 = Vector2(40.0, 120.0)
const _TURN: float = 15.0
## Seconds until they fall, that they lie, that they are watched.
const _STAND_S: float = 1.0
const _LIE_S: float = 3.0
const _WATCH_S: float = 6.0
const _APART: float = 10.0
const _IN_A_ROW: int = 5

var _report: BenchReport = null
var _risers: Array[GroundRiser] = []
var _all: Array[GroundRiser] = []


func _init(p_report: BenchReport) -> void:
	_report = p_report


## Ten people get up in [param p_world], with a crate of some mass (kg, 0 for none) on the chest.
## [param p_enter] makes a person in the world.
func run(p_world: ContactWorld, p_enter: Callable, p_load: float, p_seed: int) -> void:
	var chance: RandomNumberGenerator = RandomNumberGenerator.new()
	chance.seed = p_seed
	_risers = []
	for i: int in PEOPLE:
		_add(p_world, p_enter.call(), _place_of(i))
	await p_world.run(_STAND_S)
	for i: int in PEOPLE:
		var angle: float = TAU * (i + chance.randf()) / PEOPLE
		var push: Vector3 = Vector3(sin(angle), 0.0, cos(angle))
		push *= chance.randf_range(_PUSHES.x, _PUSHES.y)
		_risers[i].fall(push, chance.randf_range(-_TURN, _TURN))
	await p_world.run(_LIE_S)
	for riser: GroundRiser in _risers:
		if p_load > 0.0:
			var chest: int = riser.person.find(&"Chest")
			var above: Vector3 = riser.person.bodies()[chest].origin + Vector3.UP * 0.35
			riser.bear(p_world.add_crate(Vector3(0.4, 0.3, 0.4), above, p_load))
		riser.rise()
	var began_s: float = p_world.time_s
	await p_world.run(
		_WATCH_S,
		func() -> bool:
			for riser: GroundRiser in _risers:
				riser.note(p_world.time_s - began_s, p_world.delta_s)
			return false
	)
	_all.append_array(_risers)


func _place_of(p_index: int) -> Vector3:
	return Vector3(p_index % _IN_A_ROW, 0.0, floori(float(p_index) / _IN_A_ROW)) * _APART


func _add(p_world: ContactWorld, p_person: ContactPerson, p_at: Vector3) -> void:
	_risers.append(GroundRiser.new(p_person, GroundPlate.new(p_world, p_at)))
	p_world.add_standing(p_person, ContactPoses.standing(p_person), p_at + p_person.standing_hips())


## Reports on everybody so far.
func tell(p_load: float) -> void:
	var who: String = "%d who lie" % _all.size()
	who += ", %.0f kg on them" % p_load if p_load > 0.0 else ""
	var times: PackedFloat64Array = []
	var impulses: PackedFloat64Array = []
	var wholes: PackedFloat64Array = []
	var torques: PackedFloat64Array = []
	var hands: PackedFloat64Array = []
	var ups: int = 0
	var legs_up_s: float = 0.0
	var head_down_s: float = 0.0
	for riser: GroundRiser in _all:
		times.append(riser.up_s)
		ups += 1 if riser.up_s < _WATCH_S else 0
		impulses.append(riser.impulse)
		wholes.append(riser.whole_impulse)
		torques.append(GroundRun.percentile(riser.torques, 0.95))
		hands.append(riser.hands)
		legs_up_s += riser.legs_up_s / _all.size()
		head_down_s += riser.head_down_s / _all.size()
	_report.at_least(who, "up again", ups, "", _all.size())
	_report.at_most(who, "upright after, median", GroundRun.percentile(times, 0.5), "s", 4.0)
	_report.at_most(who, "upright after, p90", GroundRun.percentile(times, 0.9), "s", 4.0)
	_report.at_most(who, "impulse from outside", GroundRun.mean(impulses), "N m s", 60.0)
	_report.add(who, "impulse within 4 s, standing too", GroundRun.mean(wholes), "N m s")
	_report.at_most(who, "torque p95", GroundRun.mean(torques), "N m", 60.0)
	_report.at_least(who, "weight on hands, median", GroundRun.percentile(hands, 0.5), "%", 30.0)
	_report.at_most(who, "legs in the air, mean", legs_up_s, "s", 0.0)
	_report.at_most(who, "head down, mean", head_down_s, "s", 0.0)

extends SceneTree
## Vehicles: what they can do beside the published performance of real ones, what they cost, and
## random driving.
##
## Options: --preset=tank|carrier|truck|scootmobile (default tank), --gear=spheres|rays (default
## both where the preset has both), --scene=published|compare|cost|mishaps|hatch|stabiliser|
## firing|prediction|wire|random (again for more; default all), --seeds=3, --minutes=1 (of
## random, for each seed; 20 and 10 are the goal's; of hatch and stabiliser, for each case; 5 are
## the goal's), --world=NAME (of random: desert, town or crates; default one after the other).

const _SCENES: Array[String] = [
	"published",
	"compare",
	"cost",
	"mishaps",
	"hatch",
	"stabiliser",
	"firing",
	"prediction",
	"wire",
	"random",
]
const _KINDS: Dictionary[String, VehicleParameters.GearKind] = {
	"spheres": VehicleParameters.GearKind.SPHERES,
	"rays": VehicleParameters.GearKind.RAYS,
}

var _arguments: BenchArguments = null
var _report: BenchReport = null


func _initialize() -> void:
	_arguments = (
		BenchArguments
		. parse(
			OS.get_cmdline_user_args(),
			{
				"preset": "tank",
				"gear": "",
				"scene": "",
				"seeds": 3,
				"minutes": 1.0,
				"world": "",
				"seed": -1,
				"hz": 60,
			}
		)
	)
	_run.call_deferred()


func _run() -> void:
	var fault: String = _find_fault()
	if fault != "":
		printerr(fault)
		quit(2)
		return
	if _arguments.value("seed") >= 0:
		await _run_seed()
		quit(0)
		return
	_report = BenchReport.new("vehicle", _arguments.value("json"))
	var scenes: PackedStringArray = _arguments.list("scene")
	for name: String in _SCENES:
		if not scenes.is_empty() and not scenes.has(name):
			continue
		match name:
			"published":
				for gear: String in _gears():
					await VehiclePublished.run(self, _report, _preset(), gear, _KINDS[gear])
			"compare":
				for gear: String in _gears():
					await VehicleComparison.run(self, _report, _preset(), gear, _KINDS[gear])
			"cost":
				for gear: String in _gears():
					await VehicleCost.run(self, _report, _preset(), gear, _KINDS[gear])
			"mishaps":
				for gear: String in _gears():
					await VehicleMishaps.run(self, _report, _preset(), gear, _KINDS[gear])
			"hatch":
				for gear: String in _gears_of_tank():
					await VehicleHatch.run(self, _report, gear, _KINDS[gear], _minutes())
			"stabiliser":
				for gear: String in _gears_of_tank():
					await VehicleStabiliser.run(self, _report, gear, _KINDS[gear], _minutes())
			"wire":
				for gear: String in _gears():
					await VehicleWire.run(self, _report, _preset(), gear, _KINDS[gear])
			"prediction":
				for gear: String in _gears():
					await VehiclePrediction.run(self, _report, _preset(), gear, _KINDS[gear])
			"firing":
				if _preset() == "tank":
					await VehicleFiring.run(self, _report)
			"random":
				for gear: String in _gears():
					_run_random(gear)
	quit(_report.finish())


func _preset() -> String:
	return _arguments.value("preset")


func _minutes() -> float:
	return _arguments.value("minutes")


## The running gears that are meant, of scenes about the tank's turret.
func _gears_of_tank() -> PackedStringArray:
	return _gears() if _preset() == "tank" else PackedStringArray()


## The running gears that are meant: those that the preset has.
func _gears() -> PackedStringArray:
	var vehicle: Vehicle = VehicleGround.create(_preset())
	var wanted: PackedStringArray = _arguments.list("gear")
	var found: PackedStringArray = PackedStringArray()
	for name: String in _KINDS:
		var has: bool = not vehicle.parameters.wheels_of(_KINDS[name]).is_empty()
		if has and (wanted.is_empty() or wanted.has(name)):
			found.append(name)
	vehicle.free()
	return found


func _find_fault() -> String:
	if _arguments.error != "":
		return _arguments.error
	if not FileAccess.file_exists("res://scenes/vehicle/%s/%s.tscn" % [_preset(), _preset()]):
		return "there is no preset '%s'" % _preset()
	for name: String in _arguments.list("scene"):
		if not _SCENES.has(name):
			return "a scene is one of %s, found '%s'" % [", ".join(_SCENES), name]
	for name: String in _arguments.list("gear"):
		if not _KINDS.has(name):
			return "a gear is one of %s, found '%s'" % [", ".join(_KINDS.keys()), name]
	for name: String in _arguments.list("world"):
		if not VehicleWander.WORLDS.has(name):
			return "a world is one of %s, found '%s'" % [", ".join(VehicleWander.WORLDS), name]
	if _arguments.value("seeds") < 1 or not _arguments.value("minutes") > 0.0:
		return "--seeds and --minutes must be above zero"
	return ""


## One seed in this process: its outcome is the last line.
func _run_seed() -> void:
	var world: String = _arguments.value("world")
	var kind: VehicleParameters.GearKind = _KINDS[_arguments.value("gear")]
	var wander: VehicleWander = VehicleWander.new(self, _preset(), kind, world)
	await wander.run(_arguments.value("seed"), _arguments.value("minutes"))
	print(JSON.stringify(wander.outcome()))


## All seeds, each twice and in processes of their own: a second world in one process counts its
## bodies on, and is another.
func _run_random(p_gear: String) -> void:
	var worlds: PackedStringArray = _arguments.list("world")
	if worlds.is_empty():
		worlds = PackedStringArray(VehicleWander.WORLDS)
	var options: PackedStringArray = [
		"--preset=" + _preset(),
		"--gear=" + p_gear,
		"--minutes=%s" % _arguments.value("minutes"),
	]
	VehicleWander.run_seeds(_report, p_gear, options, worlds, _arguments.value("seeds"))

extends Bench
## Vehicles: what they can do beside the published performance of real ones, what they cost, and
## random driving.
##
## Options: --preset=tank|carrier|truck|scootmobile (default tank), --gear=spheres|rays (default
## both where the preset has both), --scene=published|compare|cost|mishaps|hatch|stabiliser|
## firing|prediction|wire|random (again for more; default all), --seeds=3, --minutes=1 (of
## random, for each seed; 20 and 10 are the goal's; of hatch and stabiliser, for each case; 5 are
## the goal's), --world=NAME (of random: desert, town or crates; default one after the other).

const _SCENES: Dictionary[String, GDScript] = {
	"published": preload("vehicle/vehicle_published.gd"),
	"compare": preload("vehicle/vehicle_comparison.gd"),
	"cost": preload("vehicle/vehicle_cost.gd"),
	"mishaps": preload("vehicle/vehicle_mishaps.gd"),
	"hatch": preload("vehicle/vehicle_hatch.gd"),
	"stabiliser": preload("vehicle/vehicle_stabiliser.gd"),
	"firing": preload("vehicle/vehicle_firing.gd"),
	"prediction": preload("vehicle/vehicle_prediction.gd"),
	"wire": preload("vehicle/vehicle_wire.gd"),
	"random": null,
}
## Scenes about the tank's turret.
const _OF_TANK: Array[String] = ["hatch", "stabiliser", "firing"]
const _KINDS: Dictionary[String, VehicleParameters.GearKind] = {
	"spheres": VehicleParameters.GearKind.SPHERES,
	"rays": VehicleParameters.GearKind.RAYS,
}


func options() -> Dictionary:
	return {
		"preset": "tank",
		"gear": ["", _KINDS.keys()],
		"scene": ["", _SCENES.keys()],
		"seeds": [3, 1, 10000],
		"minutes": [1.0, 0.001, 10000.0],
		"world": ["", VehicleWander.WORLDS],
		"seed": -1,
		"hz": 60,
	}


func find_fault() -> String:
	if not FileAccess.file_exists("res://scenes/vehicle/%s/%s.tscn" % [_preset(), _preset()]):
		return "there is no preset '%s'" % _preset()
	return ""


func measure() -> void:
	if option("seed") >= 0:
		await _run_seed()
		return
	for name: String in _SCENES:
		var is_wanted: bool = name in values("scene", _SCENES.keys())
		if not is_wanted or (name in _OF_TANK and _preset() != "tank"):
			continue
		# Guns know nothing of what a tank runs on.
		for gear: String in _gears() if name != "firing" else PackedStringArray(["spheres"]):
			if name == "random":
				_run_random(gear)
				continue
			var case: VehicleCase = _SCENES[name].new()
			case.tree = self
			case.report = report
			case.preset = _preset()
			case.gear = gear
			case.kind = _KINDS[gear]
			case.minutes = option("minutes")
			await case.run()


func _preset() -> String:
	return option("preset")


## The running gears that are meant: those that the preset has.
func _gears() -> PackedStringArray:
	var vehicle: Vehicle = VehicleGround.create(_preset())
	var wanted: PackedStringArray = arguments.list("gear")
	var found: PackedStringArray = PackedStringArray()
	for name: String in _KINDS:
		var has: bool = not vehicle.parameters.wheels_of(_KINDS[name]).is_empty()
		if has and (wanted.is_empty() or wanted.has(name)):
			found.append(name)
	vehicle.free()
	return found


## One seed in this process: its outcome is the last line.
func _run_seed() -> void:
	var world: String = option("world")
	var kind: VehicleParameters.GearKind = _KINDS[option("gear")]
	var wander: VehicleWander = VehicleWander.new(self, _preset(), kind, world)
	await wander.run(option("seed"), option("minutes"))
	print(JSON.stringify(wander.outcome()))


## All seeds, each twice and in processes of their own: a second world in one process counts its
## bodies on, and is another.
func _run_random(p_gear: String) -> void:
	var worlds: PackedStringArray = arguments.list("world")
	if worlds.is_empty():
		worlds = PackedStringArray(VehicleWander.WORLDS)
	var command: PackedStringArray = [
		"--preset=" + _preset(),
		"--gear=" + p_gear,
		"--minutes=%s" % option("minutes"),
	]
	VehicleWander.run_seeds(report, p_gear, command, worlds, option("seeds"))

class_name VehiclePublished
extends VehicleCase
## Published performance of a real vehicle beside ours. docs/vehicles.md names the sources.

# What a real one of the preset does. Speeds in km/h, times in s, ways and heights in m, slopes
# in %.
const _PUBLISHED: Dictionary[String, Dictionary] = {
	# Leopard 2A4 (trench and braking also of the M1).
	"tank":
	{
		"top speed": 72.0,
		"0 to 32 km/h": 7.0,
		"turn on the spot": 10.0,
		"slope": 60.0,
		"side slope": 30.0,
		"step": 1.0,
		"trench": 2.7,
		"braking from 60 km/h": 27.8,
	},
	# M113A3.
	"carrier": {"top speed": 66.0, "slope": 60.0, "side slope": 30.0, "step": 0.61, "trench": 1.68},
	# HMMWV M998.
	"truck": {"top speed": 112.0, "slope": 60.0, "side slope": 40.0},
	# A mobility scooter of class C2.
	"scootmobile": {"top speed": 15.0, "slope": 18.0},
}


## Runs all that is published of a preset.
func run() -> void:
	var courses: VehicleCourses = VehicleCourses.new(tree, preset, kind)
	var published: Dictionary = _PUBLISHED.get(preset, {})
	for metric: String in published:
		var theirs: float = published[metric]
		var ours: float = await _measure(courses, metric, theirs)
		var name: String = "%s, %s" % [preset, gear]
		report.add(name, metric + ", published", theirs, _unit(metric))
		if metric in ["slope", "side slope", "step", "trench"]:
			# These say what it must get over at least.
			report.at_least(name, metric, ours, _unit(metric), theirs)
			continue
		report.add(name, metric, ours, _unit(metric))
		var off: float = 100.0 * (ours / theirs - 1.0)
		report.within(name, metric + ", off by", off, "%", 10.0)


func _measure(p_courses: VehicleCourses, p_metric: String, p_theirs: float) -> float:
	var tenths: PackedFloat32Array = [0.8, 0.9, 1.0, 1.1, 1.2, 1.3]
	for index: int in tenths.size():
		tenths[index] *= p_theirs
	match p_metric:
		"top speed":
			return (await p_courses.top_speed()).x
		"0 to 32 km/h":
			return await p_courses.sprint(32.0)
		"0 to 48 km/h":
			return await p_courses.sprint(48.0)
		"turn on the spot":
			return (await p_courses.turn_on_the_spot()).x
		"braking from 60 km/h":
			return await p_courses.brake_from(60.0)
		"slope":
			return await p_courses.steepest(_shares(tenths))
		"side slope":
			return await p_courses.steepest_sideways(_shares(tenths))
		"step":
			return await p_courses.highest_step(tenths)
	return await p_courses.widest_trench(tenths)


static func _shares(p_percents: PackedFloat32Array) -> PackedFloat32Array:
	var shares: PackedFloat32Array = PackedFloat32Array()
	for percent: float in p_percents:
		shares.append(0.01 * percent)
	return shares


static func _unit(p_metric: String) -> String:
	if p_metric.contains("slope"):
		return "%"
	if p_metric == "top speed":
		return "km/h"
	return "s" if p_metric.begins_with("0 to") or p_metric.begins_with("turn") else "m"

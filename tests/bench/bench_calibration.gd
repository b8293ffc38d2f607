extends SceneTree
## How good calibrations are, of wearers who are not perfect, and what is made of them.
##
## Options: --only=PART (again for more; default all): clips (perfect wearers, filling, trackers),
## norths (sensors whose norths are apart), poses (poses held badly), forecast (the error that is
## told against the one that is there; --details=1 for each wearer), dressing (sensors put on
## anywhere), drift. --bvh=FILE (again for more; default the clips in assets/motion),
## --rounds=5 (wearers a case), --seed=1, --noise=0 (deg, of clips; others have 0.5 unless given),
## --norths=0,10,20,40,60 (deg), --poses=0,3,10 (deg), --efforts=0.3 (part by which movements are
## larger or smaller), --soft=3 (deg of soft tissue), --orders=20 (orders of dressing a case),
## of drift: --runs=6 (wearers a case), --minutes=10, --rates=0,1,3,5 (deg/min a sensor),
## --motions=NAME (again for more; default all): clip, stand, work, mixed, twisted, rifle,
## --orientations (sensors say nothing but those).

const _PARTS: Array[String] = ["clips", "norths", "poses", "forecast", "dressing", "drift"]

var _arguments: BenchArguments = null


func _initialize() -> void:
	_arguments = (
		BenchArguments
		. parse(
			OS.get_cmdline_user_args(),
			{
				"only": "",
				"bvh": "",
				"rounds": 5,
				"noise": 0.0,
				"seed": 1,
				"norths": "0,10,20,40,60",
				"poses": "0,3,10",
				"efforts": 0.3,
				"soft": 3.0,
				"orders": 20,
				"details": false,
				"runs": 6,
				"minutes": 10.0,
				"rates": "0,1,3,5",
				"motions": "",
				"orientations": false,
			}
		)
	)
	var fault: String = _find_fault()
	if fault != "":
		printerr(fault)
		quit(2)
		return
	var report: BenchReport = BenchReport.new("calibration", _arguments.value("json"))
	for name: String in _wanted():
		var path: String = "res://tests/bench/calibration/%s.gd" % name
		var script: GDScript = load(path)
		var part: Object = script.new()
		part.arguments = _arguments
		part.report = report
		part.measure()
	quit(report.finish())


func _wanted() -> PackedStringArray:
	var wanted: PackedStringArray = _arguments.list("only")
	if not wanted.is_empty():
		return wanted
	for name: String in _PARTS:
		wanted.append(name)
	return wanted


func _find_fault() -> String:
	if _arguments.error != "":
		return _arguments.error
	if _arguments.value("rounds") < 1 or _arguments.value("rounds") > 1000:
		return "--rounds is between 1 and 1000, found %d" % _arguments.value("rounds")
	if _arguments.value("orders") < 1 or _arguments.value("orders") > 1000:
		return "--orders is between 1 and 1000, found %d" % _arguments.value("orders")
	if not (_arguments.value("noise") >= 0.0 and _arguments.value("noise") < 45.0):
		return "--noise is between 0 and 45 deg, found %s" % _arguments.value("noise")
	if not (_arguments.value("soft") >= 0.0 and _arguments.value("soft") < 45.0):
		return "--soft is between 0 and 45 deg, found %s" % _arguments.value("soft")
	if not (_arguments.value("efforts") >= 0.0 and _arguments.value("efforts") < 0.9):
		return "--efforts is between 0 and 0.9, found %s" % _arguments.value("efforts")
	for name: String in _arguments.list("only"):
		if not _PARTS.has(name):
			return "--only is one of %s, found '%s'" % [", ".join(_PARTS), name]
	return ""

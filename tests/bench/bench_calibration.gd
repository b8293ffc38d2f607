extends Bench
## How good calibrations are, of wearers who are not perfect, and what is made of them.
##
## Options: --only=PART (again for more; default all): clips (perfect wearers, filling, trackers),
## norths (sensors whose norths are apart), poses (poses held badly), forecast (the error that is
## told against the one that is there), dressing (sensors put on anywhere), drift. --bvh=FILE (again for more; default the clips in assets/motion),
## --rounds=5 (wearers a case), --seed=1, --noise=0 (deg, of clips; others have 0.5 unless given),
## --norths=0,10,20,40,60 (deg), --poses=0,3,10 (deg), --efforts=0.3 (part by which movements are
## larger or smaller), --soft=3 (deg of soft tissue), --orders=20 (orders of dressing a case),
## of drift: --runs=6 (wearers a case), --minutes=10, --rates=0,1,3,5 (deg/min a sensor),
## --motions=NAME (again for more; default all): clip, stand, work, mixed, twisted, rifle,
## --orientations (sensors say nothing but those).

const _PARTS: Array[String] = ["clips", "norths", "poses", "forecast", "dressing", "drift"]


func options() -> Dictionary:
	return {
		"only": ["", _PARTS],
		"bvh": "",
		"rounds": [5, 1, 1000],
		"noise": [0.0, 0.0, 44.9],
		"seed": 1,
		"norths": "0,10,20,40,60",
		"poses": "0,3,10",
		"efforts": [0.3, 0.0, 0.89],
		"soft": [3.0, 0.0, 44.9],
		"orders": [20, 1, 1000],
		"runs": 6,
		"minutes": 10.0,
		"rates": "0,1,3,5",
		"motions": "",
		"orientations": false,
	}


func measure() -> void:
	for name: String in values("only", _PARTS):
		var part: Object = (load("res://tests/bench/calibration/%s.gd" % name) as GDScript).new()
		part.arguments = arguments
		part.report = report
		part.measure()

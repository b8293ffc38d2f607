extends Bench
## Where a person's travel comes from if no position is known: walking, stairs, jumps, on the
## bodies.
##
## Without --bvh: a made-up walker with the soldier's body (level at three speeds, clean and with
## 1 degree of noise; 16 stairs up and down), then the clips of assets/motion. Options: --bvh=FILE
## (again for more; its own hips are the truth), --root=inertial|contacts|lowest_foot|
## self_righting|pendulum (default the first three), --hz=60, --seed=1 (of the noise, and of the
## first scene), --cases=walks|stairs|clips|slopes|starts|scenes (again for more; default all, with
## --bvh the clips alone), --scenes=20 (how many random ones).

const Case: GDScript = preload("gait/gait_case.gd")
const _CASES: Dictionary[String, GDScript] = {
	"walks": preload("gait/gait_walks.gd"),
	"stairs": preload("gait/gait_walks.gd"),
	"clips": preload("gait/gait_clips.gd"),
	"slopes": preload("gait/gait_slopes.gd"),
	"starts": preload("gait/gait_starts.gd"),
	"scenes": preload("gait/gait_scenes.gd"),
}
const _ROOTS: Array[String] = ["inertial", "contacts", "lowest_foot", "self_righting", "pendulum"]


func options() -> Dictionary:
	return {
		"bvh": "",
		"root": ["", _ROOTS],
		"hz": [60, 10, 1000],
		"seed": 1,
		"cases": ["", _CASES.keys()],
		"scenes": 20,
	}


func measure() -> void:
	Engine.physics_ticks_per_second = option("hz")
	var usual: Array = ["clips"] if arguments.is_given("bvh") else _CASES.keys()
	for name: String in values("root", ["inertial", "contacts", "lowest_foot"]):
		for kind: String in values("cases", usual):
			var case: Case = _CASES[kind].new(self, report, option("seed"))
			case.root_name = name
			case.root_mode = RootModes.BY_NAME[name]
			match kind:
				"stairs":
					case.climbs = true
				"clips":
					case.files = BenchArguments.clips(arguments)
				"scenes":
					case.count = option("scenes")
					case.clips = _open_clips()
			await case.run()


func _open_clips() -> Array[BvhSource]:
	var result: Array[BvhSource] = []
	for file: String in BenchArguments.clips(arguments):
		var source: BvhSource = BvhSource.new()
		source.open(file)
		if source.error == "":
			result.append(source)
	return result

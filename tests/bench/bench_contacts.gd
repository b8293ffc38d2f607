extends Bench
## What happens when people touch things: walls, balls, crates, each other.
##
## Options: --scene=NAME (again for more; default all), --hz=60 (again for more; default 60, walls
## at 120 too), --bvh=FILE (again for more; default the three clips in assets/motion),
## --body=soldier|file (default both), --root=held|soft|grounded, --gain=50 (1/s),
## --mode=velocity_motor (or another that bench_tracking knows), --set=PROPERTY=NUMBER (of Ragdoll).

const _SCENES: Dictionary[String, GDScript] = {
	"jitter": preload("contacts/scene_jitter.gd"),
	"wall": preload("contacts/scene_wall.gd"),
	"ball": preload("contacts/scene_ball.gd"),
	"hit": preload("contacts/scene_hit.gd"),
	"fist": preload("contacts/scene_fist.gd"),
	"hug": preload("contacts/scene_hug.gd"),
	"crate": preload("contacts/scene_crate.gd"),
	"self": preload("contacts/scene_self.gd"),
	"touch": preload("contacts/scene_touch.gd"),
}
## Scenes in which the motion comes from the clip; in others one of each build plays.
const _FROM_CLIPS: Array[String] = ["jitter", "wall", "fist"]
## Scenes that are also played at 120 Hz, and those that are played with both kinds of root.
const _FAST_TOO: Array[String] = ["wall"]
const _BOTH_ROOTS: Array[String] = ["jitter"]
## Scenes that are played on the own feet, as sessions are, besides.
const _GROUNDED_TOO: Array[String] = ["self", "touch"]
const TrackingCase: GDScript = preload("tracking/tracking_case.gd")

## Clips that are shorter hold no movement to measure, s.
const _SHORTEST_S: float = 1.0

var _performers: Array[ContactPerformer] = []
var _properties: Dictionary[StringName, float] = {}


func options() -> Dictionary:
	return {
		"scene": ["", _SCENES.keys()],
		"hz": ["", 10, 1000],
		"bvh": "",
		"body": ["", ["soldier", "file"]],
		"root": ["", ["held", "soft", "grounded"]],
		"gain": 50.0,
		"mode": ["velocity_motor", TrackingCase.MODES],
		"set": ""
	}


## Applies --set.
func find_fault() -> String:
	return _apply_settings()


func measure() -> void:
	# The first frame's step is still to come.
	await process_frame
	await process_frame
	_cast()
	for name: String in _SCENES:
		if name in values("scene", _SCENES.keys()):
			await _play(name)


func _play(p_name: String) -> void:
	var roots: Array = ["held", "soft"] if p_name in _BOTH_ROOTS else ["soft"]
	if p_name in _GROUNDED_TOO:
		roots = ["grounded", "soft"]
	for rate: String in values("hz", ["60", "120"] if p_name in _FAST_TOO else ["60"]):
		Engine.physics_ticks_per_second = rate.to_int()
		for root_name: String in values("root", roots):
			for performer: ContactPerformer in _cast_of(p_name):
				var scene: ContactScene = _SCENES[p_name].new()
				scene.tree = self
				scene.report = report
				scene.hz = rate.to_int()
				scene.root = RootModes.BY_NAME[root_name]
				await scene.play(performer)


func _cast_of(p_name: String) -> Array[ContactPerformer]:
	if p_name in _FROM_CLIPS:
		return _performers
	var cast: Array[ContactPerformer] = []
	var builds: PackedStringArray = PackedStringArray()
	for performer: ContactPerformer in _performers:
		var build: String = performer.get_build()
		if not builds.has(build):
			builds.append(build)
			cast.append(performer)
	return cast


## Reads --set; returns what is wrong.
func _apply_settings() -> String:
	_properties[&"gain"] = option("gain")
	_properties[&"actuation"] = TrackingCase.MODES.find(option("mode"))
	var probe: Ragdoll = Ragdoll.new()
	var fault: String = ""
	for pair: String in arguments.list("set"):
		var name: String = pair.get_slice("=", 0)
		var number: String = pair.get_slice("=", 1)
		if not number.is_valid_float():
			fault = "--set expects NAME=NUMBER, found '%s'" % pair
		elif name in probe:
			_properties[StringName(name)] = number.to_float()
		else:
			fault = "--set: there is no '%s'" % name
	probe.free()
	return fault


## Opens the motion files.
func _cast() -> void:
	var bodies: PackedStringArray = arguments.list("body")
	for file: String in BenchArguments.clips(arguments):
		var source: BvhSource = report.open_clip(file)
		if source == null:
			continue
		if source.rig.clip.duration() < _SHORTEST_S:
			var parts: Array = [source.rig.clip.duration(), _SHORTEST_S]
			report.leave_out(file, "%.2f s are too short for a blow: %.0f s is the least" % parts)
			continue
		# The soldier plays the first file only: the others would tell the same of its body.
		if _performers.is_empty() and (bodies.is_empty() or bodies.has("soldier")):
			_performers.append(ContactPerformer.new(source, true, _properties))
		if bodies.is_empty() or bodies.has("file"):
			_performers.append(ContactPerformer.new(source, false, _properties))

extends SceneTree
## What happens when people touch things: walls, balls, crates, each other.
##
## Options: --scene=NAME (again for more; default all), --hz=60 (again for more; default 60, walls
## at 120 too), --bvh=FILE (again for more; default the three clips in assets/motion),
## --body=soldier|file (default both), --root=held|soft, --gain=50 (1/s), --mode=velocity_motor
## (or another that bench_tracking knows), --set=PROPERTY=NUMBER (of Ragdoll),
## --jolt=SETTING=NUMBER (below physics/jolt_physics_3d/).

const _SCENES: Dictionary[String, GDScript] = {
	"jitter": preload("contacts/scene_jitter.gd"),
	"wall": preload("contacts/scene_wall.gd"),
	"ball": preload("contacts/scene_ball.gd"),
	"hit": preload("contacts/scene_hit.gd"),
	"fist": preload("contacts/scene_fist.gd"),
	"hug": preload("contacts/scene_hug.gd"),
	"crate": preload("contacts/scene_crate.gd"),
}
## Scenes in which the motion comes from the clip; in others one of each build plays.
const _FROM_CLIPS: Array[String] = ["jitter", "wall", "fist"]
## Scenes that are also played at 120 Hz, and those that are played with both kinds of root.
const _FAST_TOO: Array[String] = ["wall"]
const _BOTH_ROOTS: Array[String] = ["jitter"]
const TrackingCase: GDScript = preload("tracking/tracking_case.gd")

## Clips that are shorter hold no movement to measure, s.
const _SHORTEST_S: float = 1.0

var _arguments: BenchArguments = null
var _performers: Array[ContactPerformer] = []
var _properties: Dictionary[StringName, float] = {}


func _initialize() -> void:
	_arguments = BenchArguments.parse(
		OS.get_cmdline_user_args(),
		{
			"scene": "",
			"hz": "",
			"bvh": "",
			"body": "",
			"root": "",
			"gain": 50.0,
			"mode": "velocity_motor",
			"set": "",
			"jolt": ""
		}
	)
	_run.call_deferred()


func _run() -> void:
	var fault: String = _find_fault()
	if fault == "":
		fault = _apply_settings()
	if fault != "":
		printerr(fault)
		quit(2)
		return
	# Project settings reach the physics server at the end of the frame in which they were set.
	await process_frame
	await process_frame
	var report: BenchReport = BenchReport.new("contacts", _arguments.value("json"))
	_cast(report)
	var names: PackedStringArray = _arguments.list("scene")
	for name: String in _SCENES:
		if names.is_empty() or names.has(name):
			await _play(name, report)
	quit(report.finish())


func _play(p_name: String, p_report: BenchReport) -> void:
	var rates: PackedStringArray = _arguments.list("hz")
	if rates.is_empty():
		rates = ["60", "120"] if p_name in _FAST_TOO else ["60"]
	var roots: PackedStringArray = _arguments.list("root")
	if roots.is_empty():
		roots = ["held", "soft"] if p_name in _BOTH_ROOTS else ["soft"]
	for rate: String in rates:
		Engine.physics_ticks_per_second = rate.to_int()
		for root_name: String in roots:
			for performer: ContactPerformer in _cast_of(p_name):
				var scene: ContactScene = _SCENES[p_name].new()
				scene.tree = self
				scene.report = p_report
				scene.hz = rate.to_int()
				scene.root = (
					RagdollMotor.ROOT_HELD if root_name == "held" else RagdollMotor.ROOT_SOFT
				)
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


func _find_fault() -> String:
	if _arguments.error != "":
		return _arguments.error
	var known: Dictionary[String, Array] = {
		"scene": _SCENES.keys(), "body": ["soldier", "file"], "root": ["held", "soft"]
	}
	known["mode"] = Array(TrackingCase.MODES)
	for option: String in known:
		for value: String in _arguments.list(option):
			if not value in known[option]:
				var options: String = ", ".join(known[option])
				return "--%s is one of %s; found '%s'" % [option, options, value]
	for rate: String in _arguments.list("hz"):
		if not rate.is_valid_int() or rate.to_int() < 10 or rate.to_int() > 1000:
			return "a tick rate is between 10 and 1000, found '%s'" % rate
	return ""


## Reads --set and --jolt; returns what is wrong.
func _apply_settings() -> String:
	_properties[&"gain"] = _arguments.value("gain")
	_properties[&"actuation"] = TrackingCase.MODES.find(_arguments.value("mode"))
	var probe: Ragdoll = Ragdoll.new()
	var fault: String = ""
	for option: String in ["set", "jolt"]:
		for pair: String in _arguments.list(option):
			var name: String = pair.get_slice("=", 0)
			var number: String = pair.get_slice("=", 1)
			var setting: String = "physics/jolt_physics_3d/" + name
			if not number.is_valid_float():
				fault = "--%s expects NAME=NUMBER, found '%s'" % [option, pair]
			elif option == "set" and name in probe:
				_properties[StringName(name)] = number.to_float()
			elif option == "jolt" and ProjectSettings.has_setting(setting):
				var old: Variant = ProjectSettings.get_setting(setting)
				ProjectSettings.set_setting(setting, type_convert(number.to_float(), typeof(old)))
			else:
				fault = "--%s: there is no '%s'" % [option, name]
	probe.free()
	return fault


## Opens the motion files.
func _cast(p_report: BenchReport) -> void:
	var bodies: PackedStringArray = _arguments.list("body")
	for file: String in BenchArguments.clips(_arguments):
		var source: BvhSource = p_report.open_clip(file)
		if source == null:
			continue
		if source.rig.clip.duration() < _SHORTEST_S:
			var parts: Array = [source.rig.clip.duration(), _SHORTEST_S]
			p_report.leave_out(file, "%.2f s are too short for a blow: %.0f s is the least" % parts)
			continue
		# The soldier plays the first file only: the others would tell the same of its body.
		if _performers.is_empty() and (bodies.is_empty() or bodies.has("soldier")):
			_performers.append(ContactPerformer.new(source, true, _properties))
		if bodies.is_empty() or bodies.has("file"):
			_performers.append(ContactPerformer.new(source, false, _properties))

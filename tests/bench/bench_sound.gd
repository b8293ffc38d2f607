extends SceneTree
## What the sounds of the world are like and what they cost: figures of each synthesised sound, and
## of the mix, captured: levels, walls, engines, voices, a full scene.
##
## Options: --part=files, levels, walls, engine, delay, voices, scene or binaural; all without. It
## needs no display and no sound card: the engine's silent driver mixes in real time.

const Files: GDScript = preload("sound/sound_files.gd")
const Mix: GDScript = preload("sound/sound_mix.gd")
const Scene: GDScript = preload("sound/sound_scene.gd")
const Binaural: GDScript = preload("sound/sound_binaural.gd")
const _PARTS: PackedStringArray = [
	"files", "levels", "walls", "engine", "delay", "voices", "scene", "binaural"
]


func _initialize() -> void:
	var arguments: BenchArguments = BenchArguments.parse(OS.get_cmdline_user_args(), {"part": ""})
	var part: String = arguments.value("part")
	if arguments.error == "" and part != "" and not _PARTS.has(part):
		arguments.error = "--part is one of %s" % ", ".join(_PARTS)
	if arguments.error != "":
		printerr(arguments.error)
		quit(2)
		return
	_run.call_deferred(part, BenchReport.new("sound", arguments.value("json")))


func _run(p_part: String, p_report: BenchReport) -> void:
	Engine.max_fps = 60
	if p_part in ["", "files"]:
		Files.measure(p_report)
	var mix: RefCounted = Mix.new(self, p_report)
	for part: String in ["levels", "walls", "engine", "delay"]:
		if p_part in ["", part]:
			await mix.call("measure_" + part)
	var scene: RefCounted = Scene.new(self, p_report)
	for part: String in ["voices", "scene"]:
		if p_part in ["", part]:
			await scene.call("measure_" + part)
	if p_part in ["", "binaural"]:
		var binaural: RefCounted = Binaural.new(self, p_report)
		await binaural.measure_binaural()
	quit(p_report.finish())

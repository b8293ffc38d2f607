extends Bench
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


func options() -> Dictionary:
	return {"part": ["", _PARTS]}


func measure() -> void:
	var wanted: PackedStringArray = values("part", Array(_PARTS))
	Engine.max_fps = 60
	if "files" in wanted:
		Files.measure(report)
	var mix: RefCounted = Mix.new(self, report)
	var scene: RefCounted = Scene.new(self, report)
	var binaural: RefCounted = Binaural.new(self, report)
	var owners: Dictionary[String, RefCounted] = {"levels": mix, "walls": mix, "engine": mix}
	owners.merge({"delay": mix, "voices": scene, "scene": scene, "binaural": binaural})
	for part: String in owners:
		if part in wanted:
			await owners[part].call("measure_" + part)

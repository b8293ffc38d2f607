class_name SoundBank
extends RefCounted
## All sounds by name, with how loud they are and how far they are heard. Their files are
## [code]assets/sound/NAME_1.wav[/code] and on, or [code]NAME.wav[/code]; loops end in
## [code]_loop[/code].

## Folder of the files.
const FOLDER: String = "res://assets/sound/"
## Most takes of a sound.
const MAX_TAKES: int = 8
## Beginnings of names, each with level at 1 m (dB over full scale), range (m), spread of the pitch,
## priority (dB). The longest that fits counts.
const _ROWS: Dictionary[String, Vector4] = {
	"": Vector4(-12.0, 40.0, 0.05, 0.0),
	"machine_gun_near": Vector4(26.0, 450.0, 0.02, 3.0),
	"machine_gun_far": Vector4(28.0, 1500.0, 0.03, 3.0),
	"cannon_near": Vector4(38.0, 700.0, 0.02, 9.0),
	"cannon_far": Vector4(42.0, 4000.0, 0.03, 9.0),
	"explosion_near": Vector4(38.0, 700.0, 0.04, 9.0),
	"explosion_far": Vector4(42.0, 4000.0, 0.05, 9.0),
	"bullet_crack": Vector4(18.0, 250.0, 0.04, 6.0),
	"ricochet": Vector4(2.0, 150.0, 0.12, 0.0),
	"gun_loaded": Vector4(-2.0, 30.0, 0.02, 3.0),
	"impact": Vector4(0.0, 120.0, 0.06, 0.0),
	"scrape": Vector4(-6.0, 50.0, 0.0, -3.0),
	"step": Vector4(-12.0, 45.0, 0.05, 0.0),
	"cloth": Vector4(-34.0, 10.0, 0.08, -6.0),
	"gear": Vector4(-26.0, 18.0, 0.08, -6.0),
	"door": Vector4(-8.0, 40.0, 0.06, 0.0),
	"hatch": Vector4(2.0, 80.0, 0.03, 0.0),
	"engine": Vector4(14.0, 700.0, 0.0, 3.0),
	"tracks": Vector4(12.0, 400.0, 0.0, 0.0),
	"tyres": Vector4(-2.0, 120.0, 0.0, 0.0),
	"motor": Vector4(-10.0, 50.0, 0.0, 0.0),
	"turret": Vector4(0.0, 80.0, 0.0, 0.0),
	"fire": Vector4(4.0, 120.0, 0.0, 0.0),
}
## What captions say of sounds whose names begin so.
const _CAPTIONS: Dictionary[String, String] = {
	"machine_gun": "Machine gun",
	"cannon": "Gun fires",
	"explosion": "Explosion",
	"bullet_crack": "Bullets pass",
	"ricochet": "Ricochet",
	"engine12_7": "Engine",
	"engine6_7": "Engine",
	"tracks_22": "Tracks",
	"door_shut": "Door",
	"hatch": "Hatch",
	"fire": "Fire",
}

static var _cues: Dictionary[StringName, SoundCue] = {}


## The sound of a name; null where there are no files of it.
static func find(p_name: StringName) -> SoundCue:
	if not _cues.has(p_name):
		_cues[p_name] = _load(p_name)
	return _cues[p_name]


## Forgets all that has been loaded.
static func clear() -> void:
	_cues.clear()


static func _load(p_name: StringName) -> SoundCue:
	var cue: SoundCue = SoundCue.new()
	cue.name = p_name
	cue.takes = _find_takes(p_name)
	if cue.takes.is_empty():
		Log.limited("audio", "cue", "there is no sound '%s' in %s" % [p_name, FOLDER])
		return null
	var row: Vector4 = _ROWS[_longest(_ROWS.keys(), p_name)]
	cue.level_db = row.x
	cue.range_m = row.y
	cue.pitch_spread = row.z
	cue.priority_db = row.w
	cue.caption = _CAPTIONS.get(_longest(_CAPTIONS.keys(), p_name), "")
	for take: AudioStream in cue.takes:
		cue.length_s = maxf(cue.length_s, take.get_length())
	return cue


static func _find_takes(p_name: String) -> Array[AudioStream]:
	var takes: Array[AudioStream] = []
	if not p_name.is_valid_filename():
		return takes
	if ResourceLoader.exists(FOLDER + p_name + ".wav"):
		var one: AudioStreamWAV = load(FOLDER + p_name + ".wav") as AudioStreamWAV
		if one != null and one.loop_mode != AudioStreamWAV.LOOP_DISABLED:
			# The importer leaves out the last sample of a loop.
			one.loop_end = one.data.size() / 2
		takes.append(one)
	for number: int in range(1, MAX_TAKES + 1):
		var path: String = "%s%s_%d.wav" % [FOLDER, p_name, number]
		if not ResourceLoader.exists(path):
			break
		takes.append(load(path) as AudioStream)
	return takes


static func _longest(p_keys: Array, p_name: String) -> String:
	var found: String = ""
	for key: String in p_keys:
		if p_name.begins_with(key) and key.length() > found.length():
			found = key
	return found

extends "sound_part.gd"
## Levels, walls, engines and delays, measured in the captured mix.

const Figures: GDScript = preload("sound_figures.gd")
const MixCapture: GDScript = preload("mix_capture.gd")
const _GOAL_LEVEL_DB: float = 1.0
const _GOAL_WALL_DB: float = 12.0
const _GOAL_LINE: float = 1.0
## A physics tick, a block of the silent driver (4,096 frames), and the frame that notices, ms.
const _GOAL_DELAY_MS: float = 1000.0 / 60.0 + 4096.0 / 48.0

var _mix: RefCounted = MixCapture.new()
var _rate: float = AudioServer.get_mix_rate()


## The level of a steady source at 1, 10 and 100 m beside its law.
func measure_levels() -> void:
	_begin()
	var voice: SoundVoice = _voices.start_loop(&"rain_loop", null)
	voice.cue = _steady(voice.cue)
	var levels: PackedFloat32Array = []
	for away: float in [1.0, 10.0, 100.0]:
		voice.place = Vector3(0.0, 0.0, -away)
		voice.gain_db = 0.0
		await _tree.create_timer(0.5).timeout
		levels.append(MixCapture.level_db(await _mix.record(_tree, 1.0)))
	for index: int in [1, 2]:
		var measured: float = levels[index] - levels[0]
		var law: float = voice.cue.level_at(pow(10.0, index)) - voice.cue.level_at(1.0)
		var case: String = "%d m" % roundi(pow(10.0, index))
		_report.within(
			case, "level beside its law of %.0f dB" % law, measured - law, "dB", _GOAL_LEVEL_DB
		)
	_end()


## What a wall of the level takes above 1 kHz.
func measure_walls() -> void:
	_begin()
	var voice: SoundVoice = _voices.start_loop(&"rain_loop", null)
	voice.cue = _steady(voice.cue)
	voice.place = Vector3(0.0, 0.0, -6.0)
	voice.gain_db = 6.0
	await _tree.create_timer(0.6).timeout
	var open: PackedFloat32Array = MixCapture.mono(await _mix.record(_tree, 1.0))
	var wall: StaticBody3D = StaticBody3D.new()
	wall.add_child(BenchBodies.box(Vector3(8.0, 4.0, 0.2)))
	wall.position.z = -3.0
	_add(wall)
	await _tree.create_timer(0.8).timeout
	var shut: PackedFloat32Array = MixCapture.mono(await _mix.record(_tree, 1.0))
	var less: float = (
		Figures.level_above_db(open, 1000.0, _rate) - Figures.level_above_db(shut, 1000.0, _rate)
	)
	_report.at_least("wall", "less above 1 kHz", less, "dB", _GOAL_WALL_DB)
	_end()


## The strongest line of an engine at revolutions between its loops, and steps on the way up.
func measure_engine() -> void:
	_begin()
	var place: Node3D = Node3D.new()
	place.position = Vector3(0.0, 0.0, -10.0)
	_add(place)
	var engine: BlendedLoops = BlendedLoops.new(
		_voices, "engine12", ["700", "1200", "1800", "2600"], VehicleSound.RPMS, place
	)
	for rpm: int in [700, 920, 1400, 1500, 2150, 2600]:
		engine.set_value(rpm, 0.0)
		await _tree.create_timer(0.5).timeout
		var frames: PackedVector2Array = await _mix.record(_tree, 2.0)
		var thin: PackedFloat32Array = Figures.thinned(MixCapture.mono(frames), 24)
		var hz: float = Figures.strongest_hz(thin, 40.0, 400.0, 0.4, _rate / 24.0)
		_report.within(
			"%d rpm" % rpm,
			"strongest line beside rpm / 10 Hz",
			100.0 * (hz * 10.0 / rpm - 1.0),
			"%",
			_GOAL_LINE
		)
	await _sweep(engine)
	engine.stop()
	_end()


## From idle to full in 6 s: the largest step beside that of the engine held at revolutions between.
func _sweep(p_engine: BlendedLoops) -> void:
	var steady: float = 0.0
	for rpm: float in [700.0, 930.0, 1200.0, 1500.0, 1800.0, 2200.0, 2600.0]:
		p_engine.set_value(rpm, 0.0)
		await _tree.create_timer(0.5).timeout
		var frames: PackedVector2Array = await _mix.record(_tree, 1.5)
		steady = maxf(steady, Figures.largest_step(MixCapture.mono(frames)))
	p_engine.set_value(700.0, 0.0)
	await _tree.create_timer(0.5).timeout
	_mix.clear()
	var swept: PackedVector2Array = []
	for frame: int in 360:
		p_engine.set_value(lerpf(700.0, 2600.0, frame / 359.0), 0.0)
		await _tree.process_frame
		swept.append_array(_mix.take())
	var most: float = Figures.largest_step(MixCapture.mono(swept))
	_report.at_most(
		"engine from idle to full",
		"largest step beside that at held revolutions",
		most / steady,
		"",
		1.0
	)


## From play() to the captured sample.
func measure_delay() -> void:
	_begin()
	var took: PackedFloat64Array = []
	for attempt: int in 12:
		await _tree.create_timer(0.8 + 0.013 * attempt).timeout
		await _tree.physics_frame
		_mix.clear()
		var begin: int = Time.get_ticks_usec()
		_voices.play(&"impact_concrete", Vector3(0.0, 0.0, -2.0), 0.0)
		# One that never comes is no fast one.
		var found: float = INF
		while found == INF and Time.get_ticks_usec() - begin < 1000000:
			await _tree.process_frame
			for frame: Vector2 in _mix.take():
				if frame.length() > 0.01:
					found = (Time.get_ticks_usec() - begin) / 1000.0
					break
		took.append(found)
	took.sort()
	_report.at_most(
		"impact to captured sound", "median", took[took.size() / 2], "ms", _GOAL_DELAY_MS
	)
	_report.add("impact to captured sound", "longest", took[took.size() - 1], "ms")
	_end()


## The same sound at a level that the limiter and the engine's own cap leave alone.
static func _steady(p_cue: SoundCue) -> SoundCue:
	var cue: SoundCue = SoundCue.new()
	cue.name = p_cue.name
	cue.takes = p_cue.takes
	cue.level_db = -6.0
	cue.range_m = 1000.0
	cue.length_s = p_cue.length_s
	return cue


func _begin() -> void:
	_mix.start()
	super()


func _end() -> void:
	_mix.stop()
	super()

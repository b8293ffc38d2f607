class_name ClientSound
extends ClientPart
## What a client hears: puts voices, impacts, people, doors, weather and captions together.
##
## Nothing of it is made where sound is off, as in clients without a window.

## What the option --sound can be.
const MODES: PackedStringArray = ["auto", "on", "off"]
## Impulse below which contacts of people count as steps, which are heard from their poses, N s.
const _STEP_IMPULSE: float = 80.0
## Level of the tick for news and of the menu, dB.
const _TICK_DB: float = -18.0

## The voices; null where sound is off.
var voices: SoundVoices = null
## Captions on the screen; null where sound is off.
var lines: CaptionLines = null

var _scene: ClientScene = null
var _settings: UserSettings = null
var _menu: SoundMenu = null
var _impacts: ImpactSounds = null
var _people: PeopleSounds = null
var _doors: DoorSounds = null
var _ambience: WorldAmbience = null
var _captions: SoundCaptions = SoundCaptions.new()
var _radio: AudioStreamPlayer = null
var _tick: AudioStreamPlayer = null
var _sky: WorldSky = null
## Which of [constant SoundMenu.SWITCHES] are on, whatever has been chosen.
var _are_on: Dictionary[StringName, bool] = {}


func _process(p_delta: float) -> void:
	if voices == null:
		return
	_impacts.advance(p_delta)
	_people.advance(_scene.people(), _scene.view.followed(), p_delta)
	_doors.advance(p_delta)
	var sky: SkyState = _sky.state if is_instance_valid(_sky) else null
	_ambience.advance(
		_scene.get_level().level_name, sky, voices.surroundings.room.enclosure, p_delta
	)


func open(p_context: ClientContext) -> String:
	super(p_context)
	var mode: String = context.options.text("sound")
	if mode == "off" or (mode == "auto" and ClientContext.is_headless()):
		return ""
	_scene = context.scene
	_settings = context.settings if context.settings != null else UserSettings.new()
	_menu = SoundMenu.new()
	context.menu.add_page("Sound", _menu, _menu.open, _menu.closed)
	context.notified.connect(func(_text: String) -> void: click_radio())
	voices = SoundVoices.new()
	voices.surroundings.set_absorption(_absorption_of)
	add_child(voices)
	_impacts = ImpactSounds.new(voices)
	_people = PeopleSounds.new(voices)
	_doors = DoorSounds.new(voices)
	_ambience = WorldAmbience.new()
	add_child(_ambience)
	lines = CaptionLines.new()
	add_child(lines)
	_radio = AudioStreamPlayer.new()
	_radio.bus = SoundBuses.VOICES
	add_child(_radio)
	_tick = AudioStreamPlayer.new()
	_tick.bus = SoundBuses.INTERFACE
	_tick.volume_db = _TICK_DB
	_tick.stream = SoundBank.find(&"radio_begin").pick()
	add_child(_tick)
	_scene.notified.connect(_on_notified)
	voices.captioned.connect(_on_captioned)
	_captions.shown.connect(lines.show_caption)
	_scene.entities.struck.connect(_on_struck)
	_scene.get_level().changed.connect(_on_level_changed)
	_apply_settings(context.options)
	return ""


## Hears with the ears in a headset, or at the camera of the window.
func advance(_delta_s: float) -> void:
	if voices == null or voices.listener == context.ears:
		return
	voices.listener = context.ears
	var binaural: BinauralRenderer = voices.renderer as BinauralRenderer
	if binaural != null:
		binaural.listener = context.ears


## Somebody speaks by radio: the key is pressed, then let go.
func click_radio(p_is_begin: bool = true) -> void:
	if _radio == null:
		return
	_radio.stream = SoundBank.find(&"radio_begin" if p_is_begin else &"radio_end").pick()
	_radio.play()


func report() -> Dictionary:
	if voices == null:
		return {"sound": {}}
	var sound: Dictionary = {
		"heard": voices.heard(),
		"peak": voices.peak,
		"begun": voices.begun,
		"refused": voices.refused,
		"stolen": voices.stolen,
	}
	return {"sound": sound}


func _apply_settings(p_options: Options) -> void:
	for bus: StringName in SoundBuses.SETTABLE:
		SoundBuses.set_volume(bus, _settings.volume(bus))
	if p_options.text("volume") != "":
		SoundBuses.set_volume(&"Master", p_options.text("volume").to_float() / 100.0)
	for name: StringName in SoundMenu.SWITCHES:
		_switch(name, _settings.is_sound_on(name))
	if p_options.is_on("captions"):
		_switch(&"captions", true)
	if _menu == null:
		return
	for bus: StringName in SoundBuses.SETTABLE:
		_menu.show_volume(bus, SoundBuses.volume(bus))
	_menu.volume_changed.connect(_on_volume_changed)
	_menu.volume_settled.connect(_settings.choose_volume)
	_menu.switched.connect(_on_switched)


## Switches something; the menu shows what has come of it.
func _switch(p_name: StringName, p_is_on: bool) -> void:
	_are_on[p_name] = p_is_on
	if p_name == &"limiter":
		SoundBuses.set_limited(p_is_on)
	elif p_name == &"binaural":
		_are_on[p_name] = _use_headphones(p_is_on)
	if _menu != null:
		_menu.show_switch(p_name, _are_on[p_name])


## Lets voices be heard by headphones, or by loudspeakers. Returns whether it is by headphones.
func _use_headphones(p_are_on: bool) -> bool:
	if p_are_on:
		var ears: BinauralRenderer = BinauralRenderer.new(SoundVoices.MAX_VOICES)
		voices.renderer = ears
		if ears.error == "":
			return true
		Log.warning("client", "no binaural sound: %s" % ears.error)
	if voices.renderer is not PannedRenderer:
		voices.renderer = PannedRenderer.new(SoundVoices.MAX_VOICES)
	return false


func _on_volume_changed(p_bus: StringName, p_share: float) -> void:
	SoundBuses.set_volume(p_bus, p_share)
	_tick.play()


func _on_switched(p_name: StringName, p_is_on: bool) -> void:
	_switch(p_name, p_is_on)
	_settings.choose_sound(p_name, _are_on[p_name])


## News on the screen are heard as well.
func _on_notified(_text: String) -> void:
	_tick.play()


func _on_captioned(p_text: String, p_place: Vector3, p_level_db: float) -> void:
	if _are_on.get(&"captions", false):
		_captions.take(p_text, p_place, p_level_db, _scene.view.camera.global_transform)


func _on_level_changed(p_level: Level, _differs: bool) -> void:
	voices.stop_all()
	_doors.take_level(p_level)
	_sky = null
	for node: Node in p_level.find_children("*", "Node3D", true, false):
		if node is WorldSky:
			_sky = node as WorldSky
			return


func _on_struck(p_impact: Impact) -> void:
	var is_person: bool = p_impact.entity < EntityTable.FIRST_OTHER
	if is_person and p_impact.other == Impact.NO_ENTITY and p_impact.impulse < _STEP_IMPULSE:
		return
	var first: StringName = StringName(ContactMaterial.numbered(p_impact.material).sound)
	var second: StringName = StringName(ContactMaterial.numbered(p_impact.other_material).sound)
	var pair: int = (p_impact.entity << 16) | p_impact.other
	if p_impact.is_scrape():
		# An impulse within a tick is a force.
		var force: float = p_impact.impulse * Engine.physics_ticks_per_second
		_impacts.set_scrape(pair, first, second, p_impact.place, p_impact.slip, force)
	else:
		_impacts.play_impact(first, second, p_impact.place, p_impact.impulse, pair)


static func _absorption_of(p_collider: Object, p_place: Vector3) -> float:
	return ContactMaterial.at(p_collider, p_place).absorption

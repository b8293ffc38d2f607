class_name SoundVoices
extends Node3D
## All sounds of the world at one client, within a budget of voices.
##
## What is loudest at the listener is heard; when voices are few the lowest ends. Who is behind a
## wall is muffled, rooms reverberate, what moves changes its pitch. Whatever makes sound finds it
## by [method find], and makes none where there is none: servers have no such node.

## A sound whose cue has a caption has begun: what it is, where (m), and how loud (dB).
signal captioned(p_text: String, p_place: Vector3, p_level_db: float)

## The group by which [method find] finds it.
const GROUP: StringName = &"sound_voices"
## Default of the number of voices at once.
const MAX_VOICES: int = 48
## Level at the listener below which a sound is not begun, dB.
const SILENT_DB: float = -60.0
## Speed of sound, m/s.
const SOUND_SPEED: float = 343.0
## Time within which sounds of one pair are one sound, s.
const MERGE_S: float = 0.05
## Attenuation by a wall besides that of the high frequencies, dB.
const WALL_DB: float = 8.0
## Attenuation by air beyond 100 m, dB per 100 m.
const AIR_DB: float = 0.6
## Rays a frame that look for walls.
const _WALL_RAYS: int = 2
## Frames after which a voice with constant gain and pitch is evaluated again, and the share of its
## distance whose change brings that forward.
const _STILL_FRAMES: int = 8
const _MOVING_FRAMES: int = 2
const _MOVING_SHARE: float = 0.01
## Time constant of the speed towards the listener, s, and speed that counts as a teleport, m/s.
const _DOPPLER_S: float = 0.06
const _MAX_RECESSION: float = 120.0
## Pairs that are remembered before old ones are forgotten.
const _MAX_MERGED: int = 256

## What makes voices heard. Set another one to change how.
var renderer: SpatialRenderer = null:
	set = set_renderer
## Voices at once, of this client.
var max_voices: int = MAX_VOICES
## Who listens; null: the camera of the viewport.
var listener: Node3D = null
## What is between listener and sources, and how rooms reverberate.
var surroundings: SoundSurroundings = SoundSurroundings.new()
## What has been begun, refused and ended for others since the start.
var begun: int = 0
var refused: int = 0
var stolen: int = 0
## Most voices that have been heard at once.
var peak: int = 0

var _voices: Array[SoundVoice] = []
var _waiting: WaitingSounds = WaitingSounds.new()
var _merged: Dictionary[int, SoundVoice] = {}
var _merged_s: Dictionary[int, float] = {}
var _clock_s: float = 0.0
var _next_wall: int = 0
## What the lowest voice counts, as found in this frame, dB.
var _lowest_db: float = -INF
var _ear: Vector3 = Vector3.ZERO


func _init() -> void:
	add_to_group(GROUP)


func _ready() -> void:
	SoundBuses.make()
	if renderer == null:
		renderer = PannedRenderer.new(MAX_VOICES)


func _process(p_delta: float) -> void:
	_clock_s += p_delta
	_lowest_db = -INF
	_ear = ear()
	for voice: SoundVoice in _waiting.take_due(_clock_s):
		_begin(voice)
	_look_around()
	for voice: SoundVoice in _voices:
		_advance(voice, p_delta)
	_drop_ended()


func _exit_tree() -> void:
	stop_all()


## The one in the tree of a node; null where there is none.
static func find(p_node: Node) -> SoundVoices:
	return p_node.get_tree().get_first_node_in_group(GROUP) as SoundVoices


## Takes another renderer; what sounds now goes on in it from its beginning.
func set_renderer(p_renderer: SpatialRenderer) -> void:
	if renderer != null:
		for voice: SoundVoice in _voices:
			voice.slot = -1
		renderer.queue_free()
	renderer = p_renderer
	add_child(p_renderer)


## Where the ears are, m.
func ear() -> Vector3:
	if is_instance_valid(listener) and listener.is_inside_tree():
		return listener.global_position
	var camera: Camera3D = get_viewport().get_camera_3d()
	return camera.global_position if camera != null else Vector3.ZERO


## Plays a sound at a position (m), louder by a gain (dB), after a delay (s). Returns its voice, or
## null where it is refused: unknown, too quiet, or below all that is heard. The listener's present
## position decides whether a sound that waits is too quiet, or ranks below the others that wait.
func play(
	p_name: StringName,
	p_place: Vector3,
	p_gain_db: float = 0.0,
	p_pitch: float = 1.0,
	p_delay_s: float = 0.0
) -> SoundVoice:
	var cue: SoundCue = SoundBank.find(p_name)
	if cue == null or not (p_place.is_finite() and is_finite(p_gain_db) and is_finite(p_pitch)):
		return null
	var voice: SoundVoice = SoundVoice.new()
	voice.cue = cue
	voice.place = p_place
	voice.gain_db = p_gain_db
	voice.pitch = p_pitch * (1.0 + randf_range(-cue.pitch_spread, cue.pitch_spread))
	var is_kept: bool = _keep(voice, p_delay_s) if p_delay_s > 0.0 else _begin(voice)
	return voice if is_kept else null


## Plays a sound as [method play] does, but once for each pair in [constant MERGE_S]: the loudest
## one counts. A pair is any number that stands for two things that touch.
func play_merged(
	p_pair: int, p_name: StringName, p_place: Vector3, p_gain_db: float, p_pitch: float = 1.0
) -> SoundVoice:
	if _merged.has(p_pair) and _clock_s - _merged_s[p_pair] < MERGE_S:
		var before: SoundVoice = _merged[p_pair]
		if not before.is_over and p_gain_db > before.gain_db:
			before.gain_db = p_gain_db
		return before
	var voice: SoundVoice = play(p_name, p_place, p_gain_db, p_pitch)
	if voice != null:
		_merged[p_pair] = voice
		_merged_s[p_pair] = _clock_s
		if _merged.size() > _MAX_MERGED:
			_forget_merged()
	return voice


## Starts a loop that follows a node, silent until its gain is set; null where there is no such
## sound. It is kept while it is too quiet to be heard.
func start_loop(
	p_name: StringName, p_follow: Node3D, p_offset: Vector3 = Vector3.ZERO
) -> SoundVoice:
	var cue: SoundCue = SoundBank.find(p_name)
	if cue == null:
		return null
	var voice: SoundVoice = SoundVoice.new()
	voice.cue = cue
	voice.follow = p_follow
	voice.offset = p_offset
	voice.gain_db = -INF
	voice.wait_frames = _voices.size() % _STILL_FRAMES
	voice.position()
	voice.distance = ear().distance_to(voice.place)
	_voices.append(voice)
	return voice


## Ends all at once.
func stop_all() -> void:
	for voice: SoundVoice in _voices:
		voice.is_over = true
	_drop_ended()
	_waiting.clear()
	_merged.clear()


## How many voices are heard.
func heard() -> int:
	return renderer.sounding() if renderer != null else 0


## Seconds that sound needs from a position (m) to the listener.
func travel_s(p_place: Vector3) -> float:
	return ear().distance_to(p_place) / SOUND_SPEED


## Lets a voice wait, s: what is too quiet even without a wall need not.
func _keep(p_voice: SoundVoice, p_delay_s: float) -> bool:
	p_voice.distance = ear().distance_to(p_voice.place)
	_weigh(p_voice)
	if p_voice.level_db < SILENT_DB:
		refused += 1
		return false
	var dropped: SoundVoice = _waiting.add(p_voice, _clock_s + p_delay_s)
	refused += 1 if dropped != null else 0
	return dropped != p_voice


func _begin(p_voice: SoundVoice) -> bool:
	_ear = ear()
	p_voice.distance = _ear.distance_to(p_voice.position())
	_weigh(p_voice)
	if p_voice.level_db < SILENT_DB or not _make_room(p_voice):
		refused += 1
		return false
	var space: PhysicsDirectSpaceState3D = get_world_3d().direct_space_state
	p_voice.is_blocked = surroundings.is_walled(space, _ear, p_voice.place)
	_weigh(p_voice)
	if p_voice.level_db < SILENT_DB:
		refused += 1
		return false
	if not p_voice.cue.is_loop():
		p_voice.end_s = _clock_s + p_voice.cue.length_s / maxf(p_voice.pitch, 0.1) + 0.1
	p_voice.wait_frames = _voices.size() % _STILL_FRAMES
	_voices.append(p_voice)
	return _sound(p_voice)


## Gives a voice to the renderer.
func _sound(p_voice: SoundVoice) -> bool:
	var space: PhysicsDirectSpaceState3D = get_world_3d().direct_space_state
	if p_voice.cue.is_loop():
		# Others have been looked at before they were let in.
		p_voice.is_blocked = surroundings.is_walled(space, _ear, p_voice.place)
	p_voice.is_in_room = surroundings.is_in_other_room(space, p_voice.place)
	var bus: StringName = _bus_of(p_voice)
	p_voice.slot = renderer.begin(p_voice.cue.pick(), bus, 0.0)
	if p_voice.slot < 0:
		p_voice.is_over = p_voice.follow == null
		return false
	begun += 1
	peak = maxi(peak, renderer.sounding())
	var level: float = p_voice.level_db
	if p_voice.cue.is_loop():
		# It comes in without a click; the next frame sets its level.
		p_voice.level_db = SILENT_DB
		p_voice.wait_frames = 0
	_render(p_voice)
	p_voice.level_db = level
	renderer.start(p_voice.slot)
	if p_voice.cue.caption != "":
		captioned.emit(p_voice.cue.caption, p_voice.place, p_voice.level_db)
	return true


## Makes sure that one more voice can sound: the lowest ends where it counts less.
func _make_room(p_voice: SoundVoice) -> bool:
	if renderer.sounding() < mini(max_voices, renderer.capacity):
		return true
	# Within a frame the lowest only rises: what is below it needs no search.
	if p_voice.rank_db <= _lowest_db:
		return false
	var lowest: SoundVoice = null
	var least: float = INF
	for voice: SoundVoice in _voices:
		if voice.rank_db < least and voice.slot >= 0:
			lowest = voice
			least = voice.rank_db
	if lowest == null:
		return false
	_lowest_db = least
	if least >= p_voice.rank_db:
		return false
	stolen += 1
	renderer.release(lowest.slot)
	lowest.slot = -1
	# A loop is heard again when there is room.
	lowest.is_over = lowest.end_s < INF
	return true


func _advance(p_voice: SoundVoice, p_delta: float) -> void:
	if p_voice.end_s <= _clock_s:
		p_voice.is_over = true
	if p_voice.is_abandoned():
		p_voice.is_over = true
	if p_voice.is_over:
		return
	p_voice.since_s += p_delta
	p_voice.wait_frames -= 1
	var is_loop: bool = p_voice.end_s == INF
	if p_voice.wait_frames > 0 and not (is_loop and p_voice.has_changed()):
		return
	var before: float = p_voice.distance
	var place: Vector3 = p_voice.place
	p_voice.distance = _ear.distance_to(p_voice.position())
	var moved: float = absf(p_voice.distance - before) + place.distance_to(p_voice.place)
	var is_moving: bool = moved > _MOVING_SHARE * p_voice.distance
	p_voice.wait_frames = _MOVING_FRAMES if is_moving else _STILL_FRAMES
	if is_loop and p_voice.since_s > 0.0:
		_follow_speed(p_voice, (p_voice.distance - before) / p_voice.since_s)
	p_voice.since_s = 0.0
	_weigh(p_voice)
	if p_voice.slot >= 0:
		if is_loop and p_voice.level_db < SILENT_DB - 3.0:
			renderer.release(p_voice.slot)
			p_voice.slot = -1
		else:
			_render(p_voice)
	elif p_voice.level_db > SILENT_DB and _make_room(p_voice):
		_sound(p_voice)


## Follows how fast a voice goes away, m/s: a teleport is none.
func _follow_speed(p_voice: SoundVoice, p_speed: float) -> void:
	if absf(p_speed) < _MAX_RECESSION:
		var share: float = 1.0 - exp(-p_voice.since_s / _DOPPLER_S)
		p_voice.recession = lerpf(p_voice.recession, p_speed, share)


## Works out how loud a voice is at the listener.
func _weigh(p_voice: SoundVoice) -> void:
	var level: float = p_voice.cue.level_at(p_voice.distance) + p_voice.gain_db
	if p_voice.is_blocked:
		level -= WALL_DB
	p_voice.level_db = level - maxf(p_voice.distance - 100.0, 0.0) * AIR_DB * 0.01
	p_voice.rank_db = p_voice.level_db + p_voice.priority_db + p_voice.cue.priority_db


func _render(p_voice: SoundVoice) -> void:
	var doppler: float = SOUND_SPEED / (SOUND_SPEED + p_voice.recession)
	renderer.update(
		p_voice.slot,
		p_voice.place,
		maxf(p_voice.level_db, -80.0),
		clampf(p_voice.pitch * doppler, 0.1, 4.0),
		_bus_of(p_voice)
	)


func _bus_of(p_voice: SoundVoice) -> StringName:
	if p_voice.is_blocked:
		return SoundBuses.MUFFLED
	if p_voice.is_in_room and not surroundings.room.is_room():
		return SoundBuses.SOURCE_ROOM
	return SoundBuses.ROOM


## A few rays a frame: how the room is, and who is behind a wall.
func _look_around() -> void:
	var space: PhysicsDirectSpaceState3D = get_world_3d().direct_space_state
	surroundings.advance(space, _ear)
	for _ray: int in mini(_WALL_RAYS, _voices.size()):
		_next_wall = (_next_wall + 1) % _voices.size()
		var voice: SoundVoice = _voices[_next_wall]
		if voice.slot >= 0:
			voice.is_blocked = surroundings.is_walled(space, _ear, voice.position())


func _drop_ended() -> void:
	_lowest_db = -INF
	for index: int in range(_voices.size() - 1, -1, -1):
		var voice: SoundVoice = _voices[index]
		if voice.is_over:
			if voice.slot >= 0:
				renderer.release(voice.slot)
				voice.slot = -1
			_voices.remove_at(index)


func _forget_merged() -> void:
	for pair: int in _merged.keys():
		if _clock_s - _merged_s[pair] > MERGE_S:
			_merged.erase(pair)
			_merged_s.erase(pair)

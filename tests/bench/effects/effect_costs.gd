extends SceneTree
## What effects cost in a window, a JSON object a line; for bench_effects.py.
## Options: --frames=12 (of each measurement), --part=making,shot,triangles,tiers,counts,colours.

const Stage: GDScript = preload("effect_stage.gd")
const COUNTS: PackedInt32Array = [1000, 5000, 10000, 20000]
const TIERS: PackedStringArray = ["low", "medium", "high"]
## So far away tables of numbers are made: tiny particles, so that numbers count and not their area.
const FAR_M: float = 90.0
## The least that an effect does: particles that fly apart, fall, and fade.
const PLAIN: String = """shader_type particles;
// @topology %s
// @blend add
// @life 2
// @weight 1
// @size 0.2
// @speed 2 9
void start() {
	uint s = RANDOM_SEED + NUMBER;
	TRANSFORM = at(EMISSION_TRANSFORM[3].xyz, 0.2);
	VELOCITY = start_speed(s) * rnd_sphere(s);
	COLOR = vec4(1.0);
}
void process() {
	VELOCITY += gravity() * DELTA;
	COLOR.a -= DELTA;
}
"""
const _DEFAULTS: Dictionary = {"frames": 12, "part": "making,shot,triangles,tiers,counts,colours"}

var _arguments: BenchArguments = null
var _stage: Stage = null
var _empty_ms: float = 0.0


func _initialize() -> void:
	_arguments = BenchArguments.parse(OS.get_cmdline_user_args(), _DEFAULTS)
	_run.call_deferred()


func _run() -> void:
	_stage = Stage.new(self)
	Quality.use(Quality.find("high"), root)
	root.scaling_3d_scale = 1.0
	_tell({"what": "renderer", "name": RenderingServer.get_current_rendering_method()})
	await _stage.frames(5)
	await _warm_up()
	var parts: PackedStringArray = (_arguments.value("part") as String).split(",")
	if parts.has("making"):
		_measure_making()
	if parts.has("shot"):
		await _measure_shot()
	_stage.use_plain_sky()
	_empty_ms = await _stage.frame_ms(_arguments.value("frames") * 2)
	_tell({"what": "empty", "ms": _empty_ms})
	if parts.has("triangles"):
		await _measure_triangles()
	if parts.has("tiers"):
		await _measure_tiers()
	if parts.has("counts"):
		await _measure_counts()
	if parts.has("colours"):
		await _measure_colours()
	quit()


func _warm_up() -> void:
	var warm_up: EffectWarmUp = EffectWarmUp.new()
	_stage.root.add_child(warm_up)
	await warm_up.finished


func _tell(p_row: Dictionary) -> void:
	print(JSON.stringify(p_row))


func _measure_making() -> void:
	for effect: String in EffectLibrary.shared().names():
		var before: int = Time.get_ticks_usec()
		var shown: LayeredEffect = LayeredEffect.make(effect)
		_stage.root.add_child(shown)
		_tell({"what": "making", "effect": effect, "ms": (Time.get_ticks_usec() - before) / 1000.0})
		shown.free()


## The first shot of a gun and its hit, with all that flies up.
func _measure_shot() -> void:
	var player: EffectPlayer = EffectPlayer.of(_stage.root)
	var names: PackedStringArray = ["muzzle_flash", "muzzle_smoke", "muzzle_dust", "impact"]
	names.append_array(["impact_metal", "sparks", "debris", "explosion"])
	for effect: String in names:
		player.prepare(effect, 2)
	while not player.is_prepared():
		await process_frame
	# As the flash of a gun does: what it lights is compiled anew for it.
	var lamp: OmniLight3D = OmniLight3D.new()
	lamp.position = Vector3(0.0, 2.0, -28.0)
	lamp.visible = false
	_stage.root.add_child(lamp)
	await _stage.frames(10)
	var times: PackedFloat64Array = []
	var last: int = Time.get_ticks_usec()
	for frame: int in 60:
		if frame == 30:
			lamp.visible = true
			for effect: String in names:
				player.play(effect, Transform3D(Basis.IDENTITY, Vector3(0.0, 1.0, -30.0)))
		await process_frame
		var now: int = Time.get_ticks_usec()
		times.append((now - last) / 1000.0)
		last = now
	var after: PackedFloat64Array = times.slice(30)
	var sorted: PackedFloat64Array = after.duplicate()
	sorted.sort()
	var first: float = 0.0
	for frame: int in 4:
		first = maxf(first, after[frame])
	_tell({"what": "shot", "first_ms": first, "median_ms": sorted[sorted.size() / 2]})
	await _stage.frames(20)
	lamp.free()
	player.free()


func _measure_triangles() -> void:
	for topology: String in ["triangle", "quad"]:
		var plain: float = await _measure_text(PLAIN % topology, 20000, FAR_M)
		_tell({"what": "simple", "name": topology, "ms": plain})
	var fountain: String = EffectLibrary.shared().text_of("fountain")
	var ms: float = await _measure_text(fountain, 20000, FAR_M)
	_tell({"what": "simple", "name": "fountain", "ms": ms})


func _measure_tiers() -> void:
	_stage.look(8.0)
	for effect: String in EffectLibrary.shared().names():
		_empty_ms = await _stage.frame_ms(_arguments.value("frames"))
		for tier: String in TIERS:
			# Not what else a tier changes: the empty scene would cost something else.
			EffectBudget.share = Quality.find(tier).particles
			EffectBudget.screens = Quality.find(tier).overdraw
			var shown: LayeredEffect = LayeredEffect.make(effect)
			_stage.root.add_child(shown)
			for part: ParticleEffect in shown.parts:
				part.one_shot = false
				part.explosiveness = 0.0
				part.preprocess = minf(part.lifetime, 6.0)
				part.emitting = true
			EffectBudget.spread(shown.parts, _stage.camera)
			var ms: float = await _stage.frame_ms(_arguments.value("frames"))
			var count: float = 0.0
			for part: ParticleEffect in shown.parts:
				count += part.amount * part.amount_ratio
			var row: Dictionary = {"what": "tier", "effect": effect, "tier": tier}
			row.merge({"particles": roundi(count), "ms": ms - _empty_ms})
			_tell(row)
			shown.free()
	EffectBudget.share = QualityTier.high().particles
	EffectBudget.screens = QualityTier.high().overdraw


func _measure_counts() -> void:
	for effect: String in EffectLibrary.shared().names():
		for count: int in COUNTS:
			if effect == "tracer":
				continue
			var ms: float = await _measure_text(
				EffectLibrary.shared().text_of(effect), count, FAR_M
			)
			_tell({"what": "count", "effect": effect, "particles": count, "ms": ms})


## Processor time above the empty scene of a text with another count, that goes on, ms.
func _measure_text(p_text: String, p_count: int, p_away: float) -> float:
	_stage.look(p_away)
	_empty_ms = await _stage.frame_ms(_arguments.value("frames"))
	var file: EffectFile = EffectFile.read(p_text)
	file.settings.count = p_count
	file.settings.once = false
	file.settings.burst = 0.0
	file.settings.preprocess = minf(file.settings.life, 2.0)
	file.settings.fade = [0.0, 0.0]
	var shown: ParticleEffect = ParticleEffect.new()
	shown.show_file(file)
	_stage.root.add_child(shown)
	var ms: float = await _stage.frame_ms(_arguments.value("frames"))
	shown.free()
	return ms - _empty_ms


## The mean colour of what an effect changes in the picture, at a fixed moment with fixed chance.
func _measure_colours() -> void:
	_stage.use_world_sky()
	_stage.look(9.0)
	await _stage.frames(4)
	var before: Image = await _stage.picture()
	for effect: String in EffectLibrary.shared().names():
		if effect == "tracer":
			continue
		var shown: LayeredEffect = LayeredEffect.make(effect)
		_stage.root.add_child(shown)
		for part: ParticleEffect in shown.parts:
			part.use_fixed_seed = true
			part.seed = 7
			part.speed_scale = 0.0
			part.preprocess = part.lifetime * (0.4 if part.one_shot else 1.0)
			part.restart(true)
			part.emitting = true
		await _stage.frames(4)
		var row: Dictionary = {"what": "colour", "effect": effect}
		row.merge(_difference(before, await _stage.picture()))
		_tell(row)
		shown.free()


## Mean colour, 0 to 255, of the pixels that differ, and their number.
static func _difference(p_before: Image, p_after: Image) -> Dictionary:
	var sum: Vector3 = Vector3.ZERO
	var count: int = 0
	var old: PackedByteArray = p_before.get_data()
	var new: PackedByteArray = p_after.get_data()
	for at: int in range(0, new.size(), 3):
		var change: int = 0
		for channel: int in 3:
			change = maxi(change, absi(new[at + channel] - old[at + channel]))
		if change > 6:
			sum += Vector3(new[at], new[at + 1], new[at + 2])
			count += 1
	var mean: Vector3 = sum / maxi(count, 1)
	return {"pixels": count, "mean": [mean.x, mean.y, mean.z]}

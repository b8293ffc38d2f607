extends TestCase
## All effects together don't fill the picture too often, and quality says how many particles there
## are.

var _stage: Node3D = null
var _camera: Camera3D = null


func before_each() -> void:
	_stage = Node3D.new()
	_camera = Camera3D.new()
	_stage.add_child(_camera)
	add_child(_stage)


func after_each() -> void:
	Quality.use(QualityTier.high(), get_tree().root)
	_stage.free()


func test_one_effect_has_all_its_particles() -> void:
	var shown: Array[ParticleEffect] = _show("smoke", 1, 30.0)
	EffectBudget.spread(shown, _camera)
	almost_equal(shown[0].amount_ratio, 1.0, 0.05)


func test_many_get_fewer() -> void:
	var shown: Array[ParticleEffect] = _show("smoke", 20, 12.0)
	EffectBudget.spread(shown, _camera)
	var total: float = 0.0
	for one: ParticleEffect in shown:
		total += one.screens(_camera) * one.amount_ratio
		is_true(one.amount_ratio < 0.6 and one.amount_ratio >= EffectBudget.MIN_ROOM - 0.01)
	is_true(total < EffectBudget.screens * 1.1 or shown[0].room <= EffectBudget.MIN_ROOM + 0.01)
	EffectBudget.spread(shown.slice(0, 1), _camera)
	is_true(shown[0].amount_ratio > 0.6, "there is room again: %.2f" % shown[0].amount_ratio)


func test_far_ones_get_fewer() -> void:
	var near: ParticleEffect = _show("smoke", 1, 10.0)[0]
	var far: ParticleEffect = _show("smoke", 1, 300.0)[0]
	EffectBudget.spread([near, far], _camera)
	is_true(far.room < near.room)


func test_quality_says_how_many() -> void:
	for tier: QualityTier in [QualityTier.low(), QualityTier.medium(), QualityTier.high()]:
		Quality.use(tier, get_tree().root)
		var shown: Array[ParticleEffect] = _show("fountain", 1, 30.0)
		EffectBudget.spread(shown, _camera)
		almost_equal(shown[0].amount_ratio, tier.particles, 0.05, tier.name)


func test_a_burst_keeps_some_particles() -> void:
	Quality.use(QualityTier.low(), get_tree().root)
	var flash: ParticleEffect = _show("muzzle_flash", 1, 5.0)[0]
	flash.room = 0.1
	is_true(flash.amount * flash.amount_ratio >= ParticleEffect.MIN_BURST - 0.01)


func _show(p_effect: String, p_count: int, p_away: float) -> Array[ParticleEffect]:
	var found: Array[ParticleEffect] = []
	for _index: int in p_count:
		var shown: LayeredEffect = LayeredEffect.make(p_effect)
		shown.position.z = -p_away
		_stage.add_child(shown)
		found.append(shown.parts[0])
	return found

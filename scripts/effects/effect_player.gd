class_name EffectPlayer
extends Node3D
## Plays effects wherever they are needed, within a budget: [method play].
##
## There is one for each world ([method of]); what plays there outlives who has asked for it.

## Group of the nodes below which a player may be: a level, whose end is the end of its effects.
const STAGES: StringName = &"effect_stages"
## Period of spreading the budget anew, s.
const BUDGET_S: float = 0.25
## Most of one effect at once.
const MAX_OF_ONE: int = 16
## Number of instances of an effect that was not prepared.
const UNPREPARED: int = 3
## Name of the input that takes the scale of what is played, 1 as made.
const SIZE: StringName = &"scale"
const _NAME: StringName = &"EffectPlayer"

## How many were played since the beginning.
var played: int = 0

var _pools: Dictionary[String, EffectPool] = {}
## How many of each effect are still to be made.
var _wanted: Dictionary[String, int] = {}
var _now: float = 0.0
var _until_budget: float = 0.0


## The player of the world that a node is in: below the level that the node is in, else below the
## topmost node in space. The node must be in the tree.
static func of(p_node: Node) -> EffectPlayer:
	var stage: Node = null
	var node: Node = p_node
	while node != null:
		if node is Node3D:
			stage = node
			if node.is_in_group(STAGES):
				break
		node = node.get_parent()
	if stage == null:
		return null
	if stage.has_meta(_NAME) and is_instance_valid(stage.get_meta(_NAME)):
		return stage.get_meta(_NAME) as EffectPlayer
	var found: EffectPlayer = EffectPlayer.new()
	found.name = _NAME
	stage.set_meta(_NAME, found)
	# A parent that is just being set up takes no children at once.
	if stage.is_node_ready():
		stage.add_child(found)
	else:
		stage.add_child.call_deferred(found)
	return found


func _process(p_delta: float) -> void:
	_now += p_delta
	_make_one()
	for effect: String in _pools:
		_pools[effect].advance(_now)
	_until_budget -= p_delta
	if _until_budget <= 0.0:
		_until_budget = BUDGET_S
		_spread_budget()


## Makes so many of an effect beforehand, one in each of the next frames.
func prepare(p_effect: String, p_count: int) -> void:
	var count: int = mini(p_count, MAX_OF_ONE)
	_wanted[p_effect] = maxi(_wanted.get(p_effect, 0), count)


## Whether everything that was prepared is there.
func is_prepared() -> bool:
	return _wanted.is_empty()


## Plays an effect once at a transform in the world, with a scale (1 as made) and values of its
## inputs. Returns whether it is seen: it is not where there is no such effect, or where it is too
## far away.
func play(
	p_effect: String,
	p_at: Transform3D,
	p_size: float = 1.0,
	p_inputs: Dictionary[StringName, Variant] = {}
) -> bool:
	if not p_at.is_finite() or not is_finite(p_size) or not is_inside_tree():
		return false
	var pool: EffectPool = _pool_of(p_effect)
	if pool == null:
		return false
	while pool.size() < UNPREPARED and pool.size() <= pool.playing(_now):
		pool.grow()
	var farthest: float = pool.farthest()
	var camera: Camera3D = get_viewport().get_camera_3d()
	if farthest > 0.0 and camera != null:
		if camera.global_position.distance_to(p_at.origin) > farthest:
			return false
	var inputs: Dictionary[StringName, Variant] = p_inputs.duplicate()
	inputs[SIZE] = clampf(p_size, 0.01, 100.0)
	pool.play(p_at, inputs, _now)
	played += 1
	return true


## How many of an effect play now.
func playing(p_effect: String) -> int:
	return _pools[p_effect].playing(_now) if _pools.has(p_effect) else 0


func _pool_of(p_effect: String) -> EffectPool:
	if not _pools.has(p_effect):
		if not EffectLibrary.shared().has(p_effect):
			Log.limited("effects", p_effect.left(40), "no effect '%s'" % p_effect.left(40))
			return null
		_pools[p_effect] = EffectPool.new(self, p_effect)
	return _pools[p_effect]


## One in a frame: making all in one would be seen.
func _make_one() -> void:
	for effect: String in _wanted:
		var pool: EffectPool = _pool_of(effect)
		if pool == null or pool.size() >= _wanted[effect]:
			_wanted.erase(effect)
		else:
			pool.grow()
		return


func _spread_budget() -> void:
	var camera: Camera3D = get_viewport().get_camera_3d()
	if camera == null:
		return
	var shown: Array[ParticleEffect] = []
	var world: World3D = get_world_3d()
	for node: Node in get_tree().get_nodes_in_group(ParticleEffect.GROUP):
		var effect: ParticleEffect = node
		if effect.is_visible_in_tree() and effect.get_world_3d() == world:
			shown.append(effect)
	EffectBudget.spread(shown, camera)

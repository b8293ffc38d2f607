class_name EffectPool
extends RefCounted
## Some of one effect that plays once, wherever it is needed: the oldest gives way.

## Name of the effect.
var effect: String = ""

var _parent: Node3D = null
var _ready: Array[LayeredEffect] = []
## When each will be over, s.
var _ends: PackedFloat64Array = []
var _plays: int = 0


## One of an effect, below a node.
func _init(p_parent: Node3D, p_effect: String) -> void:
	_parent = p_parent
	effect = p_effect


## Makes one more.
func grow() -> void:
	var made: LayeredEffect = LayeredEffect.make(effect, false)
	made.top_level = true
	made.visible = false
	_parent.add_child(made)
	_ready.append(made)
	_ends.append(0.0)


## How many there are.
func size() -> int:
	return _ready.size()


## How many play now, at a time, s.
func playing(p_now: float) -> int:
	var count: int = 0
	for end: float in _ends:
		count += 1 if end > p_now else 0
	return count


## Farthest from which one is seen, m; 0 for any distance.
func farthest() -> float:
	return _ready[0].farthest() if not _ready.is_empty() else 0.0


## Plays one at a position of the world, at a time, s.
func play(p_at: Transform3D, p_inputs: Dictionary[StringName, Variant], p_now: float) -> void:
	if _ready.is_empty():
		return
	var chosen: int = _oldest()
	var played: LayeredEffect = _ready[chosen]
	played.global_transform = p_at
	for input: StringName in p_inputs:
		played.set_input(input, p_inputs[input])
	played.visible = true
	played.play()
	# Of those that begin in one frame the first counts as the oldest.
	_plays += 1
	_ends[chosen] = p_now + played.longest_life() + (_plays % 1000) * 1e-6


## Hides what is over, so that it costs nothing, at a time, s.
func advance(p_now: float) -> void:
	for index: int in _ready.size():
		if _ready[index].visible and _ends[index] <= p_now:
			_ready[index].visible = false


## The one that is over, or will be first.
func _oldest() -> int:
	var oldest: int = 0
	for index: int in range(1, _ends.size()):
		if _ends[index] < _ends[oldest]:
			oldest = index
	return oldest

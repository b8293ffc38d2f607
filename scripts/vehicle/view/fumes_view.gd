class_name FumesView
extends RefCounted
## Diesel fumes from the exhausts: more and faster with the revolutions, darker with the load.

## How long a sudden load smokes before the turbocharger has caught up, s.
const _LAG_S: float = 0.9

## Fumes as a share of the most, and their darkness, 0 to 1.
var amount: float = 0.0
var darkness: float = 0.0

var _puffs: Array[LayeredEffect] = []
var _load: float = 0.0


## Adds a stream of fumes at an exhaust.
func add(p_exhaust: Node3D) -> void:
	var puffs: LayeredEffect = LayeredEffect.make("diesel_fumes", false)
	p_exhaust.add_child(puffs)
	_puffs.append(puffs)


## Follows the engine.
func advance(p_state: VehicleState, p_most_rpm: float, p_delta: float) -> void:
	var speed: float = clampf(p_state.rpm / p_most_rpm, 0.0, 1.0)
	# Part of the load that is so new that the engine lacks air for it.
	_load = lerpf(_load, p_state.load, 1.0 - exp(-p_delta / _LAG_S))
	var sudden: float = maxf(p_state.load - _load, 0.0)
	amount = 0.0
	if p_state.engine_on:
		amount = clampf(0.12 + 0.45 * speed + 0.55 * sudden + 0.2 * p_state.load, 0.0, 1.0)
	darkness = clampf(0.15 + 0.35 * p_state.load + 1.1 * sudden, 0.0, 1.0)
	_show(speed)


## Nobody sees them.
func stop() -> void:
	amount = 0.0
	_show(0.0)


func _show(p_speed: float) -> void:
	for puffs: LayeredEffect in _puffs:
		puffs.emitting = amount > 0.02
		if puffs.emitting:
			puffs.share = maxf(amount, 0.05)
			puffs.set_input(&"revs", p_speed)
			puffs.set_input(&"load", darkness)

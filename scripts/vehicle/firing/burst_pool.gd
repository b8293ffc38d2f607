class_name BurstPool
extends RefCounted
## Some particle effects of one kind that play once, wherever they are needed: the oldest gives way.

var _bursts: Array[GPUParticles3D] = []
var _next: int = 0


## Makes so many of a scene's effect below a node.
func _init(p_parent: Node3D, p_scene: PackedScene, p_count: int) -> void:
	for _index: int in p_count:
		var burst: GPUParticles3D = p_scene.instantiate()
		burst.top_level = true
		p_parent.add_child(burst)
		_bursts.append(burst)


## Plays one at a place of the world, so large (1 as made). A colour replaces its own.
func play(p_at: Transform3D, p_size: float = 1.0, p_colour: Color = Color.TRANSPARENT) -> void:
	var burst: GPUParticles3D = _bursts[_next]
	_next = (_next + 1) % _bursts.size()
	burst.global_transform = p_at
	burst.amount_ratio = clampf(Quality.tier.weather, 0.3, 1.0)
	var motion: ParticleProcessMaterial = burst.process_material as ParticleProcessMaterial
	if not burst.has_meta(&"scale"):
		burst.set_meta(&"scale", Vector2(motion.scale_min, motion.scale_max))
		burst.set_meta(&"speed", Vector2(motion.initial_velocity_min, motion.initial_velocity_max))
	var scale: Vector2 = burst.get_meta(&"scale")
	var speed: Vector2 = burst.get_meta(&"speed")
	motion.scale_min = scale.x * p_size
	motion.scale_max = scale.y * p_size
	motion.initial_velocity_min = speed.x * sqrt(p_size)
	motion.initial_velocity_max = speed.y * sqrt(p_size)
	if p_colour != Color.TRANSPARENT:
		motion.color = p_colour
	burst.restart()

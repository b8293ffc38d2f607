@tool
class_name CpuStandIn
extends CPUParticles3D
## As many particles as an effect has, of its life, size and looks, moved by the engine's own CPU
## path. They do not run the effect's code: they only show what such a count costs there.


## A stand-in for an effect that is shown.
static func make(p_effect: ParticleEffect) -> CpuStandIn:
	var made: CpuStandIn = CpuStandIn.new()
	var settings: EffectSettings = p_effect.layer.file.settings
	made.amount = settings.count
	made.lifetime = settings.life
	made.preprocess = settings.life
	made.mesh = p_effect.draw_pass_1
	made.material_override = p_effect.material_override
	made.direction = Vector3.UP
	made.spread = 30.0
	made.initial_velocity_min = settings.speed[0]
	made.initial_velocity_max = settings.speed[1]
	made.gravity = Vector3(0.0, -9.81 * settings.weight, 0.0)
	made.scale_amount_min = settings.size[0]
	made.scale_amount_max = settings.size[0]
	made.color = settings.colour[0]
	return made

@tool
@icon("res://scenes/world/icons/world_lamp.svg")
class_name WorldLamp
extends OmniLight3D
## A lamp, torch or fire that is lit at dusk and in dust: see [WorldSky]. It lights what stands near
## by without shadows; lamps of houses are baked into their walls instead.

## Energy when it is wholly lit.
@export_range(0.0, 16.0, 0.1) var lit_energy: float = 2.0:
	set(p_value):
		lit_energy = p_value
		_apply()
## How much it flickers, as a share of its energy: 0 for a lamp, 0.3 for a fire.
@export_range(0.0, 0.8, 0.05) var flicker: float = 0.0:
	set(p_value):
		flicker = p_value
		set_process(flicker > 0.0)

var _strength: float = 0.0
var _seconds: float = 0.0


func _init() -> void:
	light_color = Color(1.0, 0.72, 0.42)
	light_energy = 0.0
	light_specular = 0.0
	omni_range = 9.0
	omni_attenuation = 1.4
	distance_fade_enabled = true
	distance_fade_begin = 90.0
	add_to_group(WorldSky.LAMPS)


func _ready() -> void:
	set_process(flicker > 0.0)
	_apply()
	for sky: Node in get_tree().get_nodes_in_group(WorldSky.SKIES):
		set_lamp_strength((sky as WorldSky).state.lamps)


func _process(p_delta: float) -> void:
	_seconds += p_delta
	_apply()


## Lights it by a share, 0 to 1: [WorldSky] does so at dusk.
func set_lamp_strength(p_strength: float) -> void:
	_strength = clampf(p_strength, 0.0, 1.0)
	_apply()


func _apply() -> void:
	var waver: float = sin(_seconds * 11.3) + sin(_seconds * 17.9 + 1.0) + sin(_seconds * 29.0)
	light_energy = lit_energy * _strength * (1.0 + flicker * waver / 3.0)
	visible = light_energy > 0.001

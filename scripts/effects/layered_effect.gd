@tool
class_name LayeredEffect
extends Node3D
## Shows an effect of the [EffectLibrary] with all its layers, and goes over to its newest text
## while it runs.

## Name of the effect, such as [code]smoke[/code]; one that is not known shows nothing.
var effect: String = "":
	set(p_value):
		effect = p_value
		if is_inside_tree():
			_build()
## Whether new particles are made. Effects that play once begin with [method play] instead.
var emitting: bool = true:
	set(p_value):
		if p_value == emitting:
			return
		emitting = p_value
		for shown: ParticleEffect in parts:
			if not shown.one_shot:
				shown.emitting = p_value
## Share of the particles that is wanted now, 0 to 1.
var share: float = 1.0:
	set(p_value):
		share = p_value
		for shown: ParticleEffect in parts:
			shown.share = p_value
## Its layers.
var parts: Array[ParticleEffect] = []

var _inputs: Dictionary[StringName, Variant] = {}


## One of an effect, not yet in the tree.
static func make(p_effect: String, p_is_emitting: bool = true) -> LayeredEffect:
	var made: LayeredEffect = LayeredEffect.new()
	made.effect = p_effect
	made.emitting = p_is_emitting
	return made


func _enter_tree() -> void:
	EffectLibrary.shared().changed.connect(_on_changed)
	if parts.is_empty():
		_build()


func _exit_tree() -> void:
	EffectLibrary.shared().changed.disconnect(_on_changed)


## Plays those layers that play once, from their beginning.
func play() -> void:
	for shown: ParticleEffect in parts:
		if shown.one_shot:
			shown.restart()


## Sets an input or another uniform of all its layers: see [method ParticleEffect.set_input].
func set_input(p_name: StringName, p_value: Variant) -> void:
	_inputs[p_name] = p_value
	for shown: ParticleEffect in parts:
		shown.set_input(p_name, p_value)


## Time after which the present particles are gone, s.
func longest_life() -> float:
	var longest: float = 0.0
	for shown: ParticleEffect in parts:
		longest = maxf(longest, shown.lifetime * (2.0 - shown.explosiveness))
	return longest


## Farthest that it is seen, m; 0 for any distance.
func farthest() -> float:
	var most: float = 0.0
	for shown: ParticleEffect in parts:
		var settings: EffectSettings = shown.layer.file.settings
		if settings.fade[1] <= 0.0:
			return 0.0
		most = maxf(most, settings.fade[1])
	return most


## Layers that are still there keep their particles.
func _build() -> void:
	var layers: Array[EffectLayer] = EffectLibrary.shared().layers(effect)
	while parts.size() > layers.size():
		(parts.pop_back() as ParticleEffect).queue_free()
	while parts.size() < layers.size():
		var made: ParticleEffect = ParticleEffect.new()
		# Before it is in the tree: a new one would emit at once.
		made.emitting = false
		parts.append(made)
	for index: int in layers.size():
		var shown: ParticleEffect = parts[index]
		shown.show_layer(layers[index])
		shown.share = share
		for input: StringName in _inputs:
			shown.set_input(input, _inputs[input])
		if not shown.is_inside_tree():
			add_child(shown)
		if not shown.one_shot:
			shown.emitting = emitting


func _on_changed(p_effect: String) -> void:
	if p_effect == effect:
		_build()

@tool
class_name EffectLayer
extends RefCounted
## One file of an effect as it is shown now: everything that shows it shares its shader and its
## material, so new code reaches all running particles at once.

## The file's name, such as [code]smoke[/code].
var name: String = ""
## What is shown: always a file without problems.
var file: EffectFile = null
## Moves the particles.
var shader: Shader = Shader.new()
## Draws them.
var material: ShaderMaterial = null


## A layer that shows a file without problems.
static func make(p_name: String, p_file: EffectFile) -> EffectLayer:
	var layer: EffectLayer = EffectLayer.new()
	layer.name = p_name
	layer.take(p_file)
	return layer


## Shows another file without problems. Returns whether what shows it must be set up anew: of new
## code alone, running particles need to know nothing.
func take(p_file: EffectFile) -> bool:
	var is_new: bool = file == null or not file.settings.draws_like(p_file.settings)
	file = p_file
	shader.code = p_file.code()
	if is_new:
		material = EffectDrawing.make_material(p_file.settings)
	return is_new


## The effect that it belongs to: its own, or the one that it is a layer of.
func effect() -> String:
	return file.settings.layer_of if file.settings.layer_of != "" else name

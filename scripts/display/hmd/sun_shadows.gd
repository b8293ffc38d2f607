class_name SunShadows
extends RefCounted
## Switches off the shadows of suns, which are drawn anew for every picture, and on again those that
## were on.

var _switched: Array[DirectionalLight3D] = []


## Shadows of every sun below a node, on or off.
func set_shown(p_root: Node, p_are_shown: bool) -> void:
	if p_are_shown:
		restore()
		return
	for node: Node in p_root.find_children("*", "DirectionalLight3D", true, false):
		var sun: DirectionalLight3D = node as DirectionalLight3D
		if sun.shadow_enabled:
			sun.shadow_enabled = false
			_switched.append(sun)


## As it was.
func restore() -> void:
	for sun: DirectionalLight3D in _switched:
		if is_instance_valid(sun):
			sun.shadow_enabled = true
	_switched.clear()

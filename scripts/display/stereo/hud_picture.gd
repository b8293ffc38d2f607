class_name HudPicture
extends SubViewport
## What lies over the world of a window - texts, menus - drawn once into a picture of its own, for a
## window that shows it several times: once for each eye.
##
## It takes the canvas layers of the window, also those that come later. They stay where they are in
## the tree; what is not in a layer stays in the window.

var _window: Window = null
var _own: CanvasLayer = null


func _init() -> void:
	transparent_bg = true
	disable_3d = true
	gui_disable_input = true
	render_target_update_mode = SubViewport.UPDATE_ALWAYS
	size_2d_override_stretch = true


## Takes the canvas layers of a window, but not one of them.
func take_from(p_window: Window, p_not: CanvasLayer) -> void:
	_window = p_window
	_own = p_not
	for found: Node in p_window.find_children("*", "CanvasLayer", true, false):
		_take(found)
	p_window.get_tree().node_added.connect(_take)


## Gives the layers back to the window.
func give_back() -> void:
	if _window == null:
		return
	_window.get_tree().node_added.disconnect(_take)
	for found: Node in _window.find_children("*", "CanvasLayer", true, false):
		var layer: CanvasLayer = found
		if layer.custom_viewport == self:
			# Godot cannot set a custom viewport back to null; the window is the default.
			layer.custom_viewport = _window
	_window = null


## Draws with so many pixels what is laid out for another size.
func fit(p_pixels: Vector2i, p_laid_out: Vector2) -> void:
	if size != p_pixels:
		size = p_pixels
	var laid_out: Vector2i = p_laid_out.round()
	if size_2d_override != laid_out:
		size_2d_override = laid_out


func _take(p_node: Node) -> void:
	var layer: CanvasLayer = p_node as CanvasLayer
	if layer == null or layer == _own or layer.get_viewport() != _window:
		return
	if layer.custom_viewport == null or layer.custom_viewport == _window:
		layer.custom_viewport = self

@tool
extends Node
## Pictures of what can be placed: each is rendered once and kept in the editor's cache.

## A picture is there.
signal made(p_item: RefCounted, p_picture: Texture2D)

## Edge of a picture, pixels.
const SIZE: int = 128
## Edge of an icon, pixels.
const ICON_PX: float = 16.0

var _waiting: Array = []
var _is_busy: bool = false


## Asks for pictures; [signal made] brings each.
func ask(p_items: Array) -> void:
	_waiting.append_array(p_items)
	_work()


func _work() -> void:
	if _is_busy:
		return
	_is_busy = true
	while not _waiting.is_empty():
		var item: RefCounted = _waiting.pop_front()
		var path: String = _folder().path_join(str(item.key()).md5_text() + ".png")
		var image: Image = Image.load_from_file(path) if FileAccess.file_exists(path) else null
		if image == null:
			image = await _render(item)
			image = _icon_of(item.source) if image == null else image
			if image != null:
				DirAccess.make_dir_recursive_absolute(_folder())
				image.save_png(path)
		if image != null:
			made.emit(item, ImageTexture.create_from_image(image))
	_is_busy = false


static func _folder() -> String:
	return EditorInterface.get_editor_paths().get_cache_dir().path_join("dismount_level_kit")


## The icon of what is not seen in the game, or null.
static func _icon_of(p_source: String) -> Image:
	for row: Dictionary in ProjectSettings.get_global_class_list():
		if row["path"] == p_source and FileAccess.file_exists(row["icon"]):
			var image: Image = Image.new()
			var scale: float = SIZE / 2.0 / ICON_PX
			if image.load_svg_from_string(FileAccess.get_file_as_string(row["icon"]), scale) == OK:
				return image
	return null


## A picture of an item, or null where there is nothing to see of it.
func _render(p_item: RefCounted) -> Image:
	var view: SubViewport = SubViewport.new()
	view.size = Vector2i(SIZE, SIZE)
	view.own_world_3d = true
	view.transparent_bg = true
	view.msaa_3d = Viewport.MSAA_4X
	view.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	var node: Node3D = p_item.make()
	node.process_mode = Node.PROCESS_MODE_DISABLED
	view.add_child(node)
	add_child(view)
	var box: AABB = _bounds(node)
	var image: Image = null
	if box.size != Vector3.ZERO:
		_light(view, box)
		for frame: int in 3:
			await RenderingServer.frame_post_draw
		image = view.get_texture().get_image()
	view.queue_free()
	return image


static func _light(p_view: SubViewport, p_box: AABB) -> void:
	var sun: DirectionalLight3D = DirectionalLight3D.new()
	sun.rotation_degrees = Vector3(-50.0, 35.0, 0.0)
	p_view.add_child(sun)
	var camera: Camera3D = Camera3D.new()
	camera.fov = 30.0
	p_view.add_child(camera)
	var from: Vector3 = Vector3(0.8, 0.7, 1.2).normalized() * p_box.size.length() * 2.0
	camera.look_at_from_position(p_box.get_center() + from, p_box.get_center())


static func _bounds(p_node: Node) -> AABB:
	var box: AABB = AABB()
	for child: Node in p_node.get_children(true):
		var part: AABB = _bounds(child)
		var shown: GeometryInstance3D = child as GeometryInstance3D
		if shown != null:
			part = shown.global_transform * shown.get_aabb()
		if part.size != Vector3.ZERO:
			box = part if box.size == Vector3.ZERO else box.merge(part)
	return box

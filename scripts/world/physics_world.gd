class_name PhysicsWorld
extends Node3D
## Draws the collision shapes of everything as wire frames, exactly where the newest snapshot has
## them: no smoothing, no meshes (thesis section 4.2.3).

## Colour of people's limbs.
const LIMBS: Color = Color(0.2, 1.0, 0.35)
## Colour of what moves.
const PROPS: Color = Color(1.0, 0.75, 0.2)
## Colour of what never moves.
const FIXED: Color = Color(0.35, 0.6, 1.0)
## Colour of what never moves where this machine's level is not the server's.
const DIFFERS: Color = Color(1.0, 0.2, 0.2)

## Frames of an entity: one for a body, one for each limb of a person.
var _frames: Dictionary[int, Array] = {}
var _fixed: Array[Node3D] = []


## Draws the static bodies of a level again; [param p_differs] if the server's level differs.
func set_level(p_level: Level, p_differs: bool = false) -> void:
	for frame: Node3D in _fixed:
		frame.queue_free()
	_fixed.clear()
	if p_level == null:
		return
	for body: StaticBody3D in p_level.get_static_bodies():
		var frame: Node3D = _make_frame(body, DIFFERS if p_differs else FIXED)
		frame.transform = body.global_transform
		_fixed.append(frame)


## Draws a body that moves, under the number of its entity.
func add_body(p_id: int, p_body: PhysicsBody3D) -> void:
	remove(p_id)
	_frames[p_id] = [_make_frame(p_body, PROPS)]
	_frames[p_id][0].visible = false


## Draws a person's bodies, in the order of the limbs, under the number of the person.
func add_person(p_id: int, p_bodies: Array[PhysicsBody3D]) -> void:
	remove(p_id)
	var frames: Array[Node3D] = []
	for body: PhysicsBody3D in p_bodies:
		var frame: Node3D = _make_frame(body, LIMBS)
		frame.visible = false
		frames.append(frame)
	_frames[p_id] = frames


## Removes an entity.
func remove(p_id: int) -> void:
	for frame: Node3D in _frames.get(p_id, []):
		frame.queue_free()
	_frames.erase(p_id)


## Moves the frames of an entity to where its bodies are.
func set_transforms(p_id: int, p_transforms: Array[Transform3D]) -> void:
	var frames: Array = _frames.get(p_id, [])
	for index: int in mini(frames.size(), p_transforms.size()):
		frames[index].transform = p_transforms[index]
		frames[index].visible = true


## Where a frame of an entity is, for tests and measurements.
func get_frame_transform(p_id: int, p_index: int = 0) -> Transform3D:
	return _frames[p_id][p_index].transform


func _make_frame(p_body: PhysicsBody3D, p_colour: Color) -> Node3D:
	var frame: Node3D = Node3D.new()
	add_child(frame)
	for child: Node in p_body.get_children(true):
		var shape: CollisionShape3D = child as CollisionShape3D
		if shape != null and shape.shape != null:
			frame.add_child(_make_wires(shape.shape, shape.transform, p_colour))
	return frame


static func _make_wires(
	p_shape: Shape3D, p_transform: Transform3D, p_colour: Color
) -> MeshInstance3D:
	var material: StandardMaterial3D = StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.albedo_color = p_colour
	var wires: MeshInstance3D = MeshInstance3D.new()
	wires.mesh = _keep_lines(p_shape.get_debug_mesh())
	wires.material_override = material
	wires.transform = p_transform
	wires.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	return wires


## The lines of a debug mesh, which fills its faces too.
static func _keep_lines(p_mesh: ArrayMesh) -> ArrayMesh:
	var lines: ArrayMesh = ArrayMesh.new()
	for surface: int in p_mesh.get_surface_count():
		if p_mesh.surface_get_primitive_type(surface) == Mesh.PRIMITIVE_LINES:
			var arrays: Array = p_mesh.surface_get_arrays(surface)
			lines.add_surface_from_arrays(Mesh.PRIMITIVE_LINES, arrays)
	return lines

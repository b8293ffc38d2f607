@tool
@icon("res://scenes/world/icons/block.svg")
class_name Block
extends StaticBody3D
## A box of the static world: a floor, a wall, a platform. It makes its own mesh and collision
## shape.

## Edge lengths.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector3 = Vector3.ONE:
	set(value):
		size = value.max(Vector3.ONE * 0.01)
		_rebuild()
## What it looks like.
@export var material: Material:
	set(value):
		material = value
		_rebuild()


func _ready() -> void:
	_rebuild()


func _get_configuration_warnings() -> PackedStringArray:
	if not scale.is_equal_approx(Vector3.ONE):
		return ["A scaled body collides wrongly: set the scale to 1 and change 'size' instead."]
	return []


func _rebuild() -> void:
	if not is_inside_tree():
		return
	remove_boxes(self)
	add_box(self, Transform3D.IDENTITY, size, material)
	update_configuration_warnings()


## Takes away the boxes of [method add_box], and nothing else.
static func remove_boxes(p_body: StaticBody3D) -> void:
	var others: Array[Node] = p_body.get_children()
	for child: Node in p_body.get_children(true):
		if not others.has(child):
			child.free()


## Gives a body a box with mesh and shape. They belong to no scene, so they are not saved.
static func add_box(
	p_body: StaticBody3D, p_transform: Transform3D, p_size: Vector3, p_material: Material
) -> void:
	var mesh: BoxMesh = BoxMesh.new()
	mesh.size = p_size
	mesh.material = p_material
	var shown: MeshInstance3D = MeshInstance3D.new()
	shown.mesh = mesh
	shown.transform = p_transform
	p_body.add_child(shown, false, Node.INTERNAL_MODE_BACK)
	var box: BoxShape3D = BoxShape3D.new()
	box.size = p_size
	var shape: CollisionShape3D = CollisionShape3D.new()
	shape.shape = box
	shape.transform = p_transform
	p_body.add_child(shape, false, Node.INTERNAL_MODE_BACK)

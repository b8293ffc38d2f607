@tool
@icon("res://scenes/world/icons/stairs.svg")
class_name Stairs
extends StaticBody3D
## A flight of stairs that rises along -Z from its origin, with a landing at the top.

## Number of steps.
@export_range(1, 64) var steps: int = 8:
	set(value):
		steps = maxi(value, 1)
		_rebuild()
## Height of a step.
@export_range(0.05, 0.5, 0.005, "suffix:m") var rise: float = 0.17:
	set(value):
		rise = maxf(value, 0.01)
		_rebuild()
## Depth of a step.
@export_range(0.1, 1.0, 0.005, "suffix:m") var going: float = 0.29:
	set(value):
		going = maxf(value, 0.05)
		_rebuild()
## Width of the flight.
@export_range(0.5, 10.0, 0.05, "suffix:m") var width: float = 2.0:
	set(value):
		width = maxf(value, 0.1)
		_rebuild()
## Depth of the landing behind the last step; 0 for none.
@export_range(0.0, 10.0, 0.05, "suffix:m") var landing: float = 1.5:
	set(value):
		landing = maxf(value, 0.0)
		_rebuild()
## What it looks like.
@export var material: Material:
	set(value):
		material = value
		_rebuild()


func _ready() -> void:
	_rebuild()


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = []
	if not scale.is_equal_approx(Vector3.ONE):
		warnings.append("A scaled body collides wrongly: set the scale to 1 and change the sizes.")
	if 2.0 * rise + going < 0.55 or 2.0 * rise + going > 0.75:
		var text: String = "People walk steps with 2 x rise + going of 0.6 to 0.65 m; here it is %.2f m."
		warnings.append(text % (2.0 * rise + going))
	return warnings


func _rebuild() -> void:
	if not is_inside_tree():
		return
	Block.remove_boxes(self)
	for step: int in steps:
		var depth: float = going + (landing if step == steps - 1 else 0.0)
		var size: Vector3 = Vector3(width, rise * (step + 1), depth)
		var middle: Vector3 = Vector3(0.0, size.y / 2.0, -(going * step + depth / 2.0))
		Block.add_box(self, Transform3D(Basis.IDENTITY, middle), size, material)
	update_configuration_warnings()

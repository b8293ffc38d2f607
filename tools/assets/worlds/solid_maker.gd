class_name SolidMaker
extends RefCounted
## What makers of things for a world share: faces and solid boxes of a [BlockMesh], and dice.

## Numbers of tints: see BuildDesert.TINTS.
enum Tint { PLAIN, SOOT, OLIVE, SAND, RED, WHITE, DRAB, DARK, PALE_ROCK, RED_ROCK, GREY, RUBBER }

var _mesh: BlockMesh = null
var _dice: RandomNumberGenerator = RandomNumberGenerator.new()


func _init(p_mesh: BlockMesh, p_seed: int) -> void:
	_mesh = p_mesh
	_dice.seed = p_seed


func _box(p_middle: Vector3, p_size: Vector3, p_layer: int, p_tint: int) -> void:
	_mesh.box(p_middle - p_size / 2.0, p_middle + p_size / 2.0, p_layer, p_tint)


func _solid(p_middle: Vector3, p_size: Vector3) -> void:
	_mesh.solid(p_middle - p_size / 2.0, p_middle + p_size / 2.0)

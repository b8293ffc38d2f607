class_name LevelAir
extends Node
## Light in the air of a level for what moves in it, and how far the eye opens in the dark.

## How far the eye opens and how quickly it gets used to another light, 1/s.
const MAX_EXPOSURE: float = 2.6
const SPEED: float = 1.6
## Share of the sky's light in a street: where there is as much, the eye is as open as outdoors, at
## any hour.
const OUTDOORS: float = 0.45
const _POWER: float = 0.5

## Whose grid is used; null for none. Set before it enters the tree.
var bake: LevelBake = null

var _grid: LightGrid = LightGrid.new()
var _texture: ImageTexture3D = null
var _version: int = -1
var _exposure: float = 1.0


func _ready() -> void:
	if bake != null and not _grid.set_points(bake.grid, bake.grid_counts):
		bake = null
	_refresh()


func _exit_tree() -> void:
	WorldLight.set_grid(null, Vector3.ZERO, Vector3.ZERO)
	WorldLight.set_exposure(1.0)


func _process(p_delta: float) -> void:
	if _version != WorldLight.version:
		_refresh()
	var camera: Camera3D = get_viewport().get_camera_3d()
	if bake == null or camera == null:
		return
	var wanted: float = exposure_at(camera.global_position)
	_exposure = lerpf(_exposure, wanted, 1.0 - exp(-SPEED * p_delta))
	WorldLight.set_exposure(_exposure)


## How far the eye opens at a position in the level.
func exposure_at(p_place: Vector3) -> float:
	var at: Vector3 = (p_place - bake.grid_origin) / bake.grid_spacing
	var here: float = _grey(_grid.mean_at(at, WorldLight.strengths))
	var outdoors: float = OUTDOORS * _grey(WorldLight.strengths[WorldLight.Source.SKY])
	return clampf(pow(outdoors / maxf(here, 0.001), _POWER), 1.0, MAX_EXPOSURE)


func _refresh() -> void:
	_version = WorldLight.version
	if bake == null:
		WorldLight.set_grid(null, Vector3.ZERO, Vector3.ZERO)
		return
	var texels: PackedByteArray = _grid.combine(WorldLight.strengths)
	var counts: Vector3i = bake.grid_counts
	var slice: int = counts.x * counts.y * 4
	var images: Array[Image] = []
	for z: int in counts.z:
		var bytes: PackedByteArray = texels.slice(z * slice, (z + 1) * slice)
		images.append(Image.create_from_data(counts.x, counts.y, false, Image.FORMAT_RGBA8, bytes))
	if _texture == null or _texture.get_depth() != counts.z:
		_texture = ImageTexture3D.new()
		_texture.create(Image.FORMAT_RGBA8, counts.x, counts.y, counts.z, false, images)
	else:
		_texture.update(images)
	# Texels have their colour in their middle, which is where the points are.
	var spacing: Vector3 = bake.grid_spacing
	WorldLight.set_grid(_texture, bake.grid_origin - spacing / 2.0, spacing * Vector3(counts))


static func _grey(p_light: Vector3) -> float:
	return (p_light.x + p_light.y + p_light.z) / 3.0

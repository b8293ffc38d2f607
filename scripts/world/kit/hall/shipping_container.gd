@tool
@icon("res://scenes/world/icons/shipping_container.svg")
class_name ShippingContainer
extends KitBlock
## A container of 20 feet, 6.06 x 2.59 x 2.44 m, along X. Its origin is the middle of its bottom,
## its doors are at +X.

const SIZE: Vector3 = Vector3(6.06, 2.59, 2.44)
const _SHEET: SurfaceLayers.Layer = SurfaceLayers.Layer.CORRUGATED
const _WALL: float = 0.05
const _POST: float = 0.16

## Its colour.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.BLUE:
	set(p_value):
		tint = p_value
		queue_rebuild()
## Whether its doors stand open, so that people walk in.
@export var is_open: bool = false:
	set(p_value):
		is_open = p_value
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(ShippingContainer, 500)
	entry.offered("Container", "box goods")
	return entry


func contact_key() -> StringName:
	return &"metal"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var half: Vector3 = SIZE / 2.0
	_add_walls(p_mesh, half)
	_add_frame(p_mesh, half)
	for side: int in 2:
		var hinge: float = (half.z - 0.12) * (1.0 if side == 0 else -1.0)
		_add_door(p_mesh, Vector3(half.x - 0.05, 0.2, hinge), side == 0)
	var plain: int = SurfaceTints.Tint.PLAIN
	p_mesh.box(
		Vector3(-half.x + 0.06, 0.1, -half.z + 0.06),
		Vector3(half.x - 0.06, 0.16, half.z - 0.06),
		SurfaceLayers.Layer.WOOD,
		plain,
		0,
		true
	)
	if is_open:
		p_mesh.box(
			Vector3(half.x - 0.06, 0.02, -half.z + 0.2),
			Vector3(half.x + 0.02, 0.15, half.z - 0.2),
			SurfaceLayers.Layer.STEEL,
			plain,
			0,
			true
		)


func _add_walls(p_mesh: BlockMesh, p_half: Vector3) -> void:
	for side: float in [-1.0, 1.0]:
		var z: float = side * (p_half.z - 0.06)
		p_mesh.box(
			Vector3(-p_half.x + 0.05, 0.1, z - _WALL / 2.0),
			Vector3(p_half.x - 0.05, SIZE.y - 0.08, z + _WALL / 2.0),
			_SHEET,
			tint,
			0,
			true
		)
		# What stands out between the waves casts the shadows that a flat picture cannot.
		for rib: int in 15:
			var x: float = -p_half.x + 0.34 + 0.385 * rib
			var out: float = z + side * _WALL / 2.0
			p_mesh.box(
				Vector3(x - 0.07, 0.16, minf(out, out + side * 0.022)),
				Vector3(x + 0.07, SIZE.y - 0.12, maxf(out, out + side * 0.022)),
				_SHEET,
				tint
			)
	var back: Vector3 = Vector3(-p_half.x + 0.04, 0.1, -p_half.z + 0.05)
	var far: Vector3 = Vector3(-p_half.x + 0.09, SIZE.y - 0.08, p_half.z - 0.05)
	p_mesh.box(back, far, _SHEET, tint, 0, true)
	p_mesh.box(
		Vector3(-p_half.x + 0.05, SIZE.y - 0.08, -p_half.z + 0.05),
		Vector3(p_half.x - 0.05, SIZE.y - 0.03, p_half.z - 0.05),
		_SHEET,
		tint,
		0,
		true
	)


## Posts, rails and the castings at the corners.
func _add_frame(p_mesh: BlockMesh, p_half: Vector3) -> void:
	var paint: int = Steelwork.PAINT
	for z: float in [-p_half.z, p_half.z - 0.1]:
		for y: float in [0.0, SIZE.y - 0.12]:
			p_mesh.box(Vector3(-p_half.x, y, z), Vector3(p_half.x, y + 0.12, z + 0.1), paint, tint)
		for x: float in [-p_half.x, p_half.x - 0.12]:
			p_mesh.box(Vector3(x, 0.0, z), Vector3(x + 0.12, SIZE.y, z + 0.1), paint, tint, 0, true)
	for x: float in [-p_half.x, p_half.x - 0.1]:
		var high: Vector3 = Vector3(x + 0.1, SIZE.y, p_half.z)
		p_mesh.box(Vector3(x, SIZE.y - 0.12, -p_half.z), high, paint, tint)
		p_mesh.box(Vector3(x, 0.0, -p_half.z), Vector3(x + 0.1, 0.1, p_half.z), paint, tint)
	var iron: int = SurfaceTints.Tint.IRON
	for x: float in [-p_half.x - 0.012, p_half.x - _POST + 0.012]:
		for y: float in [-0.002, SIZE.y - 0.118]:
			for z: float in [-p_half.z - 0.012, p_half.z - _POST + 0.012]:
				var low: Vector3 = Vector3(x, y, z)
				p_mesh.box(low, low + Vector3(_POST, 0.12, _POST), paint, iron)


## A leaf with two locking bars; p_is_left is that at +Z.
func _add_door(p_mesh: BlockMesh, p_hinge: Vector3, p_is_left: bool) -> void:
	var wide: float = SIZE.z / 2.0 - 0.13
	var angle: float = PI / 2.0 if p_is_left else -PI / 2.0
	if is_open:
		angle -= 1.95 * (1.0 if p_is_left else -1.0) * -1.0
	var base: Transform3D = p_mesh.get_place()
	p_mesh.set_place(base * Transform3D(Basis(Vector3.UP, angle), p_hinge))
	var high: float = SIZE.y - 0.34
	var out: float = 1.0 if p_is_left else -1.0
	p_mesh.box(Vector3(0.0, 0.0, -0.02), Vector3(wide, high, 0.02), _SHEET, tint, 0, true)
	var iron: int = SurfaceTints.Tint.GREY_STONE
	for x: float in [wide * 0.3, wide * 0.78]:
		var foot: Vector3 = Vector3(x, -0.05, out * 0.06)
		p_mesh.rod(foot, foot + Vector3.UP * (high + 0.08), 0.018, 0.018, Steelwork.PAINT, iron, 6)
		for y: float in [0.12, high * 0.5, high - 0.12]:
			var middle: Vector3 = Vector3(x, y, out * 0.045)
			var half: Vector3 = Vector3(0.05, 0.04, 0.035)
			p_mesh.box(middle - half, middle + half, Steelwork.PAINT, iron)
		var handle: Vector3 = Vector3(x, high * 0.38, out * 0.085)
		p_mesh.rod(handle, handle + Vector3(-0.3, 0.0, 0.0), 0.014, 0.014, Steelwork.PAINT, iron, 6)
	p_mesh.set_place(base)

@tool
@icon("res://scenes/world/icons/road.svg")
class_name Road
extends KitBlock
## A straight piece of road on level ground, along -Z from its origin, in the middle of its end.
## Pieces whose ends meet are one road.

## What a road is made of.
enum Surface {
	## An old road, with kerbs and markings if there are any.
	ASPHALT,
	## Stones close together.
	GRAVEL,
	## Trodden earth.
	DIRT,
}
## What is painted on it.
enum Markings {
	NONE,
	## A dashed line along its middle.
	MIDDLE,
	## The same, and a line along each side.
	MIDDLE_AND_SIDES,
	## Stripes all over it, on which people cross the road.
	CROSSING,
}

## Width and height over the road of a kerb, m: a step for people, a bump for wheels.
const KERB_M: Vector2 = Vector2(0.2, 0.12)
const _LAYERS: Array[SurfaceLayers.Layer] = [
	SurfaceLayers.Layer.ASPHALT, SurfaceLayers.Layer.GRAVEL, SurfaceLayers.Layer.DIRT
]
# Over the road, m: what is painted is not in it.
const _PAINT_M: float = 0.004
const _LINE_M: float = 0.12
# From the edge of the road, or from its kerb, to the line along it, m.
const _ASIDE_M: float = 0.2
const _STRIPE_M: float = 0.5
const _DASH_M: float = 1.5
const _PERIOD_M: float = 4.0

## Width without kerbs, and length.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector2 = Vector2(6.0, 8.0):
	set(p_value):
		size = p_value.clamp(Vector2(1.0, 0.5), Vector2(30.0, 200.0))
		queue_rebuild()
## How high it lies over the ground. Let a road that crosses another lie 0.01 m higher, or both
## flicker where they are one.
@export_range(0.01, 0.3, 0.005, "suffix:m") var height: float = 0.02:
	set(p_value):
		height = clampf(p_value, 0.01, 0.3)
		queue_rebuild()
## What it is made of.
@export var surface: Surface = Surface.ASPHALT:
	set(p_value):
		surface = clampi(p_value, 0, Surface.size() - 1) as Surface
		queue_rebuild()
## What is painted on it; asphalt only.
@export var markings: Markings = Markings.MIDDLE:
	set(p_value):
		markings = clampi(p_value, 0, Markings.size() - 1) as Markings
		queue_rebuild()
@export_group("Kerbs")
## Whether there is a kerb along its left side, seen along -Z.
@export var has_left_kerb: bool = true:
	set(p_value):
		has_left_kerb = p_value
		queue_rebuild()
## Whether there is a kerb along its right side.
@export var has_right_kerb: bool = true:
	set(p_value):
		has_right_kerb = p_value
		queue_rebuild()
## Gaps in the left kerb where a road comes in: from and to along the road, m.
@export var left_gaps: PackedVector2Array = []:
	set(p_value):
		left_gaps = p_value
		queue_rebuild()
## Gaps in the right kerb.
@export var right_gaps: PackedVector2Array = []:
	set(p_value):
		right_gaps = p_value
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var crossing: Dictionary = {
		&"size": Vector2(6, 4), &"markings": Markings.CROSSING, &"has_left_kerb": false
	}
	crossing[&"has_right_kerb"] = false
	var track: Dictionary = {&"surface": Surface.DIRT, &"markings": Markings.NONE}
	track.merge({&"has_left_kerb": false, &"has_right_kerb": false, &"size": Vector2(4, 8)})
	var entry: KitEntry = KitEntry.of_block(
		Road,
		1000,
		{
			"size": PropertyRule.vector2(0.5, 200.0),
			"left_gaps": PropertyRule.gaps(),
			"right_gaps": PropertyRule.gaps()
		}
	)
	entry.offered("Road", "street asphalt kerb way")
	entry.offered("Road crossing", "zebra street way", crossing)
	entry.offered("Dirt road", "track gravel way", track)
	return entry


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = super()
	for gap: Vector2 in left_gaps + right_gaps:
		if gap.x < 0.0 or gap.y > size.y or gap.y <= gap.x:
			warnings.append("A gap in a kerb must lie within the length: from, then to, in m.")
	if markings != Markings.NONE and surface != Surface.ASPHALT:
		warnings.append("Only asphalt is painted: choose it, or no 'Markings'.")
	if is_inside_tree() and not global_basis.y.normalized().is_equal_approx(Vector3.UP):
		warnings.append("It is for level ground: use a Ramp, or paint a road onto a Terrain.")
	return warnings


func contact_key() -> StringName:
	return SurfaceLayers.key_of(_LAYERS[surface])


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var half: float = size.x / 2.0
	p_mesh.box(
		Vector3(-half, 0.0, -size.y),
		Vector3(half, height, 0.0),
		_LAYERS[surface],
		SurfaceTints.Tint.PLAIN,
		BlockMesh.FACE_BOTTOM,
		true
	)
	if has_left_kerb:
		_add_kerb(p_mesh, -half - KERB_M.x, left_gaps)
	if has_right_kerb:
		_add_kerb(p_mesh, half, right_gaps)
	if surface == Surface.ASPHALT:
		_add_markings(p_mesh)


## What gaps leave of a length: from and to, m.
static func pieces_between(p_gaps: PackedVector2Array, p_length: float) -> PackedVector2Array:
	var gaps: PackedVector2Array = p_gaps.duplicate()
	gaps.sort()
	var pieces: PackedVector2Array = []
	var from: float = 0.0
	for gap: Vector2 in gaps:
		if gap.y <= gap.x:
			continue
		if minf(gap.x, p_length) > from:
			pieces.append(Vector2(from, minf(gap.x, p_length)))
		from = maxf(from, gap.y)
	if from < p_length:
		pieces.append(Vector2(from, p_length))
	return pieces


func _add_kerb(p_mesh: BlockMesh, p_x: float, p_gaps: PackedVector2Array) -> void:
	for piece: Vector2 in pieces_between(p_gaps, size.y):
		p_mesh.box(
			Vector3(p_x, 0.0, -piece.y),
			Vector3(p_x + KERB_M.x, height + KERB_M.y, -piece.x),
			SurfaceLayers.Layer.CONCRETE,
			SurfaceTints.Tint.GREY_STONE,
			BlockMesh.FACE_BOTTOM,
			true
		)


func _add_markings(p_mesh: BlockMesh) -> void:
	var half: float = size.x / 2.0
	match markings:
		Markings.MIDDLE, Markings.MIDDLE_AND_SIDES:
			# Dashes are where they are along the whole road: pieces of one period go on with them.
			var from: float = (_PERIOD_M - _DASH_M) / 2.0
			while from < size.y:
				var long: float = minf(_DASH_M, size.y - from)
				_paint(p_mesh, Rect2(-_LINE_M / 2.0, from, _LINE_M, long))
				from += _PERIOD_M
		Markings.CROSSING:
			var count: int = maxi(int((size.x - _STRIPE_M) / (2.0 * _STRIPE_M)), 0) + 1
			var x: float = -(count - 0.5) * _STRIPE_M
			for stripe: int in count:
				_paint(p_mesh, Rect2(x + 2.0 * stripe * _STRIPE_M, 0.0, _STRIPE_M, size.y))
	if markings == Markings.MIDDLE_AND_SIDES:
		for x: float in [_ASIDE_M - half, half - _ASIDE_M - _LINE_M]:
			_paint(p_mesh, Rect2(x, 0.0, _LINE_M, size.y))


## Paint on the road: x, and y along it.
func _paint(p_mesh: BlockMesh, p_rect: Rect2) -> void:
	p_mesh.face(
		Vector3(p_rect.position.x, height + _PAINT_M, -p_rect.position.y),
		Vector3.RIGHT,
		Vector3.FORWARD,
		p_rect.size,
		SurfaceLayers.Layer.PLASTER_PALE,
		SurfaceTints.Tint.WHITE
	)

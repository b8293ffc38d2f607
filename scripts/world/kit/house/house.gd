@tool
@icon("res://scenes/world/icons/house.svg")
class_name House
extends KitBlock
## A house with a flat roof: walls with doors and windows, floors, stairs to the roof, furniture,
## and the small things that make it believable.
##
## Its front is at z = 0 and looks to +Z; it goes from x = 0 to its width and back to z = -depth.
## The same [member variant] gives the same house.

## What walls are made of.
enum Style { PLASTER, WHITEWASH, BRICK }

## The part that is seen from within only.
const INSIDE: StringName = &"inside"
## Largest width and depth, m.
const MAX_M: float = 40.0

## Width and depth.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector2 = Vector2(8.5, 9.0):
	set(p_value):
		size = p_value.clamp(Vector2(4.0, 4.0), Vector2(MAX_M, MAX_M))
		queue_rebuild()
## Storeys, each of 3 m.
@export_range(1, 5) var storeys: int = 2:
	set(p_value):
		storeys = clampi(p_value, 1, 5)
		queue_rebuild()
## What walls are made of.
@export var style: Style = Style.PLASTER:
	set(p_value):
		style = p_value
		queue_rebuild()
## Colour of the walls.
@export var tint: SurfaceTints.Tint = SurfaceTints.Tint.CREAM:
	set(p_value):
		tint = p_value
		queue_rebuild()
## Chooses windows, colours and details.
@export_range(0, 9999) var variant: int = 1:
	set(p_value):
		variant = clampi(p_value, 0, 9999)
		queue_rebuild()
## Whether it is open and has rooms, furniture, and stairs to the roof. Else its doors are shut, and
## it costs a third.
@export var entered: bool = true:
	set(p_value):
		entered = p_value
		queue_rebuild()
## Whether there is a shop with an awning in its front.
@export var shop: bool = false:
	set(p_value):
		shop = p_value
		queue_rebuild()
## Whether a door hangs in each doorway, if it is entered: people push them open.
@export var doors: bool = true:
	set(p_value):
		doors = p_value
		queue_rebuild()
## How much sand has been blown against it, 0 to 1.
@export_range(0.0, 1.0, 0.05) var sand: float = 1.0:
	set(p_value):
		sand = clampf(p_value, 0.0, 1.0)
		queue_rebuild()


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(
		House, 150, {"size": PropertyRule.vector2(4.0, House.MAX_M)}
	)
	entry.offered("House", "building rooms", {&"size": Vector2(8.5, 10)})
	entry.offered("Shop", "house building", {&"size": Vector2(8.5, 10), &"shop": true})
	entry.offered("Closed house", "building shut", {&"entered": false})
	return entry


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = super()
	if entered and not plan().has_stairs():
		var text: String = "There is no room for stairs: make it %.1f m wide and %.1f m deep "
		text += "or more, or switch off 'Entered'."
		warnings.append(text % [HousePlan.MIN_WIDTH_M, HousePlan.MIN_DEPTH_M])
	return warnings


func get_parts() -> Array[StringName]:
	var names: Array[StringName] = [OUTSIDE, ROOF]
	if entered:
		names.append(INSIDE)
	return names


func rebuild() -> void:
	super()
	if entered and doors and is_inside_tree():
		for door: Door in HouseDoors.make(plan()):
			add_child(door, false, Node.INTERNAL_MODE_BACK)


func stands_alone() -> bool:
	return true


## Where openings and stairs are.
func plan() -> HousePlan:
	var made: HousePlan = HousePlan.new(size, storeys, variant, entered, shop)
	made.tint = tint
	made.surface = [
		SurfaceLayers.Layer.PLASTER, SurfaceLayers.Layer.PLASTER_PALE, SurfaceLayers.Layer.BRICK
	][style]
	return made


## Where a door stands in the front: the middle of its sill, looking out, in the house's frame.
func get_door_place() -> Transform3D:
	for opening: HousePlan.Opening in plan().openings[0][HousePlan.Facade.FRONT]:
		if opening.kind == HousePlan.Kind.DOOR or opening.kind == HousePlan.Kind.ARCH:
			var x: float = opening.rect.get_center().x
			return Transform3D(
				Basis.IDENTITY, Vector3(x, opening.rect.position.y, -HousePlan.WALL_M / 2.0)
			)
	return Transform3D.IDENTITY


func get_lamps() -> Array[LampLight]:
	var lamps: Array[LampLight] = []
	if entered:
		for storey: int in storeys:
			var place: Vector3 = HouseRooms.lamp_place(plan(), storey)
			lamps.append(LampLight.make(place, Color(1.9, 1.25, 0.6), 9.0))
	return lamps


func contact_key() -> StringName:
	return &"plaster"


func build(p_mesh: BlockMesh, p_part: StringName) -> void:
	var made: HousePlan = plan()
	var base: Transform3D = p_mesh.get_place()
	var shift: RandomNumberGenerator = RandomNumberGenerator.new()
	shift.seed = variant
	p_mesh.set_uv_shift(Vector2(shift.randf(), shift.randf()))
	p_mesh.set_dust(sand if p_part == OUTSIDE else sand * 0.5, base.origin.y)
	if p_part == OUTSIDE:
		HouseWalls.new(p_mesh, made).build()
		HouseRoof.new(p_mesh, made).build_edge()
		HouseDetails.new(p_mesh, made).build()
	elif p_part == ROOF:
		HouseRoof.new(p_mesh, made).build_top()
	else:
		HouseWalls.new(p_mesh, made).build_inner_faces()
		HouseRooms.new(p_mesh, made).build()
	p_mesh.set_place(base)
	p_mesh.set_uv_shift(Vector2.ZERO)

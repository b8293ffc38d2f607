class_name HousePlan
extends RefCounted
## Where the doors, windows and stairs of a [House] are, and how it looks: the same for the same
## numbers, on every machine.
##
## In the house's frame: the front is at z = 0 and looks to +Z, the house goes from x = 0 to its
## width and back to z = -depth; y = 0 is the ground.

## What fills an opening.
enum Kind { WINDOW, DOOR, ARCH, SHOP, BALCONY }
## Sides of the house.
enum Facade { FRONT, RIGHT, BACK, LEFT }

## Thickness of outer walls, m.
const WALL_M: float = 0.35
## Height from floor to floor, m.
const STOREY_M: float = 3.0
## Thickness of floors, m.
const FLOOR_M: float = 0.2
## The ground floor lies so far above the ground, m: no step that a foot would catch on.
const GROUND_FLOOR_M: float = 0.03
## A flight: steps of 3 m / 17 = 0.176 m, m deep and m wide.
const STEPS: int = 17
const GOING_M: float = 0.27
const STAIRS_WIDTH_M: float = 1.25
## Room before the first and behind the last step, m.
const LANDING_M: float = 1.15
## Least width and depth of a house whose roof is reached by stairs, m.
const MIN_DEPTH_M: float = STEPS * GOING_M + 2.0 * LANDING_M + 2.0 * WALL_M
const MIN_WIDTH_M: float = 5.0


## An opening in a wall.
class Opening:
	## From the wall's lower left corner, as seen from outside, m.
	var rect: Rect2 = Rect2()
	var kind: Kind = Kind.WINDOW
	## A number that chooses details, 0 to 1.
	var chance: float = 0.0

	func _init(p_rect: Rect2, p_kind: Kind, p_chance: float) -> void:
		rect = p_rect
		kind = p_kind
		chance = p_chance


var width: float = 8.0
var depth: float = 9.0
var storeys: int = 2
var is_entered: bool = true
## Surface and tint of the walls, tint of trims, of painted wood, of cloth.
var surface: SurfaceLayers.Layer = SurfaceLayers.Layer.PLASTER
var tint: int = SurfaceTints.Tint.CREAM
var trim: int = SurfaceTints.Tint.TRIM_PALE
var paint: int = SurfaceTints.Tint.BLUE
var cloth: int = SurfaceTints.Tint.PLAIN
## Height of the wall around the roof, m.
var parapet: float = 0.95
## Openings by storey, then by [enum Facade].
var openings: Array[Array] = []
## What is left for details.
var dice: RandomNumberGenerator = RandomNumberGenerator.new()


func _init(
	p_size: Vector2, p_storeys: int, p_seed: int, p_is_entered: bool, p_has_shop: bool
) -> void:
	width = p_size.x
	depth = p_size.y
	storeys = p_storeys
	is_entered = p_is_entered
	dice.seed = p_seed
	paint = SurfaceTints.Tint.BLUE + dice.randi_range(0, 4)
	trim = SurfaceTints.Tint.TRIM_PALE + dice.randi_range(0, 2)
	cloth = [SurfaceTints.Tint.PLAIN, SurfaceTints.Tint.CLOTH_BLUE, SurfaceTints.Tint.CLOTH_OLIVE][
		dice.randi_range(0, 2)
	]
	parapet = dice.randf_range(0.75, 1.05)
	for storey: int in storeys:
		var walls: Array = []
		for wall: int in 4:
			walls.append(_choose_openings(storey, wall as Facade, p_has_shop))
		openings.append(walls)


## Whether stairs lead to the storeys above and to the roof.
func has_stairs() -> bool:
	return is_entered and depth >= MIN_DEPTH_M - 0.001 and width >= MIN_WIDTH_M - 0.001


## Where the stairs are, seen from above: x to the right, y from the front to the back, m. The steps
## only, without the landings.
func stairs_rect() -> Rect2:
	var back: float = depth - WALL_M - LANDING_M
	var length: float = STEPS * GOING_M
	return Rect2(width - WALL_M - STAIRS_WIDTH_M, back - length, STAIRS_WIDTH_M, length)


## Length of a wall, m.
func length_of(p_wall: Facade) -> float:
	return width if p_wall == Facade.FRONT or p_wall == Facade.BACK else depth


## Lower left corner of a wall as seen from outside, at a height.
func corner_of(p_wall: Facade, p_height: float) -> Vector3:
	match p_wall:
		Facade.FRONT:
			return Vector3(0.0, p_height, 0.0)
		Facade.RIGHT:
			return Vector3(width, p_height, 0.0)
		Facade.BACK:
			return Vector3(width, p_height, -depth)
	return Vector3(0.0, p_height, -depth)


## To the right along a wall as seen from outside.
static func along(p_wall: Facade) -> Vector3:
	match p_wall:
		Facade.FRONT:
			return Vector3.RIGHT
		Facade.RIGHT:
			return Vector3.FORWARD
		Facade.BACK:
			return Vector3.LEFT
	return Vector3.BACK


func _choose_openings(p_storey: int, p_wall: Facade, p_has_shop: bool) -> Array[Opening]:
	var found: Array[Opening] = []
	var inner: float = length_of(p_wall) - 2.0 * WALL_M - 0.8
	if p_wall == Facade.FRONT and p_storey == 0:
		return _choose_entrance(inner, p_has_shop)
	if p_wall == Facade.BACK and p_storey == 0:
		if is_entered:
			found.append(_door(1.2 + 0.35 * inner, Kind.DOOR))
		return found
	# The stairs run along the right wall.
	var is_blind: bool = p_wall == Facade.RIGHT or (p_wall == Facade.LEFT and dice.randf() < 0.4)
	if is_blind or (p_wall == Facade.LEFT and p_storey == 0):
		return found
	var count: int = int(inner / 2.3)
	for number: int in count:
		if dice.randf() < 0.18:
			continue
		var is_tall: bool = p_wall == Facade.FRONT and dice.randf() < 0.2
		var wide: float = 1.05 if is_tall else 0.95
		var x: float = WALL_M + 0.4 + inner / count * (number + 0.5) - wide / 2.0
		var rect: Rect2 = Rect2(x, FLOOR_M, wide, 2.15) if is_tall else Rect2(x, 0.95, wide, 1.3)
		var kind: Kind = Kind.BALCONY if is_tall else Kind.WINDOW
		found.append(Opening.new(rect, kind, dice.randf()))
	return found


func _choose_entrance(p_inner: float, p_has_shop: bool) -> Array[Opening]:
	var found: Array[Opening] = []
	if p_has_shop:
		var wide: float = minf(2.8, p_inner * 0.42)
		var rect: Rect2 = Rect2(WALL_M + 0.5, GROUND_FLOOR_M, wide, 2.45)
		found.append(Opening.new(rect, Kind.SHOP, dice.randf()))
		found.append(_door(WALL_M + 0.9 + wide, Kind.DOOR))
		return found
	var at: float = WALL_M + 0.4 + dice.randf_range(0.2, 0.45) * p_inner
	found.append(_door(at, Kind.ARCH if dice.randf() < 0.3 else Kind.DOOR))
	var stairs_from: float = width - WALL_M - STAIRS_WIDTH_M - 0.2
	for x: float in [at - 1.75, at + 2.1, at + 3.9]:
		if x > WALL_M + 0.3 and x + 0.95 < stairs_from:
			found.append(Opening.new(Rect2(x, 1.0, 0.95, 1.25), Kind.WINDOW, dice.randf()))
	return found


func _door(p_x: float, p_kind: Kind) -> Opening:
	return Opening.new(Rect2(p_x, GROUND_FLOOR_M, 1.15, 2.2), p_kind, dice.randf())

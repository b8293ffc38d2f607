class_name TownWays
extends RefCounted
## Straight ways through the houses of a level that can be entered: through their doors, over their
## landings, through the rooms of each floor, up each flight of their stairs.

## What the ways are called, in the order in which they are walked. The people of one kind are there
## at once; their ways do not meet.
const KINDS: Array[String] = [
	"front_door", "back_door", "stairs", "landing_above", "landing_below", "rooms"
]
## So far out of a door and so far into a room people walk, m.
const OUT_M: float = 1.6
const IN_M: float = 1.5
## From a wall to the middle of somebody who stands before it, m.
const BESIDE_M: float = 0.5
## How far people walk sideways from a landing, beyond its edge, m.
const ASIDE_M: float = 1.2


## A straight way on which somebody walks.
class Way:
	extends RefCounted
	var kind: String = ""
	var name: String = ""
	## On the ground where it begins; it goes along +Z.
	var start: Transform3D = Transform3D.IDENTITY
	## Where it ends, on what people stand on there.
	var end: Vector3 = Vector3.ZERO
	## Along the ground, m.
	var length: float = 0.0


## The ways through all houses of a level that can be entered.
static func of(p_level: Level) -> Array[Way]:
	var ways: Array[Way] = []
	for house: House in houses_of(p_level):
		ways.append_array(of_house(house))
	return ways


## The houses that can be entered.
static func houses_of(p_level: Level) -> Array[House]:
	var houses: Array[House] = []
	for node: Node in p_level.static_root.find_children("*", "StaticBody3D", true, false):
		if node is House and (node as House).entered:
			houses.append(node)
	return houses


## The ways through a house.
static func of_house(p_house: House) -> Array[Way]:
	var plan: HousePlan = p_house.plan()
	var ways: Array[Way] = []
	var ground: float = HousePlan.GROUND_FLOOR_M
	var front: float = _door_middle(plan, HousePlan.Facade.FRONT)
	var outside: Vector3 = Vector3(front, 0.0, OUT_M)
	var inside: Vector3 = Vector3(front, ground, -HousePlan.WALL_M - IN_M)
	ways.append(_way(p_house, "front_door", "", outside, inside))
	var back: float = plan.width - _door_middle(plan, HousePlan.Facade.BACK)
	inside = Vector3(back, ground, HousePlan.WALL_M + IN_M - plan.depth)
	outside = Vector3(back, 0.0, -plan.depth - OUT_M)
	ways.append(_way(p_house, "back_door", "", inside, outside))
	if plan.has_stairs():
		for storey: int in plan.storeys:
			ways.append_array(_of_storey(p_house, plan, storey))
	return ways


static func _of_storey(p_house: House, p_plan: HousePlan, p_storey: int) -> Array[Way]:
	var stairs: Rect2 = p_plan.stairs_rect()
	var low: float = HousePlan.GROUND_FLOOR_M if p_storey == 0 else HousePlan.STOREY_M * p_storey
	var high: float = HousePlan.STOREY_M * (p_storey + 1)
	var middle: float = stairs.get_center().x
	var half: float = HousePlan.LANDING_M / 2.0
	var before: Vector3 = Vector3(middle, low, -stairs.end.y - half)
	var behind: Vector3 = Vector3(middle, high, half - stairs.position.y)
	var aside: Vector3 = Vector3.LEFT * (HousePlan.STAIRS_WIDTH_M / 2.0 + ASIDE_M)
	var number: String = " to floor %d" % (p_storey + 1)
	var ways: Array[Way] = [
		_way(p_house, "stairs", number, before, behind),
		_way(p_house, "landing_above", number, behind, behind + aside),
		_way(p_house, "landing_below", number, before + aside, before),
	]
	var door: float = HouseRooms.doorway_middle(p_plan)
	if door > 0.0:
		var near: Vector3 = Vector3(door, low, -HousePlan.WALL_M - BESIDE_M)
		var far: Vector3 = Vector3(door, low, HousePlan.WALL_M + BESIDE_M - p_plan.depth)
		ways.append(_way(p_house, "rooms", " of floor %d" % p_storey, near, far))
	return ways


## Where the middle of a door of the ground floor is along its wall, m.
static func _door_middle(p_plan: HousePlan, p_wall: HousePlan.Facade) -> float:
	for opening: HousePlan.Opening in p_plan.openings[0][p_wall]:
		if opening.kind in [HousePlan.Kind.DOOR, HousePlan.Kind.ARCH]:
			return opening.rect.get_center().x
	return p_plan.length_of(p_wall) / 2.0


## A way between two places in a house's frame.
static func _way(
	p_house: House, p_kind: String, p_name: String, p_from: Vector3, p_to: Vector3
) -> Way:
	var way: Way = Way.new()
	way.kind = p_kind
	way.name = "%s, %s%s" % [p_house.name, p_kind.replace("_", " "), p_name]
	var from: Vector3 = p_house.global_transform * p_from
	way.end = p_house.global_transform * p_to
	var along: Vector3 = Vector3(way.end.x - from.x, 0.0, way.end.z - from.z)
	way.length = along.length()
	way.start = Transform3D(Basis.looking_at(along, Vector3.UP, true), from)
	return way

class_name HouseDoors
extends RefCounted
## The doors that swing in the doorways of a [House] that can be entered: some stand wide open, some
## ajar, some are shut and wait to be pushed.

## How deep in the wall they hang, m.
const DEEP_M: float = 0.2
## What the frame takes of the opening at each side and above, m.
const FRAME_M: float = 0.065
## The widest angle at which some stand, degrees.
const OPEN_DEG: float = 80.0


## The doors of a house, each with its place and a name that is the same on all machines.
static func make(p_plan: HousePlan) -> Array[Door]:
	var made: Array[Door] = []
	for storey: int in p_plan.storeys:
		for wall: int in 4:
			var openings: Array[HousePlan.Opening] = p_plan.openings[storey][wall]
			for number: int in openings.size():
				var opening: HousePlan.Opening = openings[number]
				if opening.kind not in [HousePlan.Kind.DOOR, HousePlan.Kind.BALCONY]:
					continue
				var side: HousePlan.Facade = wall as HousePlan.Facade
				var corner: Vector3 = p_plan.corner_of(side, storey * HousePlan.STOREY_M)
				var door: Door = _hang(opening, corner, HousePlan.along(side))
				door.tint = p_plan.paint as SurfaceTints.Tint
				door.name = "Door%d%d%d" % [storey, wall, number]
				made.append(door)
	return made


static func _hang(p_opening: HousePlan.Opening, p_corner: Vector3, p_right: Vector3) -> Door:
	var door: Door = Door.new()
	var rect: Rect2 = p_opening.rect
	door.size = rect.size - Vector2(2.0 * FRAME_M, FRAME_M)
	door.right_hinge = fposmod(p_opening.chance * 7.0, 1.0) > 0.5
	if p_opening.chance < 0.45:
		door.ajar = OPEN_DEG
	elif p_opening.chance < 0.75:
		door.ajar = lerpf(20.0, 50.0, (p_opening.chance - 0.45) / 0.3)
	var out: Vector3 = p_right.cross(Vector3.UP)
	var x: float = rect.end.x - FRAME_M if door.right_hinge else rect.position.x + FRAME_M
	door.transform = Transform3D(
		Basis(p_right, Vector3.UP, out),
		p_corner + p_right * x + Vector3.UP * rect.position.y - out * DEEP_M
	)
	return door

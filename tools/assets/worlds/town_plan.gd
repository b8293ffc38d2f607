extends RefCounted
## Where everything in the town stands: rows of houses along a main street from south to north, two
## side streets, back streets, a market square, courtyards, gates.
##
## +Z is south, +X is east. The town reaches from -40 to 40 m in x and from -58 to 58 m in z.

const SEED: int = 11
## Half the width of the main street, m.
const STREET: float = 4.7
## Where side streets cross, z from and to, m.
const CROSSINGS: Array[Vector2] = [Vector2(18.0, 25.0), Vector2(-22.0, -15.5)]
## The market square, x and z, m.
const SQUARE: Rect2 = Rect2(-22.0, -15.5, 17.3, 19.0)
## How deep yards are, at most and at least, and how wide the passage behind them, m.
const YARD_M: float = 3.6
const YARD_MIN_M: float = 1.6
const PASSAGE_M: float = 1.6
## Every so manyth house is entered.
const ENTERED_EACH: int = 3

## How many houses there are, and how many are entered.
var houses: int = 0
var entered: int = 0
## Where people start.
var starts: Array[Transform3D] = []
## Where crates stand.
var crates: Array[Vector3] = []

var _dice: RandomNumberGenerator = RandomNumberGenerator.new()
var _root: Node3D = null
# Houses by their outlines on the ground, and what is behind some of them.
var _outlines: Array[Rect2] = []
var _yards: Array[Callable] = []


## Makes everything; returns the root.
func lay_out() -> Node3D:
	_dice.seed = SEED
	_root = Node3D.new()
	_root.name = "TownBlocks"
	_ground()
	# Along the main street, then back to back with them, then beyond the back streets.
	_row("West", Vector3(-STREET, 0.0, 55.0), Vector3.FORWARD, 110.0, Vector2(8.0, 10.5))
	_row("East", Vector3(STREET, 0.0, -55.0), Vector3.BACK, 110.0, Vector2(8.0, 10.5))
	_row("WestBack", Vector3(-25.0, 0.0, -55.0), Vector3.BACK, 110.0, Vector2(6.5, 8.6))
	_row("EastBack", Vector3(25.0, 0.0, 55.0), Vector3.FORWARD, 110.0, Vector2(6.5, 8.6))
	_row("WestOuter", Vector3(-29.6, 0.0, 52.0), Vector3.FORWARD, 104.0, Vector2(7.5, 10.0))
	_row("EastOuter", Vector3(29.6, 0.0, -52.0), Vector3.BACK, 104.0, Vector2(7.5, 10.0))
	for build: Callable in _yards:
		build.call()
	_landmarks()
	_market()
	_lamps_and_wires()
	_cover()
	_palms()
	for number: int in 8:
		var at: Vector3 = Vector3(-2.6 + 1.75 * (number % 4), 0.0, 40.5 + 3.0 * (number / 4))
		starts.append(Transform3D(Basis(Vector3.UP, PI), at))
	for number: int in 12:
		var x: float = -8.0 - 1.1 * (number % 4)
		crates.append(Vector3(x, 0.26 + 0.52 * (number / 8), -1.5 - 0.8 * (number / 4 % 2)))
	return _root


func _add(p_node: Node3D, p_name: String, p_place: Transform3D) -> void:
	p_node.name = p_name
	p_node.transform = p_place
	_root.add_child(p_node)


func _place(p_at: Vector3, p_turn: float = 0.0) -> Transform3D:
	return Transform3D(Basis(Vector3.UP, p_turn), p_at)


## Houses along a line; their x axis runs along it.
func _row(
	p_name: String, p_from: Vector3, p_way: Vector3, p_length: float, p_depths: Vector2
) -> void:
	var at: float = 0.0
	var basis: Basis = Basis(p_way, Vector3.UP, p_way.cross(Vector3.UP))
	var number: int = 0
	while at < p_length - 5.5:
		var width: float = [6.5, 7.5, 8.5, 9.5, 11.0][_dice.randi_range(0, 4)]
		var free: float = _free_from(p_from, p_way, at, width)
		if free >= 0.0 and free - at <= 5.6:
			at = _free_until(p_from, p_way, free)
			continue
		width = minf(width, free - at) if free >= 0.0 else width
		var house: House = _house(width, p_depths, number, p_from, free >= 0.0)
		var setback: float = [0.0, 0.0, 0.3, 0.6][_dice.randi_range(0, 3)]
		var place: Vector3 = p_from + p_way * at - basis.z * setback
		_add(house, "%s%d" % [p_name, number + 1], Transform3D(basis, place))
		_outlines.append(_outline(house, house.size.y))
		if house.entered and absf(p_from.x) < 6.0:
			_plan_courtyard(house, basis)
		number += 1
		at += house.size.x
		var gap: float = [0.0, 0.0, 0.0, 1.6, 2.4][_dice.randi_range(0, 4)]
		if gap > 0.0:
			_alley(house, basis, gap)
		at += gap


func _house(
	p_width: float, p_depths: Vector2, p_number: int, p_from: Vector3, p_is_cut: bool
) -> House:
	var width: float = p_width
	var depth: float = _dice.randf_range(p_depths.x, p_depths.y)
	var wants: bool = (p_number + houses) % ENTERED_EACH == 0
	if wants:
		depth = maxf(depth, HousePlan.MIN_DEPTH_M + 0.2)
		if absf(p_from.x) < 6.0:
			# Leaves room for the yard behind it.
			depth = HousePlan.MIN_DEPTH_M + 0.2
		width = width if p_is_cut else maxf(width, 7.0)
	var house: House = House.new()
	house.size = Vector2(snappedf(width, 0.1), snappedf(depth, 0.1))
	house.storeys = [1, 2, 2, 2, 3][_dice.randi_range(0, 4)]
	house.variant = _dice.randi_range(1, 9999)
	house.style = [0, 0, 1, 1, 2][_dice.randi_range(0, 4)] as House.Style
	house.tint = (SurfaceTints.Tint.CREAM + _dice.randi_range(0, 7)) as SurfaceTints.Tint
	if house.style == House.Style.BRICK:
		house.tint = SurfaceTints.Tint.PLAIN
	house.shop = absf(p_from.x) < 6.0 and _dice.randf() < 0.4
	house.entered = wants and house.plan().has_stairs()
	houses += 1
	entered += 1 if house.entered else 0
	return house


## Where a street or the square begins on which a house of a width would stand, along a row; -1 if
## there is none.
func _free_from(p_from: Vector3, p_way: Vector3, p_at: float, p_width: float) -> float:
	for step: int in int(p_width / 0.25) + 1:
		var at: float = p_at + step * 0.25
		if _is_free(p_from + p_way * at):
			return at
	return -1.0


## Where it ends.
func _free_until(p_from: Vector3, p_way: Vector3, p_at: float) -> float:
	var at: float = p_at
	while _is_free(p_from + p_way * at):
		at += 0.25
	return at


func _is_free(p_point: Vector3) -> bool:
	for crossing: Vector2 in CROSSINGS:
		if p_point.z > crossing.x and p_point.z < crossing.y:
			return true
	var is_west: bool = p_point.x < -1.0 and p_point.x > -26.0
	return is_west and p_point.z > SQUARE.position.y and p_point.z < SQUARE.end.y


## A rectangle behind a house's front, seen from above: x, z.
func _outline(p_house: House, p_deep: float, p_from: float = 0.0) -> Rect2:
	var near: Vector3 = p_house.transform * Vector3(0.0, 0.0, -p_from)
	var far: Vector3 = p_house.transform * Vector3(p_house.size.x, 0.0, -p_from - p_deep)
	return Rect2(near.x, near.z, far.x - near.x, far.z - near.z).abs()


## Chooses what is in the yard of a house. How deep it can be is known when all houses stand.
func _plan_courtyard(p_house: House, p_basis: Basis) -> void:
	var palm: Palm = null
	if _dice.randf() < 0.6:
		palm = Palm.new()
		palm.height = snappedf(_dice.randf_range(4.5, 6.5), 0.1)
		palm.variant = _dice.randi_range(1, 9999)
		palm.rotation.y = _dice.randf() * TAU
	_yards.append(_courtyard.bind(p_house, p_basis, palm))


## A yard behind a house, with a wall around it and a way out. Behind it there is a passage, as the
## houses there have back doors too.
func _courtyard(p_house: House, p_basis: Basis, p_palm: Palm) -> void:
	var deep: float = YARD_M
	while deep >= YARD_MIN_M and _is_built_on(_outline(p_house, deep + PASSAGE_M, p_house.size.y)):
		deep -= 0.1
	if deep < YARD_MIN_M:
		print("%s has no yard: there is no room behind it" % p_house.name)
		return
	deep = snappedf(deep, 0.1)
	var back: Vector3 = p_house.transform * Vector3(0.0, 0.0, -p_house.size.y)
	var wall: Wall = _wall(Vector3(p_house.size.x, 2.2, 0.25), p_house.tint)
	wall.openings = [Rect2(0.6, 0.0, 1.2, 2.05)]
	var far: Vector3 = back + p_basis * Vector3(p_house.size.x, 0.0, -deep)
	var turned: Basis = p_basis * Basis(Vector3.UP, PI)
	_add(wall, p_house.name + "Yard", Transform3D(turned, far))
	for side: int in 2:
		var x: float = p_house.size.x if side == 0 else 0.25
		var place: Transform3D = Transform3D(
			p_basis * Basis(Vector3.UP, PI / 2.0), back + p_basis * Vector3(x, 0.0, 0.0)
		)
		var end: Wall = _wall(Vector3(deep, 2.2, 0.25), p_house.tint)
		_add(end, "%sYardSide%d" % [p_house.name, side + 1], place)
	if p_palm != null:
		var middle: Vector3 = back + p_basis * Vector3(p_house.size.x * 0.6, 0.0, -deep * 0.6)
		_add(p_palm, p_house.name + "Palm", _place(middle, p_palm.rotation.y))
	var barrels: Barrels = Barrels.new()
	var corner: Vector3 = back + p_basis * Vector3(p_house.size.x - 1.2, 0.0, -1.2)
	_add(barrels, p_house.name + "Barrels", Transform3D(p_basis, corner))


func _is_built_on(p_rect: Rect2) -> bool:
	return _outlines.any(
		func(outline: Rect2) -> bool: return outline.grow(-0.05).intersects(p_rect)
	)


func _wall(p_size: Vector3, p_tint: SurfaceTints.Tint) -> Wall:
	var wall: Wall = Wall.new()
	wall.size = p_size
	wall.tint = p_tint
	return wall


## What is between two houses: an arch over the way through, or a wall across it.
func _alley(p_house: House, p_basis: Basis, p_gap: float) -> void:
	var at: Vector3 = p_house.transform * Vector3(p_house.size.x, 0.0, -0.2)
	if _dice.randf() < 0.5:
		var arch: Wall = _wall(Vector3(p_gap, 3.4, 0.4), p_house.tint)
		arch.openings = [Rect2(0.1, 0.0, p_gap - 0.2, 2.5)]
		_add(arch, p_house.name + "Arch", Transform3D(p_basis, at))
	else:
		var end: Wall = _wall(Vector3(p_gap, 2.3, 0.3), p_house.tint)
		var back: Vector3 = at + p_basis * Vector3(0.0, 0.0, -p_house.size.y * 0.6)
		_add(end, p_house.name + "End", Transform3D(p_basis, back))
	if p_gap > 2.0:
		var barrel: Barrels = Barrels.new()
		barrel.count = 1
		barrel.tint = SurfaceTints.Tint.DARK_GREEN
		var place: Vector3 = at + p_basis * Vector3(0.4, 0.0, -2.4)
		_add(barrel, p_house.name + "Barrel", Transform3D(p_basis, place))


func _ground() -> void:
	const TILE: float = 12.0
	for j: int in range(-6, 6):
		for i: int in range(-4, 4):
			var tile: Block = Block.new()
			tile.size = Vector3(TILE, 1.0, TILE)
			tile.surface = SurfaceLayers.Layer.DIRT
			var at: Vector3 = Vector3((i + 0.5) * TILE, -0.5, (j + 0.5) * TILE)
			_add(tile, "Ground%d_%d" % [i + 5, j + 7], _place(at))
	for j: int in range(-9, 9):
		var piece: Block = Block.new()
		piece.size = Vector3(6.4, 0.02, 6.7)
		piece.surface = SurfaceLayers.Layer.ASPHALT
		_add(piece, "Road%d" % (j + 10), _place(Vector3(0.0, 0.005, (j + 0.5) * 6.7)))


func _landmarks() -> void:
	for z: float in [-57.5, 58.5]:
		var gate: Gate = Gate.new()
		gate.width = 16.0
		_add(gate, "NorthGate" if z < 0.0 else "SouthGate", _place(Vector3(0.0, 0.0, z)))
	_add(Tower.new(), "Tower", _place(Vector3(-19.6, 0.0, -12.6)))


func _market() -> void:
	var cloths: Array[int] = [
		SurfaceTints.Tint.PLAIN, SurfaceTints.Tint.CLOTH_BLUE, SurfaceTints.Tint.CLOTH_OLIVE
	]
	for number: int in 7:
		var stall: Stall = Stall.new()
		stall.cloth = cloths[number % 3] as SurfaceTints.Tint
		stall.variant = number + 1
		var row: int = number / 4
		var x: float = -17.5 + 3.5 * (number % 4) + 1.2 * row
		var place: Transform3D = _place(Vector3(x, 0.0, -6.0 + 6.4 * row), PI * row)
		_add(stall, "Stall%d" % (number + 1), place)
	var stones: Rubble = Rubble.new()
	stones.radius = 1.2
	stones.stone = 0.35
	_add(stones, "Stones", _place(Vector3(-8.0, 0.0, -12.0)))


func _lamps_and_wires() -> void:
	var tops: Array[Vector3] = []
	for number: int in 8:
		var is_west: bool = number % 2 == 0
		var at: Vector3 = Vector3(-3.7 if is_west else 3.7, 0.0, 50.0 - 14.0 * number)
		_add(StreetLamp.new(), "Lamp%d" % (number + 1), _place(at, 0.0 if is_west else PI))
		tops.append(at + Vector3.UP * 5.9)
	for number: int in tops.size() - 1:
		for side: int in 2:
			var beside: Vector3 = Vector3(0.0, 0.0, -0.62 + 1.24 * side)
			var name: String = "Wire%d_%d" % [number + 1, side + 1]
			_wire(name, tops[number] + beside, tops[number + 1] + beside, 0.9, 0)
	for number: int in 5:
		var z: float = 44.0 - 21.0 * number
		var washing: int = 0 if number % 2 == 1 else 7
		var name: String = "Line%d" % (number + 1)
		_wire(name, Vector3(-4.6, 4.9, z), Vector3(4.6, 5.2, z - 2.0), 0.5, washing)
	for number: int in 6:
		var is_west: bool = number % 2 == 0
		var back: StreetLamp = StreetLamp.new()
		back.height = 4.6
		var at: Vector3 = Vector3(-28.6 if is_west else 28.6, 0.0, 42.0 - 16.0 * number)
		_add(back, "BackLamp%d" % (number + 1), _place(at, 0.0 if is_west else PI))
	for number: int in 2:
		var lamp: StreetLamp = StreetLamp.new()
		lamp.height = 4.4
		var at: Vector3 = Vector3(-13.0, 0.0, -9.5 + 12.1 * number)
		_add(lamp, "MarketLamp%d" % (number + 1), _place(at, PI / 2.0))


func _wire(p_name: String, p_from: Vector3, p_to: Vector3, p_sag: float, p_washing: int) -> void:
	var wire: Wire = Wire.new()
	wire.end = p_to - p_from
	wire.sag = p_sag
	wire.washing = p_washing
	_add(wire, p_name, _place(p_from))


## Walls, sandbags, barrels and rubble to take cover at.
func _cover() -> void:
	for number: int in 10:
		var side: float = -1.0 if number % 2 == 0 else 1.0
		var z: float = 47.0 - 10.4 * number
		var cover: Node3D = null
		match number % 4:
			0:
				cover = Sandbags.new()
			1:
				cover = Barrels.new()
				cover.set(&"count", 3)
				cover.set(&"tint", SurfaceTints.Tint.RED)
			2:
				cover = _wall(Vector3(2.6, 1.25, 0.35), SurfaceTints.Tint.CREAM)
				cover.set(&"ruin", 0.5)
			3:
				cover = Rubble.new()
				cover.set(&"surface", SurfaceLayers.Layer.CONCRETE)
		_add(cover, "Cover%d" % (number + 1), _place(Vector3(side * 2.6 - 0.8, 0.0, z)))
	for number: int in 4:
		var ruin: Wall = _wall(Vector3(5.0, 2.6, 0.35), SurfaceTints.Tint.PLAIN)
		ruin.ruin = 0.8
		ruin.surface = SurfaceLayers.Layer.BRICK
		var x: float = -34.0 if number % 2 == 0 else 31.0
		var at: Vector3 = Vector3(x, 0.0, 21.0 if number < 2 else -19.0)
		_add(ruin, "Ruin%d" % (number + 1), _place(at, 0.2 * number))


func _palms() -> void:
	var places: PackedVector2Array = [
		Vector2(-20.5, 1.4),
		Vector2(-6.4, 1.8),
		Vector2(-6.8, -13.8),
		Vector2(3.9, 23.0),
		Vector2(-3.9, -17.0),
		Vector2(34.0, 23.0),
		Vector2(-33.0, -17.5),
		Vector2(27.0, 20.5),
		Vector2(-27.0, 23.6),
		Vector2(9.5, -60.0),
		Vector2(-9.0, -61.0),
		Vector2(-10.0, 62.0),
		Vector2(11.0, 61.5),
		Vector2(13.5, 63.0),
		Vector2(42.0, -30.0),
		Vector2(-42.5, 12.0),
	]
	for number: int in places.size():
		var palm: Palm = Palm.new()
		palm.height = snappedf(_dice.randf_range(5.5, 8.8), 0.1)
		palm.lean = snappedf(_dice.randf_range(0.3, 1.2), 0.05)
		palm.variant = number + 1
		var at: Vector3 = Vector3(places[number].x, 0.0, places[number].y)
		_add(palm, "Palm%d" % (number + 1), _place(at, _dice.randf() * TAU))

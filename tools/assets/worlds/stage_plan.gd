extends RefCounted
## Where everything on the stage stands: a hall of 34 x 22 m whose length is along Z, the podium at
## its northern end (-Z), seats that rise towards the south, standing room and a barrier between
## them. East is +X.

const SIZE: Vector3 = Vector3(34.0, 8.4, 22.0)
## The podium: middle of its foot, and its size, m.
const PODIUM_AT: Vector3 = Vector3(0.0, 0.0, -10.6)
const PODIUM: Vector3 = Vector3(13.0, 1.15, 8.4)
## Foot of the first tier of seats, their depth and rise, m, and how many.
const TIERS_Z: float = 1.4
const TIER: Vector2 = Vector2(1.05, 0.26)
const TIERS: int = 9
## Height of trusses, m.
const HIGH: float = 7.3
const Lights: GDScript = preload("res://tools/assets/worlds/stage_light_plan.gd")

## Where people start: performers first, then the audience.
var starts: Array[Transform3D] = []
## Views for observers, by their titles.
var views: Dictionary[String, Transform3D] = {}
## Crates that performers push about.
var crates: Array[Transform3D] = []

var _root: Node3D = null
var _count: Dictionary[String, int] = {}


## Makes everything; returns the root.
func lay_out() -> Node3D:
	_root = Node3D.new()
	_shell()
	_podium()
	_cloths()
	_trusses()
	Lights.new(_put).hang(HIGH, PODIUM.y)
	_screen()
	_sound()
	_seats()
	_crew()
	Lights.new(_put).hang_house(HIGH)
	_outside()
	_people()
	return _root


func _add(p_node: KitBlock, p_at: Vector3, p_turn: float = 0.0, p_tilt: float = 0.0) -> void:
	var basis: Basis = Basis(Vector3.UP, deg_to_rad(p_turn)) * Basis(Vector3.RIGHT, p_tilt)
	_put(p_node, Transform3D(basis, p_at))


func _put(p_node: Node3D, p_place: Transform3D) -> void:
	var kind: String = (p_node.get_script() as GDScript).get_global_name()
	_count[kind] = _count.get(kind, 0) + 1
	p_node.name = "%s%d" % [kind, _count[kind]]
	p_node.transform = p_place
	_root.add_child(p_node)


## A hall of steel, its length turned to Z: its south is the world's east, its east the north.
func _shell() -> void:
	var hall: SteelHall = SteelHall.new()
	hall.size = SIZE
	hall.rise = 2.4
	hall.bays = 7
	hall.base = 1.6
	hall.has_skylights = false
	hall.outside = SurfaceTints.Tint.IRON
	hall.inside = SurfaceTints.Tint.SOOT
	hall.steel = SurfaceTints.Tint.BLACK
	var east: Array[Rect2] = [Rect2(25.4, 0.0, 1.2, 2.2)]
	var west: Array[Rect2] = [Rect2(7.6, 0.0, 1.2, 2.2)]
	for bay: int in range(1, 5):
		east.append(Rect2(1.2 + 4.86 * bay, 5.0, 2.8, 2.2))
		west.append(Rect2(SIZE.x - 4.0 - 4.86 * bay, 5.0, 2.8, 2.2))
	hall.south = east
	hall.north = west
	# Towards the audience's back: the entrance and a window over it.
	hall.west = [Rect2(9.3, 0.0, 3.4, 3.0), Rect2(6.0, 5.2, 10.0, 1.6)]
	_add(hall, Vector3.ZERO, 90.0)


func _podium() -> void:
	var podium: StagePodium = StagePodium.new()
	podium.size = PODIUM
	_add(podium, PODIUM_AT)
	for side: float in [-1.0, 1.0]:
		var steps: Stairs = Stairs.new()
		steps.steps = 7
		steps.rise = PODIUM.y / 7.0
		steps.going = 0.29
		steps.width = 1.5
		steps.landing = 0.0
		steps.surface = Steelwork.PAINT
		steps.tint = SurfaceTints.Tint.BLACK
		# Beside the podium, up towards its middle.
		_add(steps, Vector3(side * (PODIUM.x / 2.0 + 7.0 * 0.29), 0.0, -8.4), side * 90.0)
	# Marks of tape: the middle, and where nobody sees the edge in the light.
	_mark(Vector3(0.0, PODIUM.y, -9.6), Vector2(0.5, 0.05), SurfaceTints.Tint.WHITE)
	_mark(Vector3(0.0, PODIUM.y, -9.6), Vector2(0.05, 0.5), SurfaceTints.Tint.WHITE)
	_mark(Vector3(0.0, PODIUM.y, -6.62), Vector2(PODIUM.x - 0.2, 0.06), SurfaceTints.Tint.YELLOW)


func _mark(p_at: Vector3, p_size: Vector2, p_tint: SurfaceTints.Tint) -> void:
	var mark: FloorMarking = FloorMarking.new()
	mark.shape = FloorMarking.Shape.AREA
	mark.size = p_size
	mark.tint = p_tint
	_add(mark, p_at)


## The backdrop, legs in front of the wings, a border over the stage, walls behind them.
func _cloths() -> void:
	var back: Backdrop = Backdrop.new()
	back.picture = load("res://assets/world/backdrops/dunes.jpg")
	back.size = Vector2(12.4, 6.2)
	_add(back, Vector3(0.0, PODIUM.y, -14.35))
	for side: float in [-1.0, 1.0]:
		for row: int in 2:
			_curtain(
				Vector3(side * (6.4 + 0.2 * row), 0, -8.6 + 0.0) + Vector3(0, PODIUM.y, -2.3 * row),
				Vector2(1.7, 6.2),
				0.0
			)
		_curtain(
			Vector3(side * 9.0, 0.0, -6.3), Vector2(3.9, 7.4), 0.0, SurfaceTints.Tint.CLOTH_WINE
		)
		_curtain(Vector3(side * 9.5, 0.0, -14.6), Vector2(2.6, 7.2), 0.0)
	_curtain(Vector3(0.0, 6.5, -6.2), Vector2(15.0, 0.95), 0.0, SurfaceTints.Tint.CLOTH_WINE)
	_curtain(Vector3(0.0, 0.0, -16.72), Vector2(21.4, 7.6), 0.0)


func _curtain(
	p_at: Vector3,
	p_size: Vector2,
	p_turn: float,
	p_tint: SurfaceTints.Tint = SurfaceTints.Tint.BLACK
) -> void:
	var cloth: Curtain = Curtain.new()
	cloth.size = p_size
	cloth.tint = p_tint
	cloth.depth = 0.11 if p_tint == SurfaceTints.Tint.CLOTH_WINE else 0.08
	cloth.surface = SurfaceLayers.Layer.BURLAP
	if p_tint == SurfaceTints.Tint.CLOTH_WINE:
		cloth.surface = SurfaceLayers.Layer.PLASTER_PALE
	_add(cloth, p_at, p_turn)


func _trusses() -> void:
	for z: float in [-5.6, -9.2, -12.9, 0.6]:
		var truss: Truss = Truss.new()
		truss.length = 15.6
		_add(truss, Vector3(-7.8, HIGH, z))
	for side: float in [-1.0, 1.0]:
		var long: Truss = Truss.new()
		long.length = 13.5
		_add(long, Vector3(side * 7.97, HIGH, 0.6), 90.0)
		for z: float in [-5.6, -12.9]:
			var tower: Truss = Truss.new()
			tower.length = HIGH - 0.17
			var up: Basis = Basis(Vector3.BACK, PI / 2.0)
			_put(tower, Transform3D(up, Vector3(side * 7.97, 0.0, z)))


## The screen over the stage, and the camera at the desk that films for it.
func _screen() -> void:
	var film: FilmCamera = FilmCamera.new()
	film.focus = 11.0
	film.radius = 6.2
	film.fov = 30.0
	var at: Vector3 = Vector3(1.6, 2.5, 0.2)
	var middle: Vector3 = Vector3(0.0, PODIUM.y + 1.0, -10.2)
	_put(film, Transform3D(Basis.looking_at((middle - at).normalized()), at))
	film.focus = at.distance_to(middle)
	var screen: CameraScreen = CameraScreen.new()
	screen.size = Vector2(5.6, 3.15)
	_add(screen, Vector3(0.0, 5.45, -12.6))
	screen.camera = film


func _sound() -> void:
	for side: float in [-1.0, 1.0]:
		var array: Loudspeakers = Loudspeakers.new()
		array.count = 7
		_add(array, Vector3(side * 8.3, 6.6, -5.2), -side * 6.0)
		var subs: Loudspeakers = Loudspeakers.new()
		subs.is_standing = true
		subs.count = 3
		_add(subs, Vector3(side * 4.6, 0.0, -5.75), 0.0)
		var more: Loudspeakers = Loudspeakers.new()
		more.is_standing = true
		more.count = 3
		_add(more, Vector3(side * 3.45, 0.0, -5.75), 0.0)
	for x: float in [-3.0, 0.0, 3.0]:
		var monitor: Loudspeakers = Loudspeakers.new()
		monitor.is_standing = true
		monitor.count = 1
		_put(monitor, Transform3D(Basis(Vector3.UP, PI), Vector3(x, PODIUM.y, -7.35)))


## Tiers with seats on either side of a stairway, and a barrier before the stage.
func _seats() -> void:
	for tier: int in TIERS:
		var z: float = TIERS_Z + TIER.x * tier
		var y: float = TIER.y * (tier + 1)
		for side: float in [-1.0, 1.0]:
			_block(
				Vector3(side * 5.2, y / 2.0, z + TIER.x / 2.0),
				Vector3(8.8, y, TIER.x),
				SurfaceLayers.Layer.PAINTED_WOOD,
				SurfaceTints.Tint.IRON
			)
			var row: SeatRow = SeatRow.new()
			row.count = 14
			_add(row, Vector3(side * 5.05, y, z + 0.66))
	# The stairway between them: two steps a tier, which people climb.
	for step: int in TIERS * 2:
		var y: float = TIER.y / 2.0 * (step + 1)
		var z: float = TIERS_Z + TIER.x / 2.0 * step
		_block(
			Vector3(0.0, y / 2.0, z + TIER.x / 4.0),
			Vector3(1.6, y, TIER.x / 2.0),
			SurfaceLayers.Layer.CARPET,
			SurfaceTints.Tint.IRON
		)
	# Behind the last row, where the crew works, and its back wall of wood.
	var end: float = TIERS_Z + TIER.x * TIERS
	var top: float = TIER.y * TIERS
	_block(
		Vector3(0.0, top / 2.0, end + 1.1),
		Vector3(19.2, top, 2.2),
		SurfaceLayers.Layer.CARPET,
		SurfaceTints.Tint.IRON
	)
	for side: float in [-1.0, 1.0]:
		_rail(Vector3(side * 9.6, top, end + 2.1), -90.0 * side, 2.0)
	_rail(Vector3(-9.55, top, end + 2.15), 0.0, 19.1)
	var barrier: CrowdBarrier = CrowdBarrier.new()
	barrier.length = 14.0
	_add(barrier, Vector3(-7.0, 0.0, -3.9))


func _rail(p_at: Vector3, p_turn: float, p_length: float) -> void:
	var rail: CrowdBarrier = CrowdBarrier.new()
	rail.length = p_length
	_add(rail, p_at, p_turn)


func _block(
	p_at: Vector3, p_size: Vector3, p_surface: SurfaceLayers.Layer, p_tint: SurfaceTints.Tint
) -> void:
	var block: Block = Block.new()
	block.size = p_size
	block.surface = p_surface
	block.tint = p_tint
	_add(block, p_at)


## What stands about: desks of the crew, cases in the wings.
func _crew() -> void:
	var end: float = TIERS_Z + TIER.x * TIERS
	for x: float in [-3.2, 3.2]:
		var desk: MixingDesk = MixingDesk.new()
		desk.width = 2.4
		_add(desk, Vector3(x, TIER.y * TIERS, end + 0.5))
	for row: Array in [
		[Vector3(-9.4, 0.0, -11.2), Vector3(1.2, 0.8, 0.6), 12.0],
		[Vector3(-9.5, 0.8, -11.25), Vector3(1.0, 0.6, 0.55), 4.0],
		[Vector3(-9.3, 0.0, -12.6), Vector3(1.4, 1.3, 0.7), 84.0],
		[Vector3(9.5, 0.0, -12.4), Vector3(1.2, 0.8, 0.6), -8.0],
		[Vector3(9.4, 0.0, -11.3), Vector3(1.2, 1.2, 0.7), 3.0],
		[Vector3(9.6, 0.0, -10.2), Vector3(0.8, 0.7, 0.6), 30.0],
		[Vector3(-9.3, 0.0, 14.6), Vector3(1.4, 1.3, 0.7), 90.0],
	]:
		var case: FlightCase = FlightCase.new()
		case.size = row[1]
		_add(case, row[0], row[2])


## A forecourt and a fence around it.
func _outside() -> void:
	_block(
		Vector3(0.0, -0.15, 4.0),
		Vector3(34.0, 0.28, 50.0),
		SurfaceLayers.Layer.CONCRETE,
		SurfaceTints.Tint.PLAIN
	)
	_block(
		Vector3(0.0, -0.26, 4.0),
		Vector3(52.0, 0.4, 66.0),
		SurfaceLayers.Layer.DIRT,
		SurfaceTints.Tint.PLAIN
	)
	for row: Array in [
		[Vector3(-26.0, -0.1, -29.0), 0.0, 52.0],
		[Vector3(26.0, -0.1, -29.0), -90.0, 66.0],
		[Vector3(26.0, -0.1, 37.0), 180.0, 52.0],
		[Vector3(-26.0, -0.1, 37.0), 90.0, 66.0],
	]:
		var fence: SheetFence = SheetFence.new()
		fence.length = row[2]
		_add(fence, row[0], row[1])
	for x: float in [-5.0, 5.0]:
		var post: StreetLamp = StreetLamp.new()
		post.height = 4.5
		_add(post, Vector3(x, 0.0, 20.5))


## Performers on the podium, facing the audience; the audience before the stage, facing it.
func _people() -> void:
	var up: float = PODIUM.y
	for at: Vector3 in [
		Vector3(0.0, up, -9.6),
		Vector3(-3.0, up, -9.8),
		Vector3(3.0, up, -9.8),
		Vector3(-1.5, up, -12.0),
		Vector3(1.5, up, -12.0),
	]:
		starts.append(Transform3D(Basis.IDENTITY, at))
	for at: Vector3 in [
		Vector3(-4.6, 0.25, -12.6), Vector3(-4.0, 0.25, -12.4), Vector3(4.4, 0.25, -12.6)
	]:
		crates.append(Transform3D(Basis(Vector3.UP, at.x), at + Vector3.UP * up))
	for row: Array in [
		["Standing", Vector3(0.0, 1.75, -1.2), Vector3(0.0, 2.9, -10.0)],
		["Seats", Vector3(0.0, 4.3, 9.0), Vector3(0.0, 2.9, -8.0)],
		["Wing", Vector3(-8.6, 2.7, -12.3), Vector3(1.0, 1.8, -8.0)],
		["Performer", Vector3(0.0, 2.9, -12.2), Vector3(0.0, 2.0, 6.0)],
	]:
		var eye: Vector3 = row[1]
		var away: Vector3 = ((row[2] as Vector3) - eye).normalized()
		views[row[0]] = Transform3D(Basis.looking_at(away), eye)
	var around: Basis = Basis(Vector3.UP, PI)
	for row: int in 2:
		for number: int in 5:
			var at: Vector3 = Vector3(-5.0 + 2.5 * number, 0.0, -2.6 + 2.5 * row)
			starts.append(Transform3D(around, at))

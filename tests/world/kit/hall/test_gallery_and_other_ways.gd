extends TestCase
## A person walks through the gate, up the ramp, up the stairs onto the gallery and into an open
## container, and nowhere else.

const PersonWalk: GDScript = preload("res://tests/world/kit/person_walk.gd")
var _root: Node3D = null


func before_each() -> void:
	_root = Node3D.new()
	add_child(_root)


func after_each() -> void:
	_root.free()


func test_a_person_walks_up_the_ramp() -> void:
	var ramp: Ramp = Ramp.new()
	ramp.size = Vector3(1.6, 1.2, 7.2)
	await _stand([ramp], [Vector3.ZERO])
	equal(_walk([Vector3(0.0, 0.0, 0.6), Vector3(0.0, 0.0, -0.2), Vector3(0.0, 1.2, -7.1)]), "")
	contains(_walk([Vector3(-2.0, 0.0, -6.0), Vector3(0.0, 0.0, -6.0)]), "stopped")


func test_a_person_walks_up_the_stairs_onto_the_gallery() -> void:
	var gallery: Gallery = Gallery.new()
	gallery.size = Vector3(6.0, 3.06, 2.0)
	gallery.front = [Vector2(1.0, 2.2)]
	var stairs: SteelStairs = SteelStairs.new()
	stairs.steps = 18
	await _stand([gallery, stairs], [Vector3.ZERO, Vector3(1.6, 0.0, 18 * 0.28)])
	var foot: Vector3 = Vector3(1.6, 0.0, 18 * 0.28)
	var way: Array[Vector3] = [
		foot + Vector3.BACK, foot, Vector3(1.6, 3.06, 0.0), Vector3(1.6, 3.06, -1.0)
	]
	equal(_walk(way), "")
	equal(_walk([Vector3(1.6, 3.06, -1.0), Vector3(5.5, 3.06, -1.0)]), "")
	contains(_walk([Vector3(5.0, 3.06, -1.0), Vector3(5.0, 3.06, 0.6)]), "stopped")
	contains(_walk([Vector3(5.0, 3.06, -1.0), Vector3(6.6, 3.06, -1.0)]), "stopped")


func test_a_person_walks_into_an_open_container_only() -> void:
	for is_open: bool in [true, false]:
		var container: ShippingContainer = ShippingContainer.new()
		container.is_open = is_open
		await _stand([container], [Vector3.ZERO])
		var found: String = _walk([Vector3(4.5, 0.0, 0.0), Vector3(-2.4, 0.0, 0.0)])
		equal(found == "", is_open, found)
		contains(_walk([Vector3(0.0, 0.0, 3.0), Vector3(0.0, 0.0, 0.0)]), "stopped")
		container.free()


func test_gate_and_door_are_open_windows_and_walls_are_not() -> void:
	var hall: SteelHall = SteelHall.new()
	hall.south = [Rect2(8.2, 0.0, 4.0, 4.0), Rect2(2.2, 0.0, 1.1, 2.1), Rect2(15.0, 0.9, 3.0, 1.5)]
	await _stand([hall], [Vector3.ZERO])
	for x: float in [0.0, -9.0, -3.0, -7.45, 6.3]:
		var found: String = _walk([Vector3(x, 0.0, 5.0), Vector3(x, 0.0, 6.8)])
		equal(found == "", x == 0.0 or x == -7.45, "at x = %.1f: %s" % [x, found])


func test_a_hall_keeps_rain_and_people_in() -> void:
	var hall: SteelHall = SteelHall.new()
	await _stand([hall], [Vector3.ZERO])
	for x: float in [-9.5, -4.0, 0.0, 4.3, 9.5]:
		for z: float in [-5.6, -2.0, 0.0, 2.7, 5.6]:
			var up: Dictionary = _ray(Vector3(x, 3.0, z), Vector3(x, 30.0, z))
			is_false(up.is_empty(), "the roof is open over %.1f, %.1f" % [x, z])
	for turn: int in 64:
		var way: Vector3 = Vector3.BACK.rotated(Vector3.UP, TAU * turn / 64.0)
		for y: float in [0.5, 3.0, 5.3]:
			var from: Vector3 = Vector3.UP * y
			is_false(_ray(from, from + way * 40.0).is_empty(), "%d at %.1f m" % [turn, y])


func _stand(p_blocks: Array[KitBlock], p_places: Array[Vector3]) -> void:
	for index: int in p_blocks.size():
		p_blocks[index].position = p_places[index]
		_root.add_child(p_blocks[index])
	await physics_frames(2)


func _ray(p_from: Vector3, p_to: Vector3) -> Dictionary:
	var query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(p_from, p_to)
	return _root.get_world_3d().direct_space_state.intersect_ray(query)


## Moves a person's shape along a way, on the ground that is there; says where it was stopped.
func _walk(p_way: Array[Vector3]) -> String:
	var needs_ground: Callable = func(_p_feet: Vector3) -> bool: return false
	return PersonWalk.walk(_root, p_way, needs_ground)

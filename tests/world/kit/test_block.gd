extends TestCase
## Blocks and stairs: meshes and shapes of the stated sizes, warnings, saving.


func test_block_has_its_size() -> void:
	for size: Vector3 in [Vector3.ONE, Vector3(24.0, 0.5, 3.0)]:
		var block: Block = Block.new()
		block.size = size
		add_child(block)
		_check_boxes(block, [[Vector3.ZERO, size]])
		block.free()


func test_block_changes_its_size() -> void:
	var block: Block = Block.new()
	add_child(block)
	block.size = Vector3(1.0, 2.0, 3.0)
	_check_boxes(block, [[Vector3.ZERO, Vector3(1.0, 2.0, 3.0)]])
	block.size = Vector3(-5.0, 0.0, 3.0)
	equal(block.size, Vector3(0.01, 0.01, 3.0))
	block.free()


func test_block_shows_its_material() -> void:
	var block: Block = Block.new()
	add_child(block)
	block.material = StandardMaterial3D.new()
	var mesh: MeshInstance3D = _children(block, "MeshInstance3D")[0]
	equal(mesh.get_active_material(0), block.material)
	block.free()


func test_own_children_stay_and_are_saved_but_the_made_ones_are_not() -> void:
	var block: Block = Block.new()
	var lamp: Node3D = Node3D.new()
	lamp.name = "Lamp"
	block.add_child(lamp)
	lamp.owner = block
	add_child(block)
	block.size = Vector3.ONE * 2.0
	equal(block.get_children(), [lamp] as Array[Node])
	var scene: PackedScene = PackedScene.new()
	equal(scene.pack(block), OK)
	var copy: Block = scene.instantiate()
	equal(copy.get_child_count(true), 1)
	equal(copy.size, Vector3.ONE * 2.0)
	add_child(copy)
	_check_boxes(copy, [[Vector3.ZERO, Vector3.ONE * 2.0]])
	copy.free()
	block.free()


func test_children_added_by_code_survive() -> void:
	var block: Block = Block.new()
	add_child(block)
	var lamp: Node3D = Node3D.new()
	block.add_child(lamp)
	block.size = Vector3.ONE * 2.0
	is_true(is_instance_valid(lamp), "a light that a script has put on the block is gone")
	block.free()


func test_scaled_bodies_warn() -> void:
	for body: StaticBody3D in [Block.new(), Stairs.new()]:
		equal(body._get_configuration_warnings().size(), 0)
		body.scale = Vector3(1.0, 2.0, 1.0)
		equal(body._get_configuration_warnings().size(), 1)
		contains(body._get_configuration_warnings()[0], "set the scale to 1")
		body.free()


func test_stairs_have_their_steps() -> void:
	var stairs: Stairs = Stairs.new()
	stairs.steps = 3
	stairs.rise = 0.2
	stairs.going = 0.25
	stairs.width = 1.5
	stairs.landing = 1.0
	add_child(stairs)
	_check_boxes(
		stairs,
		[
			[Vector3(0.0, 0.1, -0.125), Vector3(1.5, 0.2, 0.25)],
			[Vector3(0.0, 0.2, -0.375), Vector3(1.5, 0.4, 0.25)],
			[Vector3(0.0, 0.3, -1.125), Vector3(1.5, 0.6, 1.25)],
		]
	)
	stairs.steps = 1
	stairs.landing = 0.0
	_check_boxes(stairs, [[Vector3(0.0, 0.1, -0.125), Vector3(1.5, 0.2, 0.25)]])
	stairs.free()


func test_stairs_stand_on_the_ground_without_gaps() -> void:
	var stairs: Stairs = Stairs.new()
	add_child(stairs)
	var front: float = 0.0
	for child: Node in _children(stairs, "CollisionShape3D"):
		var shape: CollisionShape3D = child
		var size: Vector3 = (shape.shape as BoxShape3D).size
		almost_equal(shape.position.y - size.y / 2.0, 0.0, 1e-5)
		almost_equal(shape.position.z + size.z / 2.0, front, 1e-5)
		front = shape.position.z - size.z / 2.0
	almost_equal(front, -(stairs.steps * stairs.going + stairs.landing), 1e-4)
	stairs.free()


func test_stairs_that_nobody_can_walk_warn() -> void:
	var stairs: Stairs = Stairs.new()
	equal(stairs._get_configuration_warnings().size(), 0)
	stairs.rise = 0.4
	contains(stairs._get_configuration_warnings()[0], "0.6 to 0.65 m; here it is 1.09 m")
	stairs.free()


func test_bad_sizes_are_put_right() -> void:
	var stairs: Stairs = Stairs.new()
	add_child(stairs)
	for field: String in ["steps", "rise", "going", "width", "landing"]:
		stairs.set(field, -3)
		is_true(stairs.get(field) >= 0, field)
	is_true(stairs.steps >= 1 and stairs.rise > 0.0 and stairs.going > 0.0 and stairs.width > 0.0)
	stairs.free()


## Checks the solid boxes of a body, and that its faces are theirs.
func _check_boxes(p_body: KitBlock, p_boxes: Array) -> void:
	var shapes: Array[Node] = _children(p_body, "CollisionShape3D")
	equal(shapes.size(), p_boxes.size())
	if shapes.size() != p_boxes.size():
		return
	var whole: AABB = AABB(p_boxes[0][0], Vector3.ZERO)
	for i: int in p_boxes.size():
		var shape: CollisionShape3D = shapes[i]
		almost_equal(shape.position, p_boxes[i][0], 1e-5)
		almost_equal((shape.shape as BoxShape3D).size, p_boxes[i][1], 1e-5)
		whole = whole.merge(AABB(p_boxes[i][0] - p_boxes[i][1] / 2.0, p_boxes[i][1]))
	var mesh: BlockMesh = KitBlock.make_mesh(false)
	p_body.build(mesh, KitBlock.OUTSIDE)
	var seen: AABB = AABB(mesh.get_points()[0], Vector3.ZERO)
	for point: Vector3 in mesh.get_points():
		seen = seen.expand(point)
	almost_equal(seen.position, whole.position, 1e-5)
	almost_equal(seen.size, whole.size, 1e-5)


func _children(p_node: Node, p_class: String) -> Array[Node]:
	return p_node.get_children(true).filter(
		func(child: Node) -> bool: return child.is_class(p_class)
	)

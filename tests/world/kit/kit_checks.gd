class_name KitChecks
extends RefCounted
## What holds of every block of the level kit: what the tests of its kinds share.

## Blocks are smaller, m.
const LARGEST_M: float = 60.0


## All faces and boxes of a block.
static func mesh_of(p_block: KitBlock) -> BlockMesh:
	var mesh: BlockMesh = KitBlock.make_mesh(false)
	p_block.build(mesh, KitBlock.OUTSIDE)
	return mesh


## Its faces are where they can be, and it has no warnings as it comes.
static func check_sound(p_test: TestCase, p_block: KitBlock, p_mesh: BlockMesh) -> void:
	var name: String = p_block.get_script().get_global_name()
	for point: Vector3 in p_mesh.get_points():
		if not point.is_finite() or point.length() > LARGEST_M:
			p_test.fail("%s has a point at %s" % [name, point])
			break
	p_test.equal(p_block._get_configuration_warnings(), PackedStringArray(), name)


## Blocks leave a mesh's place as it was. They are freed.
static func check_place(p_test: TestCase, p_blocks: Array[KitBlock]) -> void:
	var place: Transform3D = Transform3D(Basis(Vector3.UP, 0.7), Vector3(3.0, 1.0, -2.0))
	for block: KitBlock in p_blocks:
		var mesh: BlockMesh = KitBlock.make_mesh(false)
		mesh.set_place(place)
		block.build(mesh, KitBlock.OUTSIDE)
		p_test.almost_equal(mesh.get_place().origin, place.origin, 1e-4)
		p_test.almost_equal(mesh.get_place().basis.x, place.basis.x, 1e-4)
		block.free()


## A server has the boxes that clients see, and no faces. The blocks are freed.
static func check_boxes(p_test: TestCase, p_blocks: Array[KitBlock]) -> void:
	for block: KitBlock in p_blocks:
		var seen: BlockMesh = mesh_of(block)
		var solid: BlockMesh = KitBlock.make_mesh(true)
		block.build(solid, KitBlock.OUTSIDE)
		p_test.equal(solid.get_vertex_count(), 0)
		p_test.equal(solid.get_solid_count(), seen.get_solid_count())
		for index: int in solid.get_solid_count():
			var place: Transform3D = seen.get_solid_place(index)
			if not solid.get_solid_place(index).is_equal_approx(place):
				p_test.fail("box %d of %s" % [index, block.get_script().get_global_name()])
				break
		block.free()

class_name BenchBodies
extends RefCounted
## Bodies that play motions in benchmarks: the soldier, and that which a motion file describes.


## The soldier, not yet in the tree.
static func soldier(p_root: RagdollMotor.RootMode = RagdollMotor.ROOT_SOFT) -> Ragdoll:
	var ragdoll: Ragdoll = (load(Bench.SOLDIER) as PackedScene).instantiate()
	ragdoll.root_mode = p_root
	return ragdoll


## A body of the measures of a motion file's skeleton, not yet in the tree; without a profile and
## bones if the skeleton describes none.
static func of_clip(
	p_source: BvhSource, p_root: RagdollMotor.RootMode = RagdollMotor.ROOT_SOFT
) -> Ragdoll:
	var ragdoll: Ragdoll = Ragdoll.new()
	var skeleton: Skeleton3D = BvhSkeleton.make(p_source.rig)
	ragdoll.add_child(skeleton)
	ragdoll.profile = SkeletonShapes.describe(skeleton)
	if ragdoll.profile != null:
		RagdollBuilder.build(skeleton, ragdoll.profile)
	ragdoll.root_mode = p_root
	return ragdoll


## A collision shape for a body.
static func collision(p_shape: Shape3D) -> CollisionShape3D:
	var node: CollisionShape3D = CollisionShape3D.new()
	node.shape = p_shape
	return node


## A box as a collision shape.
static func box(p_size: Vector3) -> CollisionShape3D:
	var shape: BoxShape3D = BoxShape3D.new()
	shape.size = p_size
	return collision(shape)


## A ball as a collision shape.
static func ball(p_radius: float) -> CollisionShape3D:
	var shape: SphereShape3D = SphereShape3D.new()
	shape.radius = p_radius
	return collision(shape)


## Level ground whose top is at height 0.
static func ground(p_edge: float = 60.0) -> Block:
	var block: Block = Block.new()
	block.size = Vector3(p_edge, 1.0, p_edge)
	block.position.y = -0.5
	return block

extends RefCounted
## Walks a shape of a person's size over what blocks make solid: where does it go, where is it
## stopped?

## What a person takes, m.
const RADIUS: float = 0.28
const HEIGHT: float = 1.8
## A step that a person takes without noticing, m.
const STEP: float = 0.2


## Moves the shape along points on the ground, over steps. Returns where it is stopped, or where a
## point that needs ground has none, by [param p_needs_ground]; an empty text if it arrives.
static func walk(p_node: Node3D, p_way: Array[Vector3], p_needs_ground: Callable) -> String:
	var capsule: CapsuleShape3D = CapsuleShape3D.new()
	capsule.radius = RADIUS
	capsule.height = HEIGHT - STEP
	var query: PhysicsShapeQueryParameters3D = PhysicsShapeQueryParameters3D.new()
	query.shape = capsule
	# Doors are pushed open.
	query.collision_mask = PhysicsLayers.STATIC
	var space: PhysicsDirectSpaceState3D = p_node.get_world_3d().direct_space_state
	for leg: int in p_way.size() - 1:
		var count: int = maxi(2, int(p_way[leg].distance_to(p_way[leg + 1]) / 0.1))
		for step: int in count + 1:
			var feet: Vector3 = p_way[leg].lerp(p_way[leg + 1], float(step) / count)
			var down: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
				feet + Vector3.UP * 0.6, feet + Vector3.DOWN * 0.6
			)
			var ground: Dictionary = space.intersect_ray(down)
			if ground.is_empty() and p_needs_ground.call(feet):
				return "no ground at %s" % feet
			feet.y = (ground["position"] as Vector3).y if not ground.is_empty() else feet.y
			query.transform.origin = feet + Vector3.UP * (STEP + 0.03 + capsule.height / 2.0)
			if not space.intersect_shape(query, 1).is_empty():
				return "stopped at %s" % feet
	return ""

extends RefCounted
## The fixed path along which a world is looked at, and what is drawn on it.

## Eyes are so high above what they stand on, m.
const EYE_M: float = 1.7
## Where it leads, x and z, m.
const PATHS: Dictionary[String, PackedVector2Array] = {
	"town": [Vector2(0.0, 58.0), Vector2(0.0, -58.0)],
	"hangar": [Vector2(0.0, 24.0), Vector2(0.0, 2.0), Vector2(14.0, -4.0), Vector2(-14.0, -4.0)],
	"desert":
	[Vector2(-120.0, 90.0), Vector2(0.0, 60.0), Vector2(60.0, -40.0), Vector2(150.0, 0.0)],
	"yard": [Vector2(-9.0, 9.0), Vector2(9.0, 9.0), Vector2(9.0, -9.0)],
	"hall": [Vector2(-6.0, 5.0), Vector2(6.0, 5.0), Vector2(0.0, -5.0)],
	"stage": [Vector2(-6.0, 14.0), Vector2(0.0, 8.0), Vector2(6.0, 4.0)],
}

## The level.
var level: Level = null
## The eye.
var camera: Camera3D = null


func _init(p_level: Level, p_camera: Camera3D) -> void:
	level = p_level
	camera = p_camera


## Looks from a place of the path, 0 to 1, forwards and to both sides in turn.
func look(p_world: String, p_share: float) -> void:
	var path: PackedVector2Array = PATHS.get(p_world, PATHS["hall"])
	var along: float = p_share * (path.size() - 1)
	var part: int = mini(int(along), path.size() - 2)
	var flat: Vector2 = path[part].lerp(path[part + 1], along - part)
	var way: Vector2 = (path[part + 1] - path[part]).normalized().rotated(
		0.9 * sin(TAU * 2.0 * p_share)
	)
	var at: Vector3 = Vector3(flat.x, 0.0, flat.y)
	at.y = ground(at + Vector3.UP * (3.0 if p_world != "desert" else 60.0)) + EYE_M
	camera.look_at_from_position(at, at + Vector3(way.x, 0.02, way.y))


## Shows what the camera sees, with the sets or without; returns after a frame was drawn.
func draw(p_has_sets: bool) -> void:
	var visibility: LevelVisibility = level.visibility
	if visibility != null:
		visibility.is_active = p_has_sets
		visibility.look_from([level.to_local(camera.global_position)])
	# The engine's numbers are those of the frame before.
	await level.get_tree().process_frame
	await RenderingServer.frame_post_draw


## Draw calls and thousands of primitives of the last frame.
func counts() -> Array[float]:
	return [
		RenderingServer.get_rendering_info(
			RenderingServer.RENDERING_INFO_TOTAL_DRAW_CALLS_IN_FRAME
		),
		(
			RenderingServer.get_rendering_info(
				RenderingServer.RENDERING_INFO_TOTAL_PRIMITIVES_IN_FRAME
			)
			/ 1000.0
		),
	]


## Height of what lies below a place, m.
func ground(p_from: Vector3) -> float:
	var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		p_from, p_from + Vector3.DOWN * 120.0
	)
	var hit: Dictionary = camera.get_world_3d().direct_space_state.intersect_ray(ray)
	return (hit["position"] as Vector3).y if not hit.is_empty() else 0.0

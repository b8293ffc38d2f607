@tool
class_name KitMarks
extends KitRows
## The rows of [LevelKit] for what is not seen in the game: where people start, zones, paths, views.


func rows() -> Array[KitClass]:
	return [
		_film_camera(),
		(
			KitClass
			. scripted("SpawnPoint", "Marker3D", _path(SpawnPoint), {"avatar": PropertyRule.text()})
			. at_most(500)
		),
		(
			KitClass
			. scripted(
				"TriggerZone",
				"Area3D",
				_path(TriggerZone),
				{
					"title": PropertyRule.text(),
					"form": PropertyRule.whole(0, TriggerZone.Form.size() - 1),
					"size": PropertyRule.vector3(TriggerZone.MIN_M, 500.0),
					"notices": PropertyRule.whole(0, 3),
					"is_told": PropertyRule.flag(),
					# What the editor writes of the engine's own properties.
					"collision_layer": PropertyRule.whole(0, 0),
					"collision_mask": PropertyRule.whole(0, PhysicsLayers.ALL),
					"monitorable": PropertyRule.flag(),
				}
			)
			. with_bodies(1)
			. at_most(200)
		),
		(
			KitClass
			. scripted(
				"WaypointPath",
				"Node3D",
				_path(WaypointPath),
				{
					"points": PropertyRule.points(WaypointPath.MAX_POINTS),
					"is_closed": PropertyRule.flag(),
				}
			)
			. at_most(500)
		),
		(
			KitClass
			. scripted(
				"ObserverCamera",
				"Camera3D",
				_path(ObserverCamera),
				{
					"title": PropertyRule.text(),
					"fov": PropertyRule.number(1.0, 179.0),
					"near": PropertyRule.number(0.001, 10.0),
					"far": PropertyRule.number(0.01, 8000.0),
				}
			)
			. at_most(32)
		),
	]


func items() -> Array[KitItem]:
	var root: int = KitItem.Place.ROOT
	return [
		KitItem.new("Film camera", "screen view", _path(FilmCamera), KitItem.Place.STATIC, {}, 1.6),
		KitItem.new("Spawn point", "start person", _path(SpawnPoint), KitItem.Place.SPAWNS),
		KitItem.new("Trigger zone", "area event mark", _path(TriggerZone), root),
		KitItem.new("Waypoint path", "points way route", _path(WaypointPath), root),
		KitItem.new("Observer view", "camera", _path(ObserverCamera), root, {}, 2.5),
	]


static func _film_camera() -> KitClass:
	return (
		KitClass
		. scripted(
			"FilmCamera",
			"Marker3D",
			_path(FilmCamera),
			{
				"fov": PropertyRule.number(5.0, 75.0),
				"focus": PropertyRule.number(1.0, 100.0),
				"is_following": PropertyRule.flag(),
				"radius": PropertyRule.number(0.5, 100.0),
				"height": PropertyRule.number(0.2, 20.0),
				"frame": PropertyRule.number(0.3, 10.0),
				"easing": PropertyRule.number(0.05, 5.0),
			}
		)
		. at_most(16)
	)

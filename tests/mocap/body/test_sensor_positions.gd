extends TestCase
## Where sensors sit, and how joints lie to them.


func test_sides_mirror_each_other() -> void:
	var places: SensorPositions = SensorPositions.new(BodySize.new())
	for mount: int in BodyMounts.COUNT:
		var other: int = BodyMounts.MIRRORS[mount]
		var mirrored: Vector3 = places.places[other] * Vector3(-1.0, 1.0, 1.0)
		almost_equal(places.places[mount].distance_to(mirrored), 0.0, 0.001)


func test_sensors_sit_on_the_limbs_of_people_of_any_size() -> void:
	for height: float in [1.2, 1.75, 2.1]:
		var size: BodySize = BodySize.of_height(height)
		var places: SensorPositions = SensorPositions.new(size)
		for mount: int in BodyMounts.COUNT:
			var away: float = places.places[mount].distance_to(places.joints[mount])
			var most: float = size.limb_length(BodyMounts.LIMBS[mount]) + 0.12
			is_true(away < most, "%s: %f m" % [BodyMounts.NAMES[mount], away])
			is_true(places.places[mount].y > 0.0, "%s is in the floor" % BodyMounts.NAMES[mount])


func test_they_are_about_where_a_made_up_wearer_has_them() -> void:
	var places: SensorPositions = SensorPositions.new(BodySize.new())
	for mount: int in range(1, BodyMounts.COUNT):
		var above: int = BodyMounts.PARENTS[mount]
		var wanted: Vector3 = WornSensorFeed.OFFSETS[mount] - WornSensorFeed.SITS[above]
		var found: Vector3 = places.joints[mount] - places.places[above]
		is_true(found.distance_to(wanted) < 0.12, "%s: %s, not %s" % [mount, found, wanted])

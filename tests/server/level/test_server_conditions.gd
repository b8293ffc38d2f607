extends TestCase
## Time of day and weather that options and instructors set, over changes of level.

var _level: ServerLevel = null


func before_each() -> void:
	_level = ServerLevel.new()
	add_child(_level)
	_level.entity_added.connect(
		func(row: EntityRow, node: Entity, _body: PhysicsBody3D) -> void:
			if node != null:
				node.start(LocalSession.Host.new(), row.id, row.values)
	)


func after_each() -> void:
	_level.free()


func test_wrong_options_are_named() -> void:
	equal(ServerConditions.new(_level).error, "")
	equal(ServerConditions.new(_level, "18:30", "rain").error, "")
	contains(ServerConditions.new(_level, "noonish").error, "--time=noonish")
	contains(ServerConditions.new(_level, "", "snow").error, "--weather=snow")


func test_what_was_set_outlives_a_change_of_level() -> void:
	var conditions: ServerConditions = ServerConditions.new(_level, "6.5")
	equal(_level.load_level("desert"), "")
	conditions.apply()
	almost_equal(_level.level.world.get_value(WorldConditions.TIME), 6.5, 0.006)
	equal(conditions.change({WorldConditions.WEATHER: 2.0}), "")
	equal(_level.level.world.get_value(WorldConditions.WEATHER), 2.0)
	equal(_level.load_level("hall"), "")
	conditions.apply()
	contains(conditions.change({WorldConditions.WEATHER: 1.0}), "'hall' has no weather")
	contains(conditions.change({}), "understood")
	equal(_level.load_level("desert"), "")
	conditions.apply()
	equal(_level.level.world.get_value(WorldConditions.WEATHER), 2.0)

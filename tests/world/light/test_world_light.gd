extends TestCase
## The one place that says how strong a world's light is.

var _before: PackedVector3Array = []


func before_each() -> void:
	_before = WorldLight.strengths.duplicate()


func after_each() -> void:
	WorldLight.set_strengths(_before)


func test_a_change_is_noticed_and_the_same_again_is_not() -> void:
	var version: int = WorldLight.version
	var dusk: PackedVector3Array = []
	dusk.resize(5)
	dusk[WorldLight.Source.EVENING] = Vector3.ONE
	WorldLight.set_strengths(dusk)
	equal(WorldLight.version, version + 1)
	equal(WorldLight.strengths, dusk)
	WorldLight.set_strengths(dusk)
	equal(WorldLight.version, version + 1)


func test_strengths_for_fewer_sources_are_left_out() -> void:
	WorldLight.set_strengths([Vector3.ONE])
	equal(WorldLight.strengths, _before)

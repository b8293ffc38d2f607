extends TestCase
## The physics world fades in and out when it is said to.


func test_it_fades_in_and_out() -> void:
	var fade: PhysicsFade = PhysicsFade.new()
	equal(fade.set_from_text("2,5"), "")
	is_false(fade.is_due(1.9))
	is_true(fade.is_due(2.0))
	almost_equal(fade.opacity_at(2.0), 0.0)
	almost_equal(fade.opacity_at(2.0 + 0.5 * PhysicsFade.DURATION_S), 0.5)
	almost_equal(fade.opacity_at(4.0), 1.0)
	almost_equal(fade.opacity_at(5.0 + 0.5 * PhysicsFade.DURATION_S), 0.5)
	almost_equal(fade.opacity_at(60.0), 0.0)
	fade.end()
	is_false(fade.is_due(60.0))


func test_without_times_there_is_no_fade() -> void:
	var fade: PhysicsFade = PhysicsFade.new()
	equal(fade.set_from_text(""), "")
	is_false(fade.is_due(100.0))


func test_what_is_no_pair_of_times_is_refused() -> void:
	for text: String in ["2", "5,2", "-1,2", "a,b", "1,2,3", "nan,3", "1,inf"]:
		contains(PhysicsFade.new().set_from_text(text), "--physics-at", text)

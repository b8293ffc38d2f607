extends TestCase
## The dark edge while the wearer is moved.

var _vignette: Vignette = null


func before_each() -> void:
	_vignette = Vignette.new()


func after_each() -> void:
	_vignette.free()


func test_it_comes_with_motion_and_goes_with_it() -> void:
	is_false(_vignette.visible)
	for i: int in 60:
		_vignette.advance(3.0, 0.0, 0.016)
	almost_equal(_vignette.amount(), 0.5, 1e-4)
	is_true(_vignette.visible)
	for i: int in 60:
		_vignette.advance(0.0, 0.0, 0.016)
	is_false(_vignette.visible)


func test_turning_darkens_as_well_and_no_strength_never() -> void:
	_vignette.advance(0.0, -2.0, 1.0)
	is_true(_vignette.amount() > 0.4)
	_vignette.strength = 0.0
	_vignette.advance(10.0, 9.0, 10.0)
	equal(_vignette.amount(), 0.0)


func test_speeds_that_are_none_do_no_harm() -> void:
	_vignette.advance(NAN, INF, 0.1)
	is_true(is_finite(_vignette.amount()))

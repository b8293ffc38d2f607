extends TestCase
## Weighted least squares in few unknowns.


func test_weights_and_covariance() -> void:
	var equations: NormalEquations = NormalEquations.new(2)
	equations.add([1.0, 0.0], 2.0, 1.0)
	equations.add([1.0, 0.0], 5.0, 0.5)
	equations.add([1.0, 1.0], 1.0, 0.1)
	var covariance: PackedFloat64Array = equations.covariance()
	var found: PackedFloat64Array = equations.solution(covariance)
	almost_equal(found[0], 4.0)
	almost_equal(found[1], -3.0)
	almost_equal(covariance[0], 1.0 / 3.0)
	almost_equal(covariance[3], 1.0 / 3.0 + 0.1)


func test_what_nothing_tells() -> void:
	var equations: NormalEquations = NormalEquations.new(2)
	equations.add([1.0, 1.0], 2.0, 1.0)
	equal(equations.covariance()[3], INF)

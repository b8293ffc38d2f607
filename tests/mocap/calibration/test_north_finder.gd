extends TestCase
## Headings are taken as common as far as they agree, and as they are as far as they do not, without
## a threshold between.

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 13


func test_never_worse_than_either_at_any_spread() -> void:
	for spread_deg: float in [0.0, 5.0, 10.0, 20.0, 40.0, 60.0]:
		var found: float = 0.0
		var each: float = 0.0
		var common: float = 0.0
		for _round: int in 40:
			var truth: PackedFloat64Array = []
			var measured: PackedFloat64Array = []
			for _sensor: int in 17:
				truth.append(2.5 + deg_to_rad(_random.randfn() * spread_deg))
				measured.append(truth[-1] + deg_to_rad(_random.randfn() * 4.0))
			var norths: NorthFinder = _find(measured, 4.0)
			var middle: float = NorthFinder.middle(Array(measured))
			for sensor: int in 17:
				found += absf(angle_difference(norths.headings[sensor], truth[sensor]))
				each += absf(angle_difference(measured[sensor], truth[sensor]))
				common += absf(angle_difference(middle, truth[sensor]))
		var off_deg: float = rad_to_deg(found - minf(each, common)) / (40 * 17)
		is_true(off_deg < 0.3, "spread %f deg: worse by %f deg" % [spread_deg, off_deg])


func test_any_norths_at_all() -> void:
	var measured: PackedFloat64Array = []
	for _sensor: int in 17:
		measured.append(_random.randf_range(-PI, PI))
	var norths: NorthFinder = _find(measured, 1.0)
	for sensor: int in 17:
		var off: float = angle_difference(norths.headings[sensor], measured[sensor])
		almost_equal(rad_to_deg(off), 0.0, 0.1)


func test_what_is_not_measured_is_as_uncertain_as_the_others_are_apart() -> void:
	for spread_deg: float in [0.0, 20.0]:
		var measured: PackedFloat64Array = []
		for sensor: int in 17:
			measured.append(1.0 + deg_to_rad(spread_deg) * (sensor % 3 - 1))
		var norths: NorthFinder = _find(measured, 1.0, [4])
		var deviation: float = rad_to_deg(norths.deviation(4))
		is_true(deviation < 3.0 if spread_deg == 0.0 else deviation > 10.0, "%f" % deviation)
		almost_equal(rad_to_deg(angle_difference(norths.headings[4], 1.0)), 0.0, 4.0)


func _find(
	p_measured: PackedFloat64Array, p_error_deg: float, p_unknown: Array = []
) -> NorthFinder:
	var variances: PackedFloat64Array = []
	for sensor: int in p_measured.size():
		variances.append(INF if p_unknown.has(sensor) else deg_to_rad(p_error_deg) ** 2)
	var norths: NorthFinder = NorthFinder.new(p_measured, variances)
	var zeros: PackedFloat64Array = []
	zeros.resize(p_measured.size())
	norths.suppose(zeros, zeros, NorthFinder.COMMON, true)
	norths.find()
	return norths

extends TestCase
## Impacts as bytes: what comes back, and what is refused.


func test_impacts_come_back() -> void:
	var sent: Array[Impact] = []
	for index: int in ImpactMessage.MAX_COUNT:
		sent.append(
			_make(Vector3(-1000.5, 0.25, 123.0 * index), 0.02 * pow(3.0, index), index * 0.5)
		)
	var got: Array[Impact] = ImpactMessage.decode(ImpactMessage.encode(70000, sent))
	equal(got.size(), sent.size())
	for index: int in got.size():
		equal(got[index].tick, 70000)
		equal([got[index].entity, got[index].other], [1030, Impact.NO_ENTITY])
		equal([got[index].material, got[index].other_material], [9, 14])
		almost_equal(got[index].place, sent[index].place, 0.006)
		var most: float = minf(sent[index].impulse, 24940.0)
		almost_equal(got[index].impulse / most, 1.0, 0.035, "%f" % sent[index].impulse)
		almost_equal(got[index].slip, sent[index].slip, 0.04)
		equal(got[index].is_scrape(), sent[index].is_scrape())


func test_a_slow_scrape_stays_one() -> void:
	var sent: Array[Impact] = [_make(Vector3.ZERO, 1.0, 0.001)]
	is_true(ImpactMessage.decode(ImpactMessage.encode(1, sent))[0].is_scrape())


func test_more_than_fit_are_left_out() -> void:
	var sent: Array[Impact] = []
	for _index: int in 40:
		sent.append(_make(Vector3.ZERO, 1.0, 0.0))
	var bytes: PackedByteArray = ImpactMessage.encode(1, sent)
	is_true(bytes.size() < Protocol.MAX_DATAGRAM)
	equal(ImpactMessage.decode(bytes).size(), ImpactMessage.MAX_COUNT)


func test_what_is_broken_is_refused_and_nothing_is_out_of_bounds() -> void:
	var sent: Array[Impact] = [_make(Vector3.ONE, 1.0, 0.0), _make(Vector3.ONE, 1.0, 2.0)]
	var good: PackedByteArray = ImpactMessage.encode(9, sent)
	for size: int in good.size():
		equal(ImpactMessage.decode(good.slice(0, size)).size(), 0)
	equal(ImpactMessage.decode(good + PackedByteArray([0])).size(), 0)
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = 17
	for _try: int in 10000:
		var bytes: PackedByteArray = good.duplicate()
		for _change: int in dice.randi_range(1, 6):
			bytes[dice.randi_range(1, bytes.size() - 1)] = dice.randi_range(0, 255)
		for impact: Impact in ImpactMessage.decode(bytes):
			if not (impact.place.is_finite() and impact.impulse < 3e4 and impact.slip <= 16.0):
				fail("%s becomes %s" % [bytes.hex_encode(), impact.place])
				return
			not_null(ContactMaterial.numbered(impact.material))
	is_true(true)


func _make(p_place: Vector3, p_impulse: float, p_slip: float) -> Impact:
	var impact: Impact = Impact.new()
	impact.entity = 1030
	impact.place = p_place
	impact.impulse = p_impulse
	impact.slip = p_slip
	impact.material = 9
	impact.other_material = 14
	return impact

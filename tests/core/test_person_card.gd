extends TestCase
## Sizes of people as a server may be told them.


func test_a_size_that_is_none_does_not_cost_the_body() -> void:
	var card: PersonCard = PersonCard.new()
	var lengths: PackedFloat32Array = []
	lengths.resize(Limbs.COUNT)
	lengths.fill(0.3)
	lengths[2] = 0.001
	lengths[3] = NAN
	lengths[4] = 40.0
	card.take_size(NAN, lengths)
	equal(card.find_fault(), "")
	equal(card.lengths[2], 0.0)
	almost_equal(card.lengths[5], 0.3)
	for hips: float in [-1.0, 0.2, 2.0, INF, 1e9]:
		card.take_size(hips, lengths)
		equal(card.find_fault(), "", "hips %f" % hips)


func test_a_size_changes_when_it_is_measured() -> void:
	var before: PersonCard = PersonCard.new()
	var after: PersonCard = PersonCard.new()
	before.take_size(0.95, PackedFloat32Array())
	after.take_size(0.955, PackedFloat32Array())
	is_false(after.is_resized(before, 0.01), "half a centimetre is the same person")
	after.take_size(1.02, PackedFloat32Array())
	is_true(after.is_resized(before, 0.01), "7 cm are another size")
	var lengths: PackedFloat32Array = []
	lengths.resize(Limbs.COUNT)
	before.take_size(1.02, lengths)
	is_true(after.is_resized(before, 0.01), "lengths are known now")
	lengths[4] = 0.31
	after.take_size(1.02, lengths)
	is_true(after.is_resized(before, 0.01), "an arm is known now")

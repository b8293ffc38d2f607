extends TestCase
## What clients of a load run have been told, compared with each other.


func test_the_same_and_something_else() -> void:
	var agreement: LoadAgreement = LoadAgreement.new()
	agreement.take(8, 0, 111)
	equal(agreement.compared, 0, "one alone")
	agreement.take(8, 0, 111)
	agreement.take(8, 1, 222)
	equal(agreement.compared, 1)
	equal(agreement.different, 0)
	agreement.take(8, 0, 112)
	equal(agreement.compared, 2)
	equal(agreement.different, 1)
	agreement.restart()
	equal(agreement.compared + agreement.different, 0)


func test_what_is_long_ago_is_not_compared() -> void:
	var agreement: LoadAgreement = LoadAgreement.new()
	agreement.take(8, 0, 1)
	agreement.take(8 + LoadAgreement.KEPT, 0, 2)
	agreement.take(8, 0, 3)
	equal(agreement.compared, 0)
	agreement.take(8 + LoadAgreement.KEPT, 0, 2)
	equal(agreement.compared, 1)
	equal(agreement.different, 0)


func test_each_person_has_its_turn() -> void:
	var agreement: LoadAgreement = LoadAgreement.new()
	for person: int in 10:
		var wanted: int = 0
		for tick: int in 80:
			wanted += 1 if agreement.wants(tick, person) else 0
		equal(wanted, 80 / LoadAgreement.EVERY)

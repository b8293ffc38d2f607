extends TestCase
## How many parts of work a tick takes, by what such parts took before.


func test_the_first_part_of_a_tick_always_fits() -> void:
	var budget: WorkBudget = WorkBudget.new()
	for _number: int in 3:
		budget.begin()
		is_true(budget.allows(&"long"))
		budget.note(&"long", 20 * WorkBudget.USEC)
		is_false(budget.allows(&"long"))
		is_false(budget.allows(&"unknown"))
		budget.end()
	equal(budget.time.count(), 3)


func test_steady_parts_fill_a_tick() -> void:
	var budget: WorkBudget = WorkBudget.new()
	budget.begin()
	var count: int = 0
	while budget.allows(&"short"):
		budget.note(&"short", 100)
		count += 1
	equal(count, WorkBudget.USEC / 100)


func test_parts_that_vary_leave_room_for_the_longer_ones() -> void:
	var budget: WorkBudget = WorkBudget.new()
	for number: int in 100:
		budget.begin()
		budget.note(&"uneven", 50 if number % 2 == 0 else 250)
	budget.begin()
	budget.note(&"first", WorkBudget.USEC - 200)
	is_false(budget.allows(&"uneven"), "150 on average, but often more")

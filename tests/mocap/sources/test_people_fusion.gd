extends TestCase
## Who of several sources is one of the people, and who completes the first.

var _fusion: PeopleFusion = null
var _came: Array[MotionSource] = []
var _gone: Array[MotionSource] = []


func before_each() -> void:
	_came.clear()
	_gone.clear()
	_fusion = PeopleFusion.new()
	_fusion.count = 3
	_fusion.appeared.connect(func(one: MotionSource, _name: String) -> void: _came.append(one))
	_fusion.vanished.connect(_gone.append)


func test_without_choices_everybody_is_one_of_the_people() -> void:
	var sources: Array[MotionSource] = [MotionSource.new(), MotionSource.new()]
	for number: int in 2:
		_fusion.appear(sources[number], "", number + 1)
	equal(_came, sources)
	_fusion.vanish(sources[0])
	equal(_gone.size(), 1)


func test_a_completing_source_may_come_first_and_go_first() -> void:
	equal(_fusion.read("feet:2"), "")
	var suit: MotionSource = MotionSource.new()
	var feet: MotionSource = MotionSource.new()
	var third: MotionSource = MotionSource.new()
	_fusion.appear(feet, "", 2)
	equal(_came.size(), 0)
	_fusion.appear(suit, "Eve", 1)
	_fusion.appear(third, "", 3)
	equal(_came.size(), 2)
	equal(_fusion.fusion.first(), suit)
	equal(_fusion.fusion.list_sources(), PackedInt32Array([2]))
	equal(_fusion.find_person(1), "Eve")
	_fusion.vanish(feet)
	equal(_fusion.fusion.list_sources().size(), 0)
	_fusion.vanish(suit)
	equal(_gone.size(), 1)
	is_null(_fusion.fusion)


func test_a_choice_at_the_panel_joins_and_is_taken_back() -> void:
	var suit: MotionSource = MotionSource.new()
	var head: MotionSource = MotionSource.new()
	_fusion.appear(suit, "", 1)
	_fusion.appear(head, "", 2)
	equal(_fusion.choose(LimbFusion.Group.HEAD, 2), "")
	not_null(_fusion.fusion)
	equal(_gone.size(), 2, "both come anew")
	equal(_came.size(), 3)
	equal(_fusion.fusion.list_sources(), PackedInt32Array([2]))
	equal(_fusion.choose(LimbFusion.Group.HEAD, 1), "")
	equal(_fusion.choice(LimbFusion.Group.HEAD), 1)
	is_null(_fusion.fusion, "given back: it is somebody again")
	equal(_came[-1], head)
	contains(_fusion.choose(LimbFusion.Group.HEAD, 4), "1 to 3")
	contains(_fusion.read("head:4"), "source 4")


func test_a_walker_carries_the_first_one_s_person_and_is_nobody() -> void:
	_fusion.walker = 2
	equal(_fusion.read("legs:2"), "")
	for group: LimbFusion.Group in PeopleFusion.WALKED:
		equal(_fusion.choice(group), 2, "feet and root come along")
	var suit: MotionSource = MotionSource.new()
	var walker: MotionSource = MotionSource.new()
	var second: MotionSource = MotionSource.new()
	_fusion.appear(walker, "", 2)
	equal(_came.size(), 0)
	_fusion.appear(suit, "Eve", 1)
	_fusion.appear(second, "Bob", 1)
	equal(_came, [suit, second] as Array[MotionSource])
	equal([_fusion.carries(suit), _fusion.carries(second)], [true, false])
	_fusion.vanish(suit)
	is_false(_fusion.carries(suit))


func test_a_walker_that_comes_first_is_told_to_come_second() -> void:
	_fusion.walker = 1
	for text: String in ["legs:2", "arms:2", "head:2,arms:3"]:
		contains(_fusion.read(text), "--source=xr --source=walker --fuse=legs:2")
	contains(_fusion.choose(LimbFusion.Group.HEAD, 2), "source 1 walks")
	equal(_fusion.choose(LimbFusion.Group.HEAD, 1), "")


func test_a_walker_and_limbs_of_others_at_the_panel() -> void:
	_fusion.walker = 3
	var sources: Array[MotionSource] = []
	for number: int in 3:
		sources.append(MotionSource.new())
		_fusion.appear(sources[number], "", number + 1)
	equal(_fusion.choose(LimbFusion.Group.LEGS, 3), "")
	is_null(_fusion.fusion)
	is_true(_fusion.carries(sources[0]))
	equal(_came.slice(3), sources.slice(0, 2))
	equal(_fusion.choose(LimbFusion.Group.HEAD, 2), "")
	not_null(_fusion.fusion)
	equal(_fusion.fusion.list_sources(), PackedInt32Array([2]))
	is_true(_fusion.carries(_fusion.fusion))
	contains(_fusion.choose(LimbFusion.Group.ARMS, 3), "legs, feet and root")
	_came.clear()
	equal(_fusion.choose(LimbFusion.Group.FEET, 1), "")
	is_false(_fusion.is_carried())
	equal(_fusion.choice(LimbFusion.Group.ROOT), 1, "all of it is given back")
	equal(_came[-1], sources[2], "who walks is somebody again")
	contains(_fusion.read("trunk:3"), "source 3 walks")

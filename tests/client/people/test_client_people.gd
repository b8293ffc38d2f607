extends TestCase
## Those whose motion a client sends: a server gets to know them, however they come and go.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")

var _pair: LinkPair = null
var _end: LinkPair.End = null
var _people: ClientPeople = null
var _told: Array[Array] = []


func before_each() -> void:
	_told.clear()
	_pair = LinkPair.new()
	_pair.server.people_declared.connect(
		func(_session: int, cards: Array[PersonCard]) -> void: _told.append(cards)
	)
	_pair.listen()
	_end = LinkPair.End.new()
	_end.request.role = Roles.Role.TRAINEE
	_pair.ends.append(_end)
	_people = ClientPeople.new(_end.link, ProgramOptions.parse([]))
	_end.link.joined.connect(_people.begin)


func after_each() -> void:
	_people.stop()
	_pair.close()


func test_people_who_are_there_before_the_server_is_reached() -> void:
	var ada: MotionSource = _add("Ada")
	_add("Bob")
	_join()
	_await_names(["Ada", "Bob"])
	_people.remove(ada)
	_await_names(["Bob"])
	equal([_people.count(), _people.source_of(0)], [1, null])
	_add("Cid")
	_await_names(["Bob", "Cid"])
	equal(_told[-1].map(func(card: PersonCard) -> int: return card.index), [1, 0])


func test_their_samples_come_under_their_numbers() -> void:
	_add("Ada")
	_add("Bob")
	_join()
	_await_names(["Ada", "Bob"])
	var seen: Dictionary[int, bool] = {}
	var both: Callable = func() -> bool:
		for sample: PoseSample in _pair.poses.get(_end.link.session, []):
			seen[sample.person] = true
		return seen.size() == 2
	is_true(_pair.until(both))
	equal(seen.keys().min(), 0)
	equal(seen.keys().max(), 1)


func test_one_too_many_is_refused() -> void:
	for number: int in PersonCard.MAX_PEOPLE:
		is_true(_people.add(MotionSource.new(), "P%d" % number))
	is_false(_people.add(MotionSource.new(), "late"))
	equal(_people.count(), PersonCard.MAX_PEOPLE)
	_join()
	is_true(_pair.until(func() -> bool: return _told.size() > 0))
	equal(_told[-1].size(), PersonCard.MAX_PEOPLE)


func test_a_lost_connection_tells_them_again() -> void:
	_add("Ada")
	_join()
	_await_names(["Ada"])
	_end.cut()
	is_true(_pair.until(func() -> bool: return _pair.lost.size() == 1 and _end.loss != ""))
	_add("Bob")
	_end.link.open("127.0.0.1", _pair.port, _end.request)
	_await_names(["Ada", "Bob"])
	equal([_pair.returned.size(), _pair.left.size()], [1, 0])


func test_a_body_that_has_grown_is_reported() -> void:
	var suit: SuitSource = SuitSource.new(WornSensorFeed.new())
	_people.add(suit, "Ada")
	_join()
	_await_names(["Ada"])
	var before: float = (_told[-1][0] as PersonCard).hip_height
	suit.set_body(BodySize.of_hip_height(before + 0.1))
	_people.measure(suit)
	var taller: Callable = func() -> bool:
		return absf((_told[-1][0] as PersonCard).hip_height - before - 0.1) < 0.001
	is_true(_pair.until(taller))


func test_each_is_published_to_other_programs_scenes() -> void:
	var ada: MotionSource = _add("Ada")
	var tracker: StringName = TrackerPublisher.name_for(0)
	var published: Callable = func() -> bool:
		_people.take_samples()
		var found: XRBodyTracker = XRServer.get_tracker(tracker)
		return found != null and found.has_tracking_data
	is_true(_pair.until(published))
	_people.remove(ada)
	is_null(XRServer.get_tracker(tracker))


func test_stats_name_people_and_sources() -> void:
	_add("Ada")
	equal(_people.stats()[0]["name"], "Ada")
	contains(_people.stats()[0]["source"], "01_01.bvh")
	_people.stop()
	equal([_people.count(), _people.stats()], [0, [] as Array[Dictionary]])


func _add(p_name: String) -> MotionSource:
	var source: BvhSource = BvhSource.new()
	source.open("res://assets/motion/01_01.bvh")
	is_true(_people.add(source, p_name))
	return source


func _join() -> void:
	_end.link.open("127.0.0.1", _pair.port, _end.request)
	is_true(_pair.until(func() -> bool: return _end.joined == 1))


func _await_names(p_names: Array) -> void:
	var found: Callable = func() -> bool:
		if _told.is_empty():
			return false
		var names: Array = _told[-1].map(func(card: PersonCard) -> String: return card.name)
		names.sort()
		return names == p_names
	is_true(_pair.until(found), str(p_names))

extends TestCase
## A client's own gait: read, sent in a session, once, and anew where it must be.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")
const MadeSets: GDScript = preload("res://tests/walker/made_sets.gd")
const FRAME_S: float = 1.0 / 60.0
const PATH: String = "user://test_own.motionset"

var _pair: LinkPair = null
var _sets: WalkerSets = null
var _own: OwnMotionSet = null
var _end: LinkPair.End = null
var _walks: bool = true


func before_each() -> void:
	_walks = true
	_pair = LinkPair.new()
	_sets = WalkerSets.new(_pair.server)
	_own = OwnMotionSet.new()
	equal(_pair.listen(), OK)
	_pair.on_poll = func() -> void:
		_sets.advance()
		_own.advance(FRAME_S, _walks)


func after_each() -> void:
	_sets.close()
	_pair.on_poll = Callable()
	_pair.close()
	DirAccess.remove_absolute(PATH)


func goes_by_clock() -> bool:
	return true


func test_it_is_sent_as_soon_as_the_user_walks_and_only_once() -> void:
	_walks = false
	_begin(MadeSets.small())
	_pair.run(0.2)
	equal(_own.state, OwnMotionSet.State.WAITS)
	_walks = true
	is_true(_until(OwnMotionSet.State.TAKEN))
	equal(_sets.of_session(_end.link.session).id, _own.own.id)
	equal(_own.report(), {"id": _own.own.id, "state": "TAKEN"})
	_return()
	_pair.run(0.3)
	equal([_sets.taken, _own.state], [1, OwnMotionSet.State.TAKEN])


func test_what_was_not_answered_is_sent_again() -> void:
	_begin(MadeSets.small())
	is_true(_until(OwnMotionSet.State.SENT))
	_return()
	is_true(_until(OwnMotionSet.State.TAKEN))
	equal(_sets.taken, 1)


func test_another_session_gets_it_too() -> void:
	_begin(MadeSets.small())
	is_true(_until(OwnMotionSet.State.TAKEN))
	var first: int = _end.link.session
	_end.link.leave()
	is_true(_pair.until(func() -> bool: return _pair.left.has(first)))
	_end.link.open("127.0.0.1", _pair.port, _end.request)
	is_true(_pair.until(func() -> bool: return _sets.taken == 2))
	is_true(_until(OwnMotionSet.State.TAKEN))
	is_true(_sets.of_session(_end.link.session) != null)


func test_it_is_sent_at_an_even_pace() -> void:
	var bytes: PackedByteArray = MadeSets.large(200000)
	_begin(bytes)
	is_true(_until(OwnMotionSet.State.SENT))
	var frames: int = 0
	while _own.state == OwnMotionSet.State.SENT and frames < 10000:
		frames += 1
		_pair.poll()
		OS.delay_usec(500)
	equal(_own.state, OwnMotionSet.State.TAKEN)
	# Each frame counts as 1/60 s, however fast they come.
	var parts: int = MotionSetMessage.split(bytes, 1).size()
	is_true(parts > 100 and frames >= parts * 60.0 / OwnMotionSet.PARTS_PER_S - 4.0)


func test_what_a_server_refuses_is_not_sent_again() -> void:
	_begin(MadeSets.small())
	while _pair.server.rates.take(&"motion-set", 1, Time.get_ticks_usec() / 1e6):
		pass
	is_true(_until(OwnMotionSet.State.REFUSED))
	_return()
	_pair.run(0.2)
	equal([_own.state, _sets.refused], [OwnMotionSet.State.REFUSED, 1])


func test_files_that_are_none() -> void:
	var link: ClientLink = ClientLink.new()
	equal(
		OwnMotionSet.new().open(link, "user://none.motionset"),
		"--motion-set: cannot read user://none.motionset: File not found"
	)
	contains(_open(MadeSets.of(["stand"])), PATH + ": it lacks walking ahead")
	contains(_open(MadeSets.small().slice(0, 5000)), PATH + ": the motion set ends within clip")
	contains(_open("a text, by mistake".to_utf8_buffer()), PATH + ": this is no motion set")
	var large: PackedByteArray = []
	large.resize(MotionSetMessage.MAX_BYTES + 1)
	contains(_open(large), PATH + ": it is larger than 1.6 MB")
	contains(OwnMotionSet.new().open(ClientLink.new(), "/proc"), "--motion-set: cannot read /proc")


func test_nobody_has_one_unless_it_is_named() -> void:
	equal(OwnMotionSet.new().open(ClientLink.new(), ""), "")
	_end = _pair.add(Roles.Role.TRAINEE)
	equal(_own.open(_end.link, ""), "")
	_pair.await_join(_end)
	_pair.run(0.1)
	equal([_own.state, _own.report(), _sets.refused], [OwnMotionSet.State.NONE, {}, 0])


func _begin(p_bytes: PackedByteArray) -> void:
	_write(p_bytes)
	_end = _pair.add(Roles.Role.TRAINEE)
	equal(_own.open(_end.link, PATH), "")
	_pair.await_join(_end)


func _return() -> void:
	var session: int = _end.link.session
	_pair.returned.clear()
	_end.cut()
	is_true(_pair.until(func() -> bool: return _pair.lost.has(session)))
	_end.link.open("127.0.0.1", _pair.port, _end.request)
	is_true(_pair.until(func() -> bool: return _pair.returned.has(session)))


func _until(p_state: OwnMotionSet.State) -> bool:
	return _pair.until(func() -> bool: return _own.state == p_state)


func _open(p_bytes: PackedByteArray) -> String:
	_write(p_bytes)
	return OwnMotionSet.new().open(ClientLink.new(), PATH)


func _write(p_bytes: PackedByteArray) -> void:
	var file: FileAccess = FileAccess.open(PATH, FileAccess.WRITE)
	file.store_buffer(p_bytes)
	file.close()

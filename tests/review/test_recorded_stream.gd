extends TestCase
## What was recorded is played back the same; damaged files play as far as they go.

const NetSamples: GDScript = preload("../net/net_samples.gd")
const SnapshotStream: GDScript = preload("res://tests/wire/snapshot_stream.gd")
const PATH: String = "user://test_recorded_stream.dsmt"

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _packets: Array[PackedByteArray] = []
var _played: Array[PackedByteArray] = []
var _finished: int = 0
var _stream: SnapshotStream = SnapshotStream.new([1, 2], [3, 4, 5])


func before_each() -> void:
	_random.seed = 1
	_packets.clear()
	_played.clear()
	_finished = 0


func after_each() -> void:
	if FileAccess.file_exists(PATH):
		DirAccess.remove_absolute(PATH)


func test_round_trip() -> void:
	_record(50)
	var player: RecordedStream = _player()
	equal(player.open(), "")
	# Changes of the world are spread over frames.
	for _frame: int in 10:
		player.advance(1e6)
	equal(_played, _packets)
	equal(_finished, 1)
	player.advance(2e6)
	equal([_played.size(), _finished], [50, 1], "it ends once")


func test_the_recorder_notes_the_times() -> void:
	var recorder: StateRecorder = StateRecorder.new()
	var began: int = Time.get_ticks_usec()
	equal(recorder.open(PATH), "")
	var opened: int = Time.get_ticks_usec()
	var before: Array[int] = []
	var behind: Array[int] = []
	for step: int in 5:
		before.append(Time.get_ticks_usec())
		recorder.add(_packet(step))
		behind.append(Time.get_ticks_usec())
		OS.delay_msec(10)
	recorder.close()
	var file: PackedByteArray = FileAccess.get_file_as_bytes(PATH)
	var heads: Array[int] = _heads(file)
	equal(heads.size(), 5)
	for step: int in 5:
		var time_usec: int = file.decode_u64(heads[step] + 4)
		is_true(time_usec >= before[step] - opened and time_usec <= behind[step] - began)


func test_keeps_the_times() -> void:
	_record_at([0, 40, 80, 120, 160])
	var player: RecordedStream = _player()
	player.open()
	player.advance(0.0)
	equal(_played.size(), 1)
	player.advance(0.1)
	equal(_played.size(), 3)
	equal(_finished, 0)
	player.advance(1.0)
	equal([_played.size(), _finished], [5, 1])


func test_it_begins_in_the_middle() -> void:
	_record_at([0, 40, 80, 120, 160])
	var player: RecordedStream = _player()
	player.from_s = 0.1
	equal(player.open(), "")
	almost_equal(player.now_s(), 0.1)
	player.advance(0.0)
	equal(_played.size(), 3, "before 0.1 s")
	player.advance(1.0)
	equal([_played.size(), _finished], [5, 1])


func test_what_is_no_recording_is_said_in_words() -> void:
	contains(RecordedStream.of_file("").open(), "--file=FILE")
	_write(PackedByteArray())
	contains(_player().open(), "is empty")
	_write("DSMT".to_ascii_buffer())
	contains(_player().open(), "expected a recording")
	_write(StateRecorder.MAGIC.to_ascii_buffer())
	contains(_player().open(), "is empty")


func test_a_forged_file_cannot_have_everything_made_at_once() -> void:
	var recorder: StateRecorder = StateRecorder.new()
	equal(recorder.open(PATH), "")
	var level: PackedByteArray = LevelMessage.encode("hall", PackedByteArray())
	var table: PackedByteArray = EntityTableMessage.new().encode()
	for _round: int in 3:
		recorder.add(level)
	for _round: int in 20:
		recorder.add(table)
	recorder.close()
	var player: RecordedStream = _player()
	equal(player.open(), "")
	for frame: int in 3:
		_played.clear()
		player.advance(10.0)
		equal(_played, [level] as Array[PackedByteArray])
	for tables: int in [8, 8, 4]:
		_played.clear()
		player.advance(10.0)
		equal(_played.size(), tables)
	equal(_finished, 1, "and it is played whole")


func test_cut_file_plays_up_to_the_cut() -> void:
	_record(6)
	var whole: PackedByteArray = FileAccess.get_file_as_bytes(PATH)
	for size: int in range(8, whole.size() + 1, 7):
		_write(whole.slice(0, size))
		_played.clear()
		_finished = 0
		var player: RecordedStream = _player()
		var error: String = player.open()
		player.advance(1e6)
		var complete: int = _complete_records(whole, size)
		equal(_played, _packets.slice(0, complete), "cut to %d bytes" % size)
		if complete == 0:
			contains(error, "the recording is empty")
		else:
			equal([error, _finished], ["", 1])


func test_a_kill_loses_at_most_a_second() -> void:
	var recorder: StateRecorder = StateRecorder.new()
	equal(recorder.open(PATH), "")
	var packet: PackedByteArray = _packet(1)
	var added: Array[int] = []
	while added.is_empty() or added[-1] - added[0] < 1300000:
		recorder.add(packet)
		added.append(Time.get_ticks_usec())
		OS.delay_msec(10)
	# Not closed: what is on the disk now is what a kill would leave.
	var bytes: int = FileAccess.get_file_as_bytes(PATH).size()
	var kept: int = (bytes - StateRecorder.MAGIC.length()) / (12 + packet.size())
	var old: Callable = func(time_usec: int) -> bool:
		return time_usec < added[-1] - int(StateRecorder.FLUSH_S * 1e6)
	var wanted: int = added.filter(old).size()
	is_true(wanted > 0)
	is_true(kept >= wanted, "%d packets on the disk of %d" % [kept, wanted])
	recorder.close()


func test_damaged_files_are_survived() -> void:
	_record(8)
	var whole: PackedByteArray = FileAccess.get_file_as_bytes(PATH)
	for _round: int in 60:
		var damaged: PackedByteArray = NetSamples.damage(_random, whole)
		_write(damaged)
		_played.clear()
		var player: RecordedStream = _player()
		player.open()
		player.advance(1e12)
		is_true(_played.size() <= 8)


func test_what_is_no_recording_is_reported() -> void:
	var player: RecordedStream = RecordedStream.of_file("user://no_such_recording")
	contains(player.open(), "cannot read user://no_such_recording: ")
	var cases: Array[PackedByteArray] = [
		"DSMT".to_ascii_buffer(), "DSMTREC1".to_ascii_buffer(), "HIERARCHY ROOT".to_ascii_buffer()
	]
	cases.append(NetSamples.noise(_random, 200) + PackedByteArray([27, 91, 50, 74]))
	cases.append(PackedByteArray([27, 91, 50, 74, 200, 0, 10, 13, 9]))
	for bytes: PackedByteArray in cases:
		_write(bytes)
		var error: String = RecordedStream.of_file(PATH).open()
		contains(error, PATH + ": expected a recording (DSMTREC4), found")
		equal(error, error.strip_escapes(), "no control characters in the log")


func test_playing_a_file_that_could_not_be_opened() -> void:
	_write("garbage!".to_ascii_buffer())
	var player: RecordedStream = _player()
	not_equal(player.open(), "")
	player.advance(5.0)
	equal(_played.size(), 0)


func test_recorder_that_cannot_write() -> void:
	var recorder: StateRecorder = StateRecorder.new()
	contains(recorder.open("user://no_such_folder/x"), "cannot record to user://no_such_folder/x")
	recorder.add(_packet(0))
	recorder.close()


func _record(p_count: int) -> void:
	var recorder: StateRecorder = StateRecorder.new()
	equal(recorder.open(PATH), "")
	for i: int in p_count:
		_packets.append(_packet(i))
		recorder.add(_packets[-1])
	recorder.close()


## Records a packet at each of these times, ms.
func _record_at(p_times_ms: Array[int]) -> void:
	_record(p_times_ms.size())
	var file: PackedByteArray = FileAccess.get_file_as_bytes(PATH)
	var heads: Array[int] = _heads(file)
	for step: int in heads.size():
		file.encode_u64(heads[step] + 4, p_times_ms[step] * 1000)
	_write(file)


func _packet(p_index: int) -> PackedByteArray:
	if p_index % 5 == 0:
		return NetSamples.table_bytes(_random, 4, 1)
	_stream.move()
	return _stream.datagrams()[0]


func _player() -> RecordedStream:
	var player: RecordedStream = RecordedStream.of_file(PATH)
	player.received.connect(_on_received)
	player.ended.connect(_on_ended)
	return player


func _on_received(p_bytes: PackedByteArray, _p_time_s: float) -> void:
	_played.append(p_bytes)


func _on_ended(p_exit_code: int, p_why: String) -> void:
	equal([p_exit_code, p_why], [0, ""])
	_finished += 1


func _complete_records(p_file: PackedByteArray, p_size: int) -> int:
	return _heads(p_file.slice(0, p_size)).size()


## Where the whole records of a file begin.
func _heads(p_file: PackedByteArray) -> Array[int]:
	var heads: Array[int] = []
	var at: int = 8
	while at + 12 <= p_file.size() and at + 12 + p_file.decode_u32(at) <= p_file.size():
		heads.append(at)
		at += 12 + p_file.decode_u32(at)
	return heads


func _write(p_bytes: PackedByteArray) -> void:
	var file: FileAccess = FileAccess.open(PATH, FileAccess.WRITE)
	file.store_buffer(p_bytes)
	file.close()

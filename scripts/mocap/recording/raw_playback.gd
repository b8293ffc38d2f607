class_name RawPlayback
extends RefCounted
## Plays a recording of raw bytes (docs/recordings.md) as motion: its suits as a feed of sensors,
## its MVN streams as people.

## The recording has ended and starts again.
signal begun_anew

## What plays.
var player: RawPlayer = RawPlayer.new()
## The suits of the recording, or null if it has none.
var suit: RecordedSuit = null
## The people of MVN in it, or null if it has none. Connect to its signals before the first
## [method advance].
var stream: MvnStream = null
## Speed, as a multiple of the recorded one.
var speed: float = 1.0
## Whether it starts again at its end.
var loops: bool = true

var _name: String = ""
var _began: bool = false


## Opens a file. Returns why it can't, or an empty text.
func open(p_path: String) -> String:
	var fault: String = player.open(ProjectSettings.globalize_path(p_path))
	if fault != "":
		return fault
	_name = p_path.get_file()
	for about: Dictionary in player.get_streams():
		if about["records"] == 0:
			continue
		if about["kind"] == "bus" and suit == null:
			suit = RecordedSuit.new()
			suit.play(player)
		elif about["kind"] == "mvn" and stream == null:
			stream = MvnStream.new()
	if suit == null and stream == null:
		return "%s holds no suit and no stream of MVN's" % p_path
	_report_damage()
	return ""


## Goes on, in the main thread, each frame.
func advance() -> void:
	var now: int = roundi(Time.get_unix_time_from_system() * 1e6)
	if not _began or (loops and player.is_at_end()):
		if _began:
			begun_anew.emit()
		_began = true
		player.begin(now, speed)
	advance_to(now)


## The same with a time of its own (Unix time, µs), for tests and for stepping;
## [method RawPlayer.begin] has returned when it began.
func advance_to(p_unix_usec: int) -> void:
	player.advance(p_unix_usec)
	if stream != null:
		for datagram: Dictionary in player.take_datagrams():
			stream.receiver.put(datagram["sender"], datagram["bytes"], datagram["time_usec"])
		stream.advance()
	if suit != null:
		suit.advance()


## Ends it.
func close() -> void:
	if suit != null:
		suit.close()
	if stream != null:
		stream.close()


## One line of text about the stream, for the user.
func describe() -> String:
	return "recording %s, %.0f s" % [_name, player.get_length_s()]


func _report_damage() -> void:
	var stats: Dictionary = player.get_stats()
	if stats["is_whole"]:
		return
	var keys: Array = ["damaged_bytes", "cut_bytes", "lost"]
	var counts: Array = keys.map(func(p_key: String) -> int: return stats[p_key])
	var text: String = "%s is not whole: %d bytes damaged, %d cut off at its end, %d records lost"
	Log.warning("mocap", text % ([_name] + counts))

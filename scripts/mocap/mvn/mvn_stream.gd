class_name MvnStream
extends RefCounted
## MVN's network stream: a person for each character that comes.

## The motion of a new person arrives.
signal appeared(p_source: MotionSource, p_name: String)
## A person's motion has stopped.
signal vanished(p_source: MotionSource)
## A person has come with trackers only (type 23): to be calibrated here.
signal trackers_appeared(p_feed: MvnTrackerFeed, p_name: String)
## Those trackers have stopped.
signal trackers_vanished(p_feed: MvnTrackerFeed)

## Time to wait for a person's name, s; after it the person has none.
const NAME_PATIENCE_S: float = 1.0
## Time between two checks of who is in the stream, s.
const LOOK_S: float = 0.1
## Types of the stream that are poses.
const POSES: Array[int] = [1, 2, 5]

## What receives; a recording may put its datagrams into it.
var receiver: MvnReceiver = MvnReceiver.new()
## Metres of the stream's unit of length; 0: as the types have it.
var unit_m: float = 0.0
## People in the stream, by the number of their character.
var people: Dictionary[int, MvnSource] = {}
## Trackers of people without a pose, by the number of their character.
var trackers: Dictionary[int, MvnTrackerFeed] = {}
## People in the stream and stats of their samples, see [method MvnReceiver.get_characters].
var characters: Array[Dictionary] = []

var _seen_s: Dictionary[int, float] = {}
var _looked_s: float = -INF


## Opens a UDP port of this machine; 0 takes any. Returns why it can't, or an empty text.
func open(p_port: int) -> String:
	var fault: String = receiver.open(p_port)
	if fault == "":
		Log.info("mvn", "receives MVN's stream on UDP port %d" % receiver.get_port())
	return fault


## Closes the port; everybody vanishes.
func close() -> void:
	receiver.close()
	characters = []
	_forget_gone()


## Goes on, in the main thread, each frame.
func advance() -> void:
	var now_s: float = Time.get_ticks_usec() / 1e6
	if now_s - _looked_s < LOOK_S:
		return
	_looked_s = now_s
	for line: String in receiver.take_news():
		Log.info("mvn", line)
	for message: String in receiver.take_messages():
		Log.limited("mvn", message, message)
	characters = receiver.get_characters()
	for stats: Dictionary in characters:
		_take(stats, now_s)
	_forget_gone()


## What is wrong with the stream, for the screen; empty if nothing is.
func trouble() -> String:
	var texts: PackedStringArray = []
	for stats: Dictionary in characters:
		if stats["trouble"] != "":
			texts.append("MVN: %s" % stats["trouble"])
	var refused: int = receiver.get_stats()["refused"]
	if refused > 0 and people.is_empty() and trackers.is_empty():
		texts.append("MVN: %d datagrams came that can't be used" % refused)
	return "\n".join(texts)


## One line of text about the stream, for the user.
func describe() -> String:
	if receiver.get_port() == 0:
		return "MVN's stream is not open"
	if characters.is_empty():
		return "no MVN on UDP port %d yet" % receiver.get_port()
	return "%d people of MVN on UDP port %d" % [characters.size(), receiver.get_port()]


## For the panel: the port, and everybody in the stream; see [constant DeviceList.KEYS].
func list_devices() -> Array[Dictionary]:
	var refused: int = receiver.get_stats()["refused"]
	var port: String = "UDP port %d" % receiver.get_port()
	if receiver.get_port() == 0:
		port = "recorded"
	var rows: Array[Dictionary] = [
		{
			"name": "MVN (%s)" % port,
			"state": "receives" if not characters.is_empty() else "waits",
			"detail": "%d bad datagrams" % refused if refused > 0 else "",
			"advice": "",
		}
	]
	for stats: Dictionary in characters:
		rows.append(_row(stats))
	return rows


static func _row(p_stats: Dictionary) -> Dictionary:
	var details: PackedStringArray = ["%.0f Hz" % p_stats["rate_hz"]]
	var lost: int = p_stats["lost"]
	if lost > 0:
		var share: float = 100.0 * lost / maxi(lost + p_stats["samples"], 1)
		details.append("%d lost (%.1f %%)" % [lost, share])
	for key: String in ["incomplete", "late"]:
		if p_stats[key] > 0:
			details.append("%d %s" % [p_stats[key], key])
	if p_stats["age_s"] > 0.5:
		details.append("last %.1f s ago" % p_stats["age_s"])
	var types: PackedStringArray = []
	for type: int in p_stats["types"]:
		types.append("%02d" % type)
	details.append("types %s" % " ".join(types))
	var who: String = p_stats["name"] if p_stats["name"] != "" else "no name"
	return {
		"name": "MVN %d: %s (%s)" % [p_stats["number"], who, p_stats["sender"]],
		"state": "streams" if p_stats["age_s"] <= 0.5 else "silent",
		"detail": ", ".join(details),
		"advice": p_stats["trouble"],
	}


func _take(p_stats: Dictionary, p_now_s: float) -> void:
	var number: int = p_stats["number"]
	if people.has(number):
		people[number].note(p_stats)
		return
	if trackers.has(number):
		trackers[number].note(p_stats)
	var types: PackedInt32Array = p_stats["types"]
	var since: float = _seen_s.get_or_add(number, p_now_s)
	if p_stats["name"] == "" and p_now_s - since < NAME_PATIENCE_S:
		return
	if POSES.any(func(p_type: int) -> bool: return types.has(p_type)):
		var source: MvnSource = MvnSource.new(receiver, number, unit_m)
		source.note(p_stats)
		people[number] = source
		appeared.emit(source, p_stats["name"])
	elif types.has(23) and not trackers.has(number) and p_now_s - since >= NAME_PATIENCE_S:
		var feed: MvnTrackerFeed = MvnTrackerFeed.new(receiver, number)
		feed.note(p_stats)
		trackers[number] = feed
		trackers_appeared.emit(feed, p_stats["name"])


func _forget_gone() -> void:
	var here: Array = characters.map(func(p_stats: Dictionary) -> int: return p_stats["number"])
	for number: int in people.keys():
		if not here.has(number):
			var source: MvnSource = people[number]
			people.erase(number)
			vanished.emit(source)
	for number: int in trackers.keys():
		if not here.has(number):
			var feed: MvnTrackerFeed = trackers[number]
			trackers.erase(number)
			trackers_vanished.emit(feed)
	for number: int in _seen_s.keys():
		if not here.has(number):
			_seen_s.erase(number)

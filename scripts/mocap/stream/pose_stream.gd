class_name PoseStream
extends RefCounted
## A network stream of poses: what a [StreamReader] reads from a [StreamPort], as people who come
## and go. Poses are read in the port's thread, as soon as they come.

## The motion of a new person arrives.
signal appeared(p_source: MotionSource, p_name: String)
## A person's motion has stopped.
signal vanished(p_source: MotionSource)

## Number of samples from which on a person counts as present: a stray datagram is nobody.
const MIN_SAMPLES: int = 2
## Silence after which a person counts as gone, s.
const GONE_S: float = 3.0
## Time after its last datagram for which a sender's fault is shown, s.
const FORGOTTEN_S: float = 10.0
## Maximum of people, of all senders together.
const MAX_PEOPLE: int = 8
## Maximum of senders of whom something is known.
const MAX_SENDERS: int = 32
## Time between two checks of who is in the stream, s.
const LOOK_S: float = 0.1

## What receives.
var port: StreamPort = StreamPort.new()
## Those who are there, by sender and number; changed by [method advance] only.
var people: Dictionary[String, StreamPerson] = {}

# Held while the reader works.
var _reading: Mutex = Mutex.new()
var _reader: StreamReader = null
var _looked_s: float = -INF
# Shared between threads and guarded.
var _mutex: Mutex = Mutex.new()
var _heard: Dictionary[String, StreamPerson] = {}
var _refused: int = 0
var _crowd: int = 0
# Of each sender of late: when it said something, why it can't be used, what is known of it and what
# is wrong with it.
var _spoken_usec: Dictionary[String, int] = {}
var _why: Dictionary[String, String] = {}
var _details: Dictionary[String, PackedStringArray] = {}


func _init(p_reader: StreamReader) -> void:
	_reader = p_reader


## What reads the protocol.
func reader() -> StreamReader:
	return _reader


## What the protocol is called.
func title() -> String:
	return _reader.title()


## Opens a UDP port, with a multicast group if one is given. Returns why it can't, or an empty text.
func open(p_port: int, p_group: String = "") -> String:
	return _open(port.open_udp(p_port, take, p_group))


## Opens any port that is free, which only this machine reaches. Returns why it can't, or an empty
## text.
func open_local() -> String:
	return _open(port.open_udp(0, take, "", "127.0.0.1"))


## Connects to the TCP port of a sender.
func open_tcp(p_host: String, p_port: int) -> void:
	port.open_tcp(p_host, p_port, take)
	Log.info("mocap", "receives %s from %s" % [title(), port.describe()])


## Closes it; everybody vanishes.
func close() -> void:
	port.close()
	_reader.close()
	_mutex.lock()
	_heard.clear()
	_mutex.unlock()
	look(Time.get_unix_time_from_system())


## Takes a datagram (or a piece of a TCP stream) of a sender that came at a time, µs of Unix time:
## in the port's thread, or from a recording while the port is closed.
func take(p_bytes: PackedByteArray, p_sender: String, p_usec: int) -> void:
	_reading.lock()
	_reader.fault = ""
	_reader.now_usec = p_usec
	var samples: Array[StreamSample] = _reader.read(p_bytes, p_sender)
	var fault: String = _reader.fault
	var known: PackedStringArray = [_reader.detail(p_sender), _reader.trouble(p_sender)]
	_reading.unlock()
	for sample: StreamSample in samples:
		var person: StreamPerson = _person(sample, p_sender)
		if person != null:
			var arrival: int = sample.arrival_usec if sample.arrival_usec > 0 else p_usec
			var wrong: String = person.take(sample, arrival)
			fault = wrong if fault == "" else fault
	_note(p_sender, p_usec, known, fault)


## Goes on, in the main thread, each frame.
func advance() -> void:
	var now_s: float = Time.get_unix_time_from_system()
	if absf(now_s - _looked_s) < LOOK_S:
		return
	_looked_s = now_s
	_reading.lock()
	var parcels: Array[StreamPort.Parcel] = _reader.talk(roundi(now_s * 1e6))
	_reading.unlock()
	for parcel: StreamPort.Parcel in parcels:
		port.send(parcel.bytes, parcel.address, parcel.port)
	look(now_s)


## What is wrong with the stream, for the screen; empty if nothing is.
func trouble() -> String:
	var texts: PackedStringArray = []
	if _reader.obstacle() != "":
		texts.append("%s: %s" % [title(), _reader.obstacle()])
	_mutex.lock()
	for sender: String in _details:
		if _details[sender][1] != "":
			texts.append("%s: %s" % [title(), _details[sender][1]])
	if people.is_empty() and not _why.is_empty():
		var sender: String = _why.keys()[0]
		texts.append("%s: %s sends what can't be used: %s" % [title(), sender, _why[sender]])
	_mutex.unlock()
	return "\n".join(texts)


## One line of text about the stream, for the user.
func describe() -> String:
	if not port.is_open():
		return "%s is not open" % title()
	if people.is_empty():
		return "no %s on %s yet" % [title(), _place()]
	return "%d people of %s on %s" % [people.size(), title(), _place()]


## For the panel: the port, and everybody in the stream; see [constant DeviceList.KEYS].
func list_devices() -> Array[Dictionary]:
	var left_out: int = port.get_left_out()
	_mutex.lock()
	var notes: PackedStringArray = []
	if _refused > 0:
		notes.append("%d bad datagrams" % _refused)
	if left_out > 0:
		notes.append("%d of a flood left out" % left_out)
	if _crowd > 0:
		notes.append("more than %d people" % MAX_PEOPLE)
	var why: String = _reader.obstacle()
	if why == "" and people.is_empty():
		for sender: String in _details:
			why = _details[sender][1] if why == "" else why
		why = str(_why.values()[0]) if why == "" and not _why.is_empty() else why
	_mutex.unlock()
	var rows: Array[Dictionary] = [
		{
			"name": "%s (%s)" % [title(), _place()],
			"state": "waits" if people.is_empty() else "receives",
			"detail": ", ".join(notes),
			"advice": why,
		}
	]
	for key: String in people:
		rows.append(_row(people[key]))
	return rows


## Finds who has come and who is gone, at a time, s of Unix time; [method advance] does it.
func look(p_now_s: float) -> void:
	var fresh: Dictionary[String, StreamPerson] = {}
	_mutex.lock()
	for sender: String in _spoken_usec.keys():
		if p_now_s - _spoken_usec[sender] / 1e6 > FORGOTTEN_S:
			_spoken_usec.erase(sender)
			_details.erase(sender)
			_why.erase(sender)
	for key: String in _heard.keys():
		var stats: Dictionary = _heard[key].stats()
		if p_now_s - stats["usec"] / 1e6 > GONE_S:
			_heard.erase(key)
		elif stats["samples"] >= MIN_SAMPLES:
			fresh[key] = _heard[key]
	_mutex.unlock()
	for key: String in people.keys():
		if fresh.get(key) != people[key]:
			var gone: StreamPerson = people[key]
			people.erase(key)
			Log.info("mocap", "%s: %s at %s has gone" % [title(), gone.get_name(), gone.sender])
			vanished.emit(gone)
	for key: String in fresh:
		if not people.has(key):
			people[key] = fresh[key]
			Log.info(
				"mocap",
				"%s: %s at %s has come" % [title(), fresh[key].get_name(), fresh[key].sender]
			)
			appeared.emit(fresh[key], fresh[key].get_name())


func _open(p_fault: String) -> String:
	if p_fault != "":
		return "%s: %s" % [title(), p_fault]
	Log.info("mocap", "receives %s on %s" % [title(), port.describe()])
	return ""


## Where the stream comes from, for people.
func _place() -> String:
	return _reader.place() if _reader.place() != "" else port.describe()


func _row(p_person: StreamPerson) -> Dictionary:
	var stats: Dictionary = p_person.stats()
	var notes: PackedStringArray = ["%.0f Hz" % stats["rate_hz"]]
	if stats["lost"] > 0:
		var share: float = 100.0 * stats["lost"] / maxi(stats["lost"] + stats["samples"], 1)
		notes.append("%d lost (%.1f %%)" % [stats["lost"], share])
	for key: String in ["twice", "faulty"]:
		if stats[key] > 0:
			notes.append("%d %s" % [stats[key], key])
	var age_s: float = Time.get_unix_time_from_system() - stats["usec"] / 1e6
	if age_s > 0.5:
		notes.append("last %.1f s ago" % age_s)
	_mutex.lock()
	var known: PackedStringArray = _details.get(p_person.sender, PackedStringArray(["", ""]))
	_mutex.unlock()
	if known[0] != "":
		notes.append(known[0])
	var who: String = p_person.get_name()
	if who == "":
		who = "no name"
	return {
		"name": "%s: %s (%s)" % [title(), who, _sender_of(p_person)],
		"state": "streams" if age_s <= 0.5 else "silent",
		"detail": ", ".join(notes),
		"advice": known[1],
	}


func _sender_of(p_person: StreamPerson) -> String:
	return _reader.place() if _reader.place() != "" else p_person.sender


func _person(p_sample: StreamSample, p_sender: String) -> StreamPerson:
	var key: String = p_sender + " " + p_sample.person
	_mutex.lock()
	var person: StreamPerson = _heard.get(key)
	if person == null and _heard.size() < MAX_PEOPLE:
		person = StreamPerson.new(title(), p_sender, p_sample.name)
		_heard[key] = person
	elif person == null:
		_crowd += 1
	_mutex.unlock()
	if person == null:
		Log.limited(
			"mocap", "crowd " + title(), "%s: more than %d people, not used" % [title(), MAX_PEOPLE]
		)
	return person


# In one go: what is wrong with a sender is forgotten with the sender, never without it.
func _note(p_sender: String, p_usec: int, p_known: PackedStringArray, p_fault: String) -> void:
	if p_fault != "":
		Log.limited("mocap", title() + p_sender, "%s from %s: %s" % [title(), p_sender, p_fault])
	_mutex.lock()
	_refused += 0 if p_fault == "" else 1
	if _spoken_usec.has(p_sender) or _spoken_usec.size() < MAX_SENDERS:
		_spoken_usec[p_sender] = p_usec
		_details[p_sender] = p_known
		if p_fault != "":
			_why[p_sender] = p_fault
	_mutex.unlock()

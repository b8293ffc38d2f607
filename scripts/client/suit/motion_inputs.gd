class_name MotionInputs
extends RefCounted
## The motion sources that a client's options ask for: what --source names (files, the suit on USB,
## network streams, body trackers of other plugins, a headset; --bvh and --xbus
## are short for some), and recordings of suits. Sources have numbers from 1 on, in their order;
## --fuse completes the first by others, limb by limb ([LimbFusion]).

## A person's motion is available now.
signal appeared(p_source: MotionSource, p_name: String)
## A person's motion has ended.
signal vanished(p_source: MotionSource)

## Seconds without a new tracker after which no more are expected.
const _SETTLE_S: float = 1.0
## Seconds after which a missing source is logged.
const _ABSENT_S: float = 2.0

## The suits on USB or of a recording, or null.
var usb: UsbSuitFeed = null
## MVN's stream, live or of a recording, or null.
var mvn: MvnStream = null
## The other network streams.
var streams: MotionStreams = MotionStreams.new()
## Decides which sources are people, and which ones complete the first person, limb by limb.
var people: PeopleFusion = PeopleFusion.new()
## Sends everybody's poses to other programs, or null.
var vmc_out: VmcOut = null
## Guides calibrations that are asked for.
var calibration: ClientCalibration = ClientCalibration.new()
## Makes a motion source where the options name none: [code]func() -> MotionSource[/code], if valid.
var make_default: Callable = Callable()
## A headset will move the user's body once it is there: until then no other source does.
var awaits_headset: bool = false
## Who walks without a suit, or null.
var walker: WalkerSource = null
## Those who wear sensors.
var wearers: Array[SuitSource] = []

var _options: Options = null
var _store: CalibrationStore = CalibrationStore.new()
var _begins_with: String = ""
var _settled_revision: int = -1
var _settled_s: float = 0.0
var _began_s: float = -1.0
var _has_noticed: bool = false
var _has_files: bool = false
var _recorder: RawRecorder = null
var _recorder_fault: String = ""
var _playback: RawPlayback = null
var _trackers: Array[TrackerSource] = []
var _by_feed: Dictionary[SensorFeed, SuitSource] = {}
# The sources; their numbers count from 1.
var _addresses: Array[SourceAddress] = []


## Opens all. Returns what is wrong, or an empty text.
func open(p_options: Options) -> String:
	_options = p_options
	_begins_with = p_options.text("calibrate")
	people.appeared.connect(appeared.emit)
	people.vanished.connect(vanished.emit)
	streams.appeared.connect(people.appear)
	streams.vanished.connect(people.vanish)
	streams.camera.fov_deg = p_options.degrees("webcam-fov")
	streams.camera.people = p_options.number("webcam-people")
	streams.camera.height_m = p_options.metres("webcam-height")
	var fault: String = _open_recorder()
	if fault == "" and p_options.text("vmc-out") != "":
		vmc_out = VmcOut.new()
		fault = vmc_out.open(p_options.text("vmc-out"))
	if fault == "":
		fault = _open_playback()
	if fault == "":
		_addresses = SourceAddress.of_options(p_options)
		if not _addresses.is_empty() or has_any():
			fault = _open_addresses()
	return fault if fault != "" or p_options.is_on("try") else open_default()


## Opens what moves somebody who has no source; harmless where there is one. Returns what is wrong,
## or an empty text.
func open_default() -> String:
	if has_any() or awaits_headset:
		return ""
	_addresses = _find_default()
	return _open_addresses()


## Whether there is a source, though perhaps without anybody yet.
func has_any() -> bool:
	var has_device: bool = usb != null or mvn != null or not _trackers.is_empty()
	return _has_files or has_device or streams.has_any()


## Opens one more source while the client runs, such as "vmc:39539". Returns why it can't, or an
## empty text.
func open_source(p_text: String) -> String:
	var address: SourceAddress = SourceAddress.parse(p_text)
	if address.fault != "":
		return address.fault
	for other: SourceAddress in _addresses:
		if other.equals(address):
			return "'%s' is a source already" % p_text.left(80)
	_addresses.append(address)
	var fault: String = _open_source(address, _addresses.size())
	if fault != "":
		_addresses.pop_back()
	people.count = _addresses.size()
	return fault


## The sources for the panel: "number", "name", and "person", somebody's name where one is there.
func list_sources() -> Array[Dictionary]:
	var rows: Array[Dictionary] = []
	for number: int in range(1, _addresses.size() + 1):
		var name: String = _addresses[number - 1].kind
		rows.append({"number": number, "name": name, "person": people.find_person(number)})
	return rows


## Goes on; call it each frame with the time, s.
func advance(p_now_s: float) -> void:
	if _playback != null:
		_playback.advance()
	elif usb != null:
		usb.advance()
	if mvn != null and (_playback == null or _playback.stream != mvn):
		mvn.advance()
	for tracker: TrackerSource in _trackers:
		tracker.advance(roundi(Time.get_unix_time_from_system() * 1e6))
	streams.advance()
	for wearer: SuitSource in wearers:
		wearer.advance(p_now_s)
	_notice_absence(p_now_s)
	_watch_recorder()
	if _begins_with != "" and _is_settled(p_now_s):
		calibrate(wearers[0], ClientCalibration.KINDS[_begins_with], p_now_s)
		_begins_with = ""


## Calibrates somebody, guided by texts on the screen. The outcome goes to
## [code]func(accepted: bool, text: String)[/code] too, if there is one.
func calibrate(
	p_source: MotionSource,
	p_kind: CalibrationGuide.Kind,
	p_now_s: float,
	p_answer: Callable = Callable()
) -> void:
	var fault: String = "this motion comes calibrated"
	if p_source is SuitSource:
		fault = calibration.start(p_source as SuitSource, p_kind, p_now_s, p_answer)
	if fault != "":
		if p_answer.is_valid():
			p_answer.call(false, "not calibrated: " + fault)
		calibration.say("Not calibrated: " + fault, p_now_s)
		Log.warning("mocap", "not calibrated: " + fault)


## The devices, for the panel: see [constant DeviceList.KEYS].
func list_devices() -> Array[Dictionary]:
	var rows: Array[Dictionary] = []
	if usb != null:
		rows.append_array(usb.list_devices())
	if mvn != null:
		rows.append_array(mvn.list_devices())
	rows.append_array(streams.list_devices())
	for tracker: TrackerSource in _trackers:
		var row: Dictionary = {"name": tracker.describe(), "state": "", "detail": ""}
		row["advice"] = tracker.error
		rows.append(row)
	return rows


## State of the suit for an instructor: its kind, whether it is calibrated, and what is wrong with
## it.
func describe() -> String:
	if wearers.is_empty():
		return mvn.describe() if mvn != null else streams.describe()
	var parts: PackedStringArray = [wearers[0].feed.describe()]
	parts.append("calibrated" if wearers[0].is_calibrated() else "not calibrated")
	if usb != null and usb.trouble() != "":
		parts.append(usb.trouble())
	if wearers.size() > 1:
		parts.append("and %d more" % (wearers.size() - 1))
	return ", ".join(parts)


## What the wearer is to see at a time, s: what to do in a calibration, or what is wrong with the
## suit; mostly nothing.
func guide(p_now_s: float) -> String:
	var text: String = calibration.text(p_now_s)
	if text == "":
		text = _recorder_fault
	if text == "" and usb != null:
		text = usb.trouble()
	if text == "" and mvn != null:
		text = mvn.trouble()
		if text == "" and mvn.people.is_empty() and mvn.trackers.is_empty():
			text = mvn.describe()
	if text == "":
		text = streams.trouble()
	for tracker: TrackerSource in _trackers:
		text = tracker.error if text == "" else text
	if text == "" and not wearers.is_empty() and not wearers[0].is_calibrated():
		text = wearers[0].describe()
		if wearers[0].newest_frame != null:
			var keys: Array = [InputKeys.name_of(&"toggle_devices")]
			keys.append(InputKeys.name_of(&"calibrate_full"))
			text = "Not calibrated yet: press %s, then %s, and follow the figure" % keys
	return text


## Closes all devices.
func close() -> void:
	if _playback != null:
		_playback.close()
	elif usb != null:
		usb.close()
	if mvn != null:
		mvn.close()
	streams.close()
	if _recorder != null:
		_recorder.close()


## The source where the options name none: a headset, or keys to walk by.
func _find_default() -> Array[SourceAddress]:
	if awaits_headset and not make_default.is_valid():
		return []
	return [SourceAddress.parse("xr" if make_default.is_valid() else "walker")]


## Logs once which sources are missing, for those who see no screen.
func _notice_absence(p_now_s: float) -> void:
	if _began_s < 0.0:
		_began_s = p_now_s
	if _has_noticed or p_now_s < _began_s + _ABSENT_S:
		return
	_has_noticed = true
	if usb != null and usb.devices.is_empty():
		Log.info("suit", "no suit on USB yet: plug it in and switch it on")
	for tracker: TrackerSource in _trackers:
		if tracker.error != "":
			Log.warning("mocap", tracker.error)


## A disk that is full must not cost a session unseen.
func _watch_recorder() -> void:
	if _recorder == null or _recorder_fault != "" or Engine.get_process_frames() % 30 != 0:
		return
	_recorder_fault = _recorder.get_stats()["fault"]
	if _recorder_fault != "":
		Log.error("mocap", _recorder_fault)


## Whether all trackers that there are have been found: for a while no more have come.
func _is_settled(p_now_s: float) -> bool:
	if wearers.is_empty() or wearers[0].newest_frame == null:
		return false
	var revision: int = wearers[0].feed.revision
	if revision != _settled_revision:
		_settled_revision = revision
		_settled_s = p_now_s
	return p_now_s > _settled_s + _SETTLE_S and (usb == null or usb.is_settled())


func _open_recorder() -> String:
	var path: String = _options.file("suit-record")
	if path == "":
		return ""
	_recorder = RawRecorder.new()
	return _recorder.open(path)


func _open_addresses() -> String:
	people.count = _addresses.size()
	var walks: Callable = func(one: SourceAddress) -> bool: return one.kind == "walker"
	people.walker = _addresses.find_custom(walks) + 1
	var fault: String = people.read(_options.text("fuse"))
	for number: int in _addresses.size():
		if fault == "":
			fault = _open_source(_addresses[number], number + 1)
	return fault


func _open_source(p_address: SourceAddress, p_number: int) -> String:
	if p_address.fault != "":
		return "--source: " + p_address.fault
	match p_address.kind:
		"bvh":
			return _open_files(p_address.paths(), p_number)
		"xbus":
			return _open_usb(p_number)
		"mvn":
			return _open_mvn(p_address.port, p_number)
		"tracker":
			_trackers.append(TrackerSource.new(p_address.text))
			people.appear(_trackers[-1], "", p_number)
			return ""
		"walker", "xr":
			return _open_own(p_address.kind, p_number)
	var before: SlimeFeed = streams.slime
	var fault: String = streams.open(p_address, p_number)
	if fault == "" and streams.slime != before:
		_wear(streams.slime, _options.text("person") if wearers.is_empty() else "", p_number)
	return fault


## Opens what moves the client's own user without a suit: keys, or a headset.
func _open_own(p_kind: String, p_number: int) -> String:
	if p_kind == "walker":
		if walker != null:
			return "--source=walker is named twice: a client walks for one person"
		walker = WalkerSource.new()
		people.walker = p_number
	elif awaits_headset:
		return ""
	elif not make_default.is_valid():
		return "--source=xr: no headset is worn: start with --display=hmd"
	_has_files = true
	people.appear(walker if p_kind == "walker" else make_default.call(), "", p_number)
	return ""


func _open_files(p_paths: PackedStringArray, p_number: int) -> String:
	_has_files = _has_files or not p_paths.is_empty()
	for path: String in p_paths:
		var source: BvhSource = BvhSource.new()
		source.start_s = _options.seconds("bvh-from")
		source.open(path, _options.text("unit"), _options.text("up"))
		if source.error != "":
			return source.error
		Log.info("mocap", source.describe())
		for note: String in source.notes:
			Log.info("mocap", note)
		# Of several people each has the name of a file, one alone the client's.
		var name: String = path.get_file().get_basename() if p_paths.size() > 1 else ""
		people.appear(source, name, p_number)
	return ""


func _open_playback() -> String:
	var path: String = _options.file("suit-play")
	if path == "":
		return ""
	_playback = RawPlayback.new()
	var fault: String = _playback.open(path)
	if fault != "":
		return fault
	Log.info("mocap", _playback.describe())
	if _playback.suit != null:
		usb = _playback.suit
		_wear(usb, _options.text("person"), 0)
	if _playback.stream != null:
		mvn = _playback.stream
		_follow(mvn, 0)
	return ""


func _open_usb(p_number: int) -> String:
	if usb != null:
		return "either --xbus or a recording of a suit, not both"
	var feed: UsbSuitFeed = UsbSuitFeed.new()
	feed.record_to(_recorder)
	feed.open(_options.number("suit-rate"))
	if feed.error == "":
		usb = feed
		_wear(usb, _options.text("person"), p_number)
	return feed.error


func _open_mvn(p_port: int, p_number: int) -> String:
	if mvn != null:
		return "MVN's stream is named twice, or a recording has one too"
	var stream: MvnStream = MvnStream.new()
	stream.receiver.set_recorder(_recorder)
	var fault: String = stream.open(p_port)
	if fault == "":
		mvn = stream
		_follow(mvn, p_number)
	return fault


func _follow(p_stream: MvnStream, p_number: int) -> void:
	p_stream.appeared.connect(people.appear.bind(p_number))
	p_stream.vanished.connect(people.vanish)
	p_stream.trackers_appeared.connect(_wear.bind(p_number))
	p_stream.trackers_vanished.connect(_take_off)


## Somebody wears sensors; the data kept under that person's name are loaded.
func _wear(p_feed: SensorFeed, p_name: String, p_number: int) -> void:
	var wearer: SuitSource = SuitSource.new(p_feed)
	WearerProfile.begin(wearer, p_name, _store, wearers.size() + 1)
	_by_feed[p_feed] = wearer
	wearers.append(wearer)
	people.appear(wearer, p_name, p_number)


func _take_off(p_feed: SensorFeed) -> void:
	var wearer: SuitSource = _by_feed.get(p_feed)
	if wearer != null:
		_by_feed.erase(p_feed)
		wearers.erase(wearer)
		calibration.forget(wearer)
		people.vanish(wearer)

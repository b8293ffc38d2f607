class_name MotionInputs
extends RefCounted
## The motion sources that a client's options ask for: files, the suit on USB, MVN's stream.

## Somebody's motion can be had now.
signal appeared(p_source: MotionSource, p_name: String)
## Somebody's motion has ended.
signal vanished(p_source: MotionSource)

## No more trackers are waited for after so many seconds without a new one.
const _SETTLE_S: float = 1.0

## The suit on USB, or null.
var usb: UsbSuitFeed = null
## Guides calibrations that are asked for.
var calibration: ClientCalibration = ClientCalibration.new()
## Those who wear sensors.
var wearers: Array[SuitSource] = []

var _options: Options = null
var _store: CalibrationStore = CalibrationStore.new()
var _begins_with: String = ""
var _settled_revision: int = -1
var _settled_s: float = 0.0


## Opens all. Returns what is wrong, or an empty text.
func open(p_options: Options) -> String:
	_options = p_options
	_begins_with = p_options.text("calibrate")
	var fault: String = _open_files()
	if fault == "" and p_options.number("xbus") != 0:
		fault = _open_usb()
	if fault == "" and wearers.is_empty() and p_options.text("bvh") == "":
		return "a trainee needs a motion source: --bvh=FILE, --xbus=1 or --mvn=9763"
	return fault


## Goes on; call it each frame with the time, s.
func advance(p_now_s: float) -> void:
	if usb != null:
		usb.advance()
	for wearer: SuitSource in wearers:
		wearer.advance(p_now_s)
	if _begins_with != "" and _is_settled(p_now_s):
		calibrate(wearers[0], ClientCalibration.KINDS[_begins_with], p_now_s)
		_begins_with = ""


## Calibrates somebody, guided by texts on the screen.
func calibrate(p_source: MotionSource, p_kind: CalibrationGuide.Kind, p_now_s: float) -> void:
	var fault: String = "this motion comes calibrated"
	if p_source is SuitSource:
		fault = calibration.start(p_source, p_kind, p_now_s)
	if fault != "":
		calibration.say("Not calibrated: " + fault, p_now_s)
		Log.warning("mocap", "not calibrated: " + fault)


## The devices, for the panel: see [constant DeviceList.KEYS].
func list_devices() -> Array[Dictionary]:
	return usb.list_devices() if usb != null else [] as Array[Dictionary]


## What the wearer is to see at a time, s: what to do in a calibration, or what is wrong with the
## suit; mostly nothing.
func guide(p_now_s: float) -> String:
	var text: String = calibration.text(p_now_s)
	if text == "" and usb != null:
		text = usb.trouble()
	if text == "" and not wearers.is_empty() and not wearers[0].is_calibrated():
		text = "Not calibrated yet" if wearers[0].newest_frame != null else wearers[0].describe()
	return text


## Gives all devices back.
func close() -> void:
	if usb != null:
		usb.close()


## Whether all trackers that there are have been found: for a while no more have come.
func _is_settled(p_now_s: float) -> bool:
	if wearers.is_empty() or wearers[0].newest_frame == null:
		return false
	var revision: int = wearers[0].feed.revision
	if revision != _settled_revision:
		_settled_revision = revision
		_settled_s = p_now_s
	return p_now_s > _settled_s + _SETTLE_S and (usb == null or usb.is_settled())


func _open_files() -> String:
	for path: String in _options.files("bvh"):
		var source: BvhSource = BvhSource.new()
		source.open(path, _options.text("unit"), _options.text("up"))
		if source.error != "":
			return source.error
		Log.info("mocap", source.describe())
		appeared.emit(source, "")
	return ""


func _open_usb() -> String:
	usb = UsbSuitFeed.new()
	usb.open(_options.number("suit-rate"))
	if usb.error != "":
		return usb.error
	var wearer: SuitSource = SuitSource.new(usb)
	var name: String = _options.text("person")
	if name != "":
		var profile: PersonProfile = _store.read(name)
		if profile != null:
			Log.info("mocap", "%s: as kept in %s" % [name, _store.path_of(name)])
		else:
			Log.warning("mocap", _store.error)
			profile = PersonProfile.new()
			profile.name = name
		wearer.set_profile(profile)
	wearers.append(wearer)
	appeared.emit(wearer, name)
	return ""

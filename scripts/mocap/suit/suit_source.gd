class_name SuitSource
extends MotionSource
## A person who wears sensors: a [SensorFeed], and who wears it where and how ([PersonProfile]).
##
## Any thread may sample it, and one other (the main one) show and calibrate it meanwhile: call
## [method advance] there in every frame. A suit does not know where it is: the
## lower foot stands on the ground below the origin, and the server finds the travel
## (--root=inertial).

## There is a result of a calibration to accept or refuse.
signal calibrated(p_result: CalibrationResult)

## Maximum of frames that wait for display and calibration; beyond it the oldest are dropped.
const MAX_RECENT: int = 2048
## Time in which the body blends into another calibration, s.
const PASSAGE_S: float = 0.5

## Where the sensors' samples come from.
var feed: SensorFeed = null
## The calibration process; only the main thread may touch it.
var process: CalibrationProcess = CalibrationProcess.new()
## The newest frame that [method advance] saw, or null.
var newest_frame: SensorFrame = null
## The newest pose that [method advance] saw, or null before calibration. While a result waits to
## be accepted, the pose as it would be with it.
var newest_pose: PoseSample = null
## What is known of how good the calibration in use is, or null if it was made in another session.
var quality: CalibrationResult = null
## Finds sensors that are exchanged or sit wrongly.
var watch: WearWatch = WearWatch.new()
## Takes drift off the sensors' headings.
var headings: HeadingKeeper = HeadingKeeper.new()
## The magnetic field at each sensor.
var magnetics: MagneticWatch = MagneticWatch.new(headings.drift)

# The frames as the result would turn them into poses.
var _trial: SuitTable = null
# Of the thread that samples alone.
var _poses: LivePoses = LivePoses.new()
var _poses_of: SuitTable = null
var _last: PoseSample = null
var _passes_from: PoseSample = null
var _passes_since_usec: int = 0
# Shared between threads and guarded.
var _mutex: Mutex = Mutex.new()
var _profile: PersonProfile = PersonProfile.new()
var _table: SuitTable = SuitTable.new()
var _revision: int = -1
# The corrections of the sensors' headings, rad.
var _corrections: PackedFloat64Array = PackedFloat64Array()
var _unread: Array[SensorFrame] = []
var _recent: Array[SensorFrame] = []
var _faulty: int = 0


func _init(p_feed: SensorFeed = null) -> void:
	feed = p_feed
	if p_feed != null:
		error = p_feed.error


## Who wears it. Do not change it; make a new one or use the methods here.
func get_profile() -> PersonProfile:
	_mutex.lock()
	var profile: PersonProfile = _profile
	_mutex.unlock()
	return profile


## Sets who wears it: mounts, size and calibration are used from the next sample on. Headings have
## not drifted yet. What was known of how good another calibration is does not count.
func set_profile(p_profile: PersonProfile) -> void:
	if quality != null and quality.calibration != p_profile.calibration:
		quality = null
	_correct(PackedFloat64Array())
	_use(p_profile)
	headings.clear()


## Sets the mounts of the sensors. The calibration of those that moved is void.
func set_map(p_map: SensorMap) -> void:
	var changed: PersonProfile = _copy_profile()
	changed.map = p_map
	_use(changed)


## Sets the wearer's size.
func set_body(p_size: BodySize) -> void:
	var changed: PersonProfile = _copy_profile()
	changed.size = p_size
	_use(changed)


## Sets the wearer's name.
func rename(p_name: String) -> void:
	var changed: PersonProfile = _copy_profile()
	changed.name = p_name
	_mutex.lock()
	_profile = changed
	_mutex.unlock()


## Sets the calibration to use.
func set_calibration(p_calibration: Calibration) -> void:
	var changed: PersonProfile = _copy_profile()
	changed.calibration = p_calibration
	set_profile(changed)


## Whether samples come out: it is calibrated, and at least one mount is worn.
func is_calibrated() -> bool:
	return get_profile().calibration != null


## Begins a calibration of a kind, at a time in s of any clock. The present one stays in use.
## Returns why it cannot, or an empty text.
func start_calibration(p_kind: CalibrationGuide.Kind, p_now_s: float) -> String:
	var sensors: Array[SensorInfo] = feed.list_sensors()
	var profile: PersonProfile = _profile_for(sensors)
	var mounts: PackedInt32Array = profile.map.of_sensors(sensors)
	var old: Calibration = headings.corrected(profile.calibration)
	return process.start(p_kind, sensors, mounts, old, p_now_s)


## Sets all headings anew while the wearer stands upright and looks ahead: mountings stay, nothing
## else has to be held. Returns why it cannot, or an empty text.
func reset_heading() -> String:
	_mutex.lock()
	var table: SuitTable = _table
	_mutex.unlock()
	var fault: String = headings.reset_ahead(newest_frame, table)
	if fault == "":
		_correct(headings.corrections())
		# Another table: the body is blended into it.
		_use(get_profile())
	return fault


## Accepts the result of the calibration, if there is one.
func accept_calibration() -> void:
	if process.result != null and process.result.error == "":
		quality = process.result
		set_calibration(process.result.calibration)
	process.close()


## Refuses the result: the old calibration stays in use.
func refuse_calibration() -> void:
	process.cancel()


## Goes on, in the main thread: takes new frames, feeds a calibration that runs. The time is in s of
## the clock that [method start_calibration] had.
func advance(p_now_s: float) -> void:
	_mutex.lock()
	_pump()
	var frames: Array[SensorFrame] = _recent
	_recent = []
	var table: SuitTable = _table
	_mutex.unlock()
	var ran: bool = process.is_running()
	for frame: SensorFrame in frames:
		# Frames may have waited while the program did something else: each belongs to the step
		# that ran when it was measured.
		process.advance(p_now_s - (frames[-1].time_usec - frame.time_usec) / 1e6)
		process.add_frame(frame)
		headings.add(frame, table)
		if not process.is_running():
			watch.add(frame, table)
		newest_frame = frame
	if not frames.is_empty():
		_correct(headings.corrections())
		newest_pose = _table_to_show(table).pose(frames[frames.size() - 1])
	process.advance(p_now_s)
	if ran and process.phase == CalibrationProcess.Phase.DONE:
		calibrated.emit(process.result)


## Number of invalid frames of the feed, which were dropped.
func faulty_frames() -> int:
	_mutex.lock()
	var faulty: int = _faulty
	_mutex.unlock()
	return faulty


func get_hip_height() -> float:
	return get_profile().size.length(&"hip_height")


func get_body() -> BodySize:
	return get_profile().size


func get_limb_lengths() -> PackedFloat32Array:
	return get_profile().size.limb_lengths()


func describe() -> String:
	return "%s, worn by %s" % [feed.describe(), get_profile().name]


func _correct(p_drifts: PackedFloat64Array) -> void:
	_mutex.lock()
	_corrections = p_drifts
	_mutex.unlock()


func _use(p_profile: PersonProfile) -> void:
	_mutex.lock()
	_profile = p_profile
	_revision = -1
	_mutex.unlock()
	watch.clear()


func _read(p_time_usec: int) -> PoseSample:
	_mutex.lock()
	_pump()
	var frames: Array[SensorFrame] = _unread
	_unread = []
	var table: SuitTable = _table
	_mutex.unlock()
	if table != _poses_of:
		# Another calibration: the body is blended into it, it would be flung otherwise.
		_poses_of = table
		_poses.clear()
		_passes_from = _last
		_passes_since_usec = p_time_usec
	for frame: SensorFrame in frames.slice(-LivePoses.MAX_POSES):
		var pose: PoseSample = table.pose(frame)
		if pose != null:
			_poses.push(pose, frame.period_s)
	_last = _pass_over(_poses.at(p_time_usec), p_time_usec)
	return _last


## A pose between the last one under the calibration before and the present one.
func _pass_over(p_pose: PoseSample, p_time_usec: int) -> PoseSample:
	var part: float = (p_time_usec - _passes_since_usec) / 1e6 / PASSAGE_S
	if p_pose == null or _passes_from == null or part < 0.0 or part >= 1.0:
		return p_pose
	for limb: int in Limbs.COUNT:
		var before: Quaternion = _passes_from.orientation(limb)
		p_pose.set_orientation(limb, before.slerp(p_pose.orientation(limb), part).normalized())
	p_pose.root = _passes_from.root.lerp(p_pose.root, part)
	return p_pose


## Takes the feed's frames. The mutex is held.
func _pump() -> void:
	if feed == null:
		return
	if _revision != feed.revision:
		_revision = feed.revision
		var sensors: Array[SensorInfo] = feed.list_sensors()
		_profile = _profile_for(sensors)
		_table = SuitTable.new()
		_table.setup(sensors, _profile)
		_table.correct(_corrections)
	for frame: SensorFrame in feed.take_frames():
		if frame.find_fault() != "":
			_faulty += 1
			Log.limited("mocap", "frame", "a sample of the suit is dropped: " + frame.find_fault())
			continue
		_table.remember(frame)
		_unread.append(frame)
		if _unread.size() > MAX_RECENT:
			_unread.pop_front()
		_recent.append(frame)
		if _recent.size() > MAX_RECENT:
			_recent.pop_front()


## The table of a waiting result, or else the one in use.
func _table_to_show(p_table: SuitTable) -> SuitTable:
	if process.phase != CalibrationProcess.Phase.DONE or process.result.calibration == null:
		_trial = null
		return p_table
	if _trial == null:
		var profile: PersonProfile = _copy_profile()
		profile.calibration = process.result.calibration
		_trial = SuitTable.new()
		_trial.setup(feed.list_sensors(), profile)
	_trial.remember(newest_frame)
	return _trial


## The profile; without a map for these sensors it gets the usual one.
func _profile_for(p_sensors: Array[SensorInfo]) -> PersonProfile:
	var knows: bool = p_sensors.is_empty()
	for sensor: SensorInfo in p_sensors:
		knows = knows or _profile.map.mounts.has(sensor.id) and not _profile.map.is_guessed
	if knows:
		return _profile
	var found: PersonProfile = _profile.duplicate()
	found.map = SensorMap.guess(p_sensors)
	return found


func _copy_profile() -> PersonProfile:
	return get_profile().duplicate()

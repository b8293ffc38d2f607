extends SceneTree
## Solves the landmarks that the webcam's helper has found in films, and measures the poses against
## what was filmed: run by the benchmark [code]webcam[/code].
##
## Arguments behind [code]--[/code]: for each film its landmarks (lines of JSON) and its truth, with
## a comma between. Prints a JSON object a film: "arms", "trunk", "legs", each the mean error of its
## limbs, degrees; "limbs", the same of each limb; "seen", the share of frames with a pose of those
## in which all of the person is in view; "solve_ms", the mean time of a solution; "place_m", the
## mean error of the way over the floor; "tilt_deg", how far the camera was taken to look down.

## Limbs that are compared as rotations.
const TRUNK: Array[int] = [Limbs.HIPS, Limbs.CHEST]


func _initialize() -> void:
	for pair: String in OS.get_cmdline_user_args():
		var truth: Dictionary = JSON.parse_string(
			FileAccess.get_file_as_string(pair.get_slice(",", 1))
		)
		print(JSON.stringify(_judge(pair.get_slice(",", 0), truth)))
	quit()


func _judge(p_landmarks: String, p_truth: Dictionary) -> Dictionary:
	var reader: WebcamReader = WebcamReader.new()
	var settings: CameraSettings = CameraSettings.new()
	settings.fov_deg = p_truth["fov_deg"]
	reader.use(settings)
	var frames: Array = p_truth["frames"]
	var step_s: float = frames[1]["time"] - frames[0]["time"]
	var errors: Dictionary[int, PackedFloat32Array] = {}
	var places: PackedFloat32Array = []
	var start: Vector3 = Vector3.INF
	var seen: Dictionary[int, bool] = {}
	var spent_usec: int = 0
	var solved: int = 0
	var lines: FileAccess = FileAccess.open(p_landmarks, FileAccess.READ)
	while not lines.eof_reached():
		var line: PackedByteArray = lines.get_line().to_utf8_buffer()
		var before: int = Time.get_ticks_usec()
		var samples: Array[StreamSample] = reader.read(line, "film")
		if samples.is_empty():
			continue
		spent_usec += Time.get_ticks_usec() - before
		solved += 1
		var number: int = roundi(samples[0].source_usec / 1e6 / step_s)
		if number >= frames.size() or not frames[number]["in_view"]:
			continue
		seen[number] = true
		var pose: PoseSample = samples[0].pose
		_compare(pose, frames[number]["limbs"], errors)
		var root: Array = frames[number]["root"]
		var place: Vector3 = Vector3(root[0], 0.0, root[2])
		if not start.is_finite():
			start = place - pose.root * Vector3(1.0, 0.0, 1.0)
		places.append((place - start - pose.root * Vector3(1.0, 0.0, 1.0)).length())
	var in_view: int = (
		frames.filter(func(frame: Dictionary) -> bool: return frame["in_view"]).size()
	)
	var solver: LandmarkSolver = reader._solvers.values()[0] if solved > 0 else null
	return {
		"film": p_landmarks.get_file().get_basename(),
		"arms": _mean(errors, Limbs.ARMS),
		"trunk": _mean(errors, TRUNK),
		"legs": _mean(errors, Limbs.LEGS),
		"limbs": _by_limb(errors),
		"seen": float(seen.size()) / maxi(in_view, 1),
		"frames": in_view,
		"solve_ms": spent_usec / 1e3 / maxi(solved, 1),
		"place_m": _average(places),
		"tilt_deg": rad_to_deg(solver.tilt()) if solver != null else 0.0,
	}


func _compare(
	p_pose: PoseSample, p_truth: Array, r_errors: Dictionary[int, PackedFloat32Array]
) -> void:
	for limb: int in SyntheticCamera.ALONG.keys() + TRUNK:
		var turn: Quaternion = Quaternion(
			p_truth[4 * limb], p_truth[4 * limb + 1], p_truth[4 * limb + 2], p_truth[4 * limb + 3]
		)
		var found: Quaternion = p_pose.orientation(limb)
		var error: float = Rotations.between_deg(found, turn)
		if SyntheticCamera.ALONG.has(limb):
			error = rad_to_deg(
				(found * SyntheticCamera.ALONG[limb]).angle_to(turn * SyntheticCamera.ALONG[limb])
			)
		if not r_errors.has(limb):
			r_errors[limb] = PackedFloat32Array()
		r_errors[limb].append(error)


func _mean(p_errors: Dictionary[int, PackedFloat32Array], p_limbs: Array[int]) -> float:
	var sum: float = 0.0
	for limb: int in p_limbs:
		sum += _average(p_errors[limb]) if p_errors.has(limb) else 0.0
	return sum / p_limbs.size()


func _by_limb(p_errors: Dictionary[int, PackedFloat32Array]) -> Dictionary:
	var found: Dictionary = {}
	for limb: int in p_errors:
		found[String(Limbs.BONES[limb])] = snappedf(_average(p_errors[limb]), 0.1)
	return found


static func _average(p_values: PackedFloat32Array) -> float:
	var sum: float = 0.0
	for value: float in p_values:
		sum += value
	return sum / maxi(p_values.size(), 1)

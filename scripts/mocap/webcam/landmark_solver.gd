class_name LandmarkSolver
extends RefCounted
## Makes poses of a person's landmarks, picture by picture: keeps backs and fronts apart
## ([FacingKeeper]), smooths points ([LandmarkFilter]), puts them where the picture shows them
## ([CameraView]), turns limbs ([LandmarkPose]), whose lengths are the body's and never change, and
## places the person on the floor.

## Cutoff of the way over the floor at rest, Hz: distances from a camera are poorly seen.
const TRAVEL_HZ: float = 0.5
## Height of the hips of somebody whose height is not known, m.
const USUAL_HIPS_M: float = 0.93

var _settings: CameraSettings = CameraSettings.new()
var _facing: FacingKeeper = FacingKeeper.new()
var _filter: LandmarkFilter = LandmarkFilter.new()
var _ray_filter: LandmarkFilter = LandmarkFilter.new()
var _way_filter: LandmarkFilter = LandmarkFilter.new(TRAVEL_HZ)
var _view: CameraView = CameraView.new()
var _pose: LandmarkPose = LandmarkPose.new()
var _start: Vector3 = Vector3.INF
var _usec: int = 0


func _init(p_settings: CameraSettings = null) -> void:
	if p_settings != null:
		_settings = p_settings


## The pose in a picture, or null where too little of the person is seen.
func solve(p_frame: LandmarkFrame) -> PoseSample:
	var step_s: float = clampf((p_frame.usec - _usec) / 1e6, 0.0, LandmarkFilter.PAUSE_S)
	_usec = p_frame.usec
	var has_rays: bool = not p_frame.rays.is_empty()
	if has_rays:
		_facing.keep(p_frame)
	var places: PackedVector3Array = p_frame.places
	var hips: Vector3 = Vector3.INF
	if has_rays:
		places = _filter.smooth(places, p_frame.seen, p_frame.usec)
		var rays: PackedVector3Array = _ray_filter.smooth(p_frame.rays, p_frame.seen, p_frame.usec)
		places = _turned(places, rays)
		hips = CameraView.place(places, rays, p_frame.seen)
		if hips.is_finite():
			places = _seen_along(places, rays, hips.z)
			_learn_up(places, p_frame.seen, step_s)
			places = _level(places)
	var pose: PoseSample = _pose.make(places, p_frame.seen, step_s)
	if pose != null and hips.is_finite():
		_put_on_floor(pose, _view.level() * hips, p_frame.usec)
	return pose


## Height of the person's hips, m; 0 where nothing is known of it.
func hip_height() -> float:
	if _settings.height_m > 0.0:
		return _settings.height_m * BodySize.RATIOS[&"hip_height"]
	return USUAL_HIPS_M if _start.is_finite() else 0.0


## How far the camera is taken to look down, rad.
func tilt() -> float:
	return _view.tilt


## Points as they are for the camera: the model sees each person as if straight ahead.
static func _turned(p_places: PackedVector3Array, p_rays: PackedVector3Array) -> PackedVector3Array:
	var middle: Vector3 = p_rays[LandmarkPose.HIP] + p_rays[LandmarkPose.HIP + 1]
	middle += p_rays[LandmarkPose.SHOULDER] + p_rays[LandmarkPose.SHOULDER + 1]
	var turn: Quaternion = Quaternion(Vector3.FORWARD, middle.normalized())
	var found: PackedVector3Array = []
	for place: Vector3 in p_places:
		found.append(turn * place)
	return found


## Points as deep as the model says, and where the picture shows them.
static func _seen_along(
	p_places: PackedVector3Array, p_rays: PackedVector3Array, p_deep: float
) -> PackedVector3Array:
	var found: PackedVector3Array = []
	for point: int in p_places.size():
		found.append(p_rays[point] * -minf(p_places[point].z + p_deep, -0.1))
	return found


func _learn_up(p_places: PackedVector3Array, p_seen: PackedFloat32Array, p_step_s: float) -> void:
	var legs: PackedVector3Array = []
	for point: int in [LandmarkPose.SHOULDER, LandmarkPose.HIP, LandmarkPose.ANKLE]:
		if p_seen[point] < CameraView.MIN_SEEN or p_seen[point + 1] < CameraView.MIN_SEEN:
			return
		legs.append((p_places[point] + p_places[point + 1]) / 2.0)
	var knees: float = 0.0
	for side: int in 2:
		var knee: Vector3 = p_places[LandmarkPose.KNEE + side]
		var thigh: Vector3 = knee - p_places[LandmarkPose.HIP + side]
		knees += thigh.angle_to(p_places[LandmarkPose.ANKLE + side] - knee) / 2.0
	_view.learn_up(legs[0] - legs[1], legs[1] - legs[2], knees, p_step_s)


func _level(p_places: PackedVector3Array) -> PackedVector3Array:
	var found: PackedVector3Array = []
	var turn: Basis = _view.level()
	for place: Vector3 in p_places:
		found.append(turn * place)
	return found


## Puts a pose where the person is, from where he was first.
func _put_on_floor(r_pose: PoseSample, p_hips: Vector3, p_usec: int) -> void:
	var scale: float = hip_height() / USUAL_HIPS_M if _settings.height_m > 0.0 else 1.0
	var way: Vector3 = Vector3(p_hips.x, 0.0, p_hips.z) * scale
	way = _way_filter.smooth([way], [1.0], p_usec)[0]
	if not _start.is_finite():
		_start = way
	r_pose.root.x = way.x - _start.x
	r_pose.root.z = way.z - _start.z

extends SceneTree
## Films an avatar that moves by a clip in a world, as a webcam would see it, and writes what is
## true beside: run by the benchmark [code]webcam[/code] with the engine's --write-movie.
##
## Options behind [code]--[/code]: --world=NAME --avatar=NAME --clip=FILE --from=S --turn=DEG (of
## the person about the vertical, 0 looks at the camera) --travel=SHARE (of the clip's way over the
## floor) --place=NAME (of [constant PLACES]) --rate=FPS --seconds=S --truth=FILE.
##
## The truth is a JSON object: "fov_deg" (horizontal), "hip_height" and "frames", each with "time"
## (s), "limbs" (four numbers each, rotations from the reset pose, seen by a camera that is level),
## "root" (m, on the floor below the camera), "joints" (three numbers each, m, from the camera), and
## "in_view": whether all of the person is.

## Where cameras stand: height above the floor, distance from the person, how far the person is to
## the side (m) and how far the camera looks down (degrees).
const PLACES: Dictionary[String, Array] = {
	"desk": [0.9, 2.8, 0.0, -3.0],
	"screen": [1.25, 3.0, 0.0, 7.0],
	"shelf": [2.0, 3.4, 0.0, 18.0],
	"side": [1.3, 3.2, 0.6, 6.0],
	"far": [1.5, 5.0, -0.4, 6.0],
	"low": [0.5, 3.4, 0.3, -8.0],
}
## The camera's field of view across the picture, degrees.
const FOV_DEG: float = 65.0

var _skeleton: Skeleton3D = null
var _person: Ragdoll = null
var _source: BvhSource = BvhSource.new()
var _camera: Camera3D = Camera3D.new()
var _spawn: Transform3D = Transform3D.IDENTITY
var _scale: float = 1.0
var _resets: Dictionary[int, Basis] = {}
var _frames: Array[Dictionary] = []


func _initialize() -> void:
	_film.call_deferred()


func _film() -> void:
	# What a camera's picture of this size shows is hardly sharper, and it takes half the time.
	root.scaling_3d_scale = 0.5
	root.msaa_3d = Viewport.MSAA_DISABLED
	var world: String = _option("world", "yard")
	var path: String = "res://scenes/world/%s/%s.tscn" % [world, world]
	var level: Node = (load(path) as PackedScene).instantiate()
	root.add_child(level)
	_source.open(_option("clip", ""))
	if _source.error != "":
		printerr(_source.error)
		quit(1)
		return
	await physics_frame
	await physics_frame
	_spawn = _find_place(level)
	_add_person()
	_add_camera()
	await process_frame
	var from_s: float = _option("from", "0").to_float()
	var rate: float = _option("rate", "15").to_float()
	for number: int in roundi(_option("seconds", "4").to_float() * rate):
		_pose(from_s + number / rate, number / rate)
		await process_frame
	var truth: FileAccess = FileAccess.open(_option("truth", ""), FileAccess.WRITE)
	var hips: float = _source.get_hip_height() * _scale
	truth.store_string(JSON.stringify({"fov_deg": FOV_DEG, "hip_height": hips, "frames": _frames}))
	truth.close()
	quit()


## The place where people appear, turned to where nothing is between the person and the camera; it
## looks along +Z.
func _find_place(p_level: Node) -> Transform3D:
	var best: Transform3D = Transform3D.IDENTITY
	var most: int = -1
	for spawn: Node in p_level.find_children("*", "SpawnPoint", true, false):
		for turn: int in 8:
			var place: Transform3D = (spawn as Node3D).global_transform
			place.basis = Basis(Vector3.UP, place.basis.get_euler().y + turn * PI / 4.0)
			var free: int = _count_free(place)
			if free > most:
				most = free
				best = place
	return best


## How many of the lines from the camera to where limbs may be are free.
func _count_free(p_place: Transform3D) -> int:
	var place: Array = PLACES[_option("place", "screen")]
	var eye: Vector3 = p_place * Vector3(-place[2], place[0], place[1])
	var space: PhysicsDirectSpaceState3D = root.world_3d.direct_space_state
	var free: int = 0
	for height: float in [0.1, 0.6, 1.2, 1.8]:
		for across: float in [-0.9, -0.45, 0.0, 0.45, 0.9]:
			for deep: float in [-0.5, 0.5]:
				var to: Vector3 = p_place * Vector3(across, height, deep)
				var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(eye, to)
				free += 1 if space.intersect_ray(ray).is_empty() else 0
	return free


func _add_person() -> void:
	var name: String = _option("avatar", "soldier")
	var path: String = AvatarStore.path_of(name)
	path = path if path != "" else "res://scenes/actor/person.tscn"
	_person = (load(path) as PackedScene).instantiate()
	_person.process_mode = Node.PROCESS_MODE_DISABLED
	root.add_child(_person)
	_skeleton = _person.get_skeleton()
	var figure: RestSkeleton = RestSkeleton.new(_skeleton)
	for limb: int in Limbs.COUNT:
		var bone: int = _skeleton.find_bone(Limbs.BONES[limb])
		var rest: Quaternion = figure.rest(Limbs.BONES[limb]).basis.get_rotation_quaternion()
		_resets[bone] = Basis(Limbs.rest_to_reset(limb, figure.direction(limb)) * rest)
	_scale = _person.get_hip_height() / _source.get_hip_height()


func _add_camera() -> void:
	var place: Array = PLACES[_option("place", "screen")]
	_camera.keep_aspect = Camera3D.KEEP_WIDTH
	_camera.fov = FOV_DEG
	var tilt: Basis = Basis(Vector3.RIGHT, -deg_to_rad(place[3]))
	var at: Vector3 = Vector3(-place[2], place[0], place[1])
	root.add_child(_camera)
	_camera.global_transform = _spawn * Transform3D(tilt, at)
	_camera.make_current()


## Poses the person as the clip is at a time, s, and notes what is true.
func _pose(p_clip_s: float, p_time_s: float) -> void:
	var pose: PoseSample = _source.pose_at(p_clip_s)
	var start: PoseSample = _source.pose_at(_option("from", "0").to_float())
	var turn: float = deg_to_rad(_option("turn", "0").to_float())
	turn -= Rotations.yaw_of(start.orientation(Limbs.ROOT))
	var heading: Quaternion = Quaternion(Vector3.UP, turn)
	var travel: Vector3 = heading * (pose.root - start.root) * _scale
	travel *= _option("travel", "1").to_float()
	var hips: Vector3 = Vector3(travel.x, pose.root.y * _scale, travel.z)
	var globals: Array[Transform3D] = []
	var limbs: Array = []
	for limb: int in Limbs.COUNT:
		var own: Quaternion = heading * pose.orientation(limb)
		limbs.append_array([own.x, own.y, own.z, own.w])
	# The skeleton's own space: the person stands at the spawn.
	_person.global_transform = _spawn
	var space: Transform3D = _skeleton.global_transform.affine_inverse() * _spawn
	for bone: int in _skeleton.get_bone_count():
		var above: int = _skeleton.get_bone_parent(bone)
		var base: Transform3D = globals[above] if above >= 0 else Transform3D.IDENTITY
		var now: Transform3D = base * _skeleton.get_bone_rest(bone)
		if _resets.has(bone):
			var limb: int = Limbs.find(_skeleton.get_bone_name(bone))
			now.basis = space.basis * Basis(heading * pose.orientation(limb)) * _resets[bone]
			if limb == Limbs.ROOT:
				now.origin = space * hips
		globals.append(now)
		_skeleton.set_bone_pose(bone, base.affine_inverse() * now)
	var eye: Vector3 = _spawn.affine_inverse() * _camera.global_position
	(
		_frames
		. append(
			{
				"time": p_time_s,
				"limbs": limbs,
				"root": [hips.x - eye.x, hips.y, hips.z - eye.z],
				"joints": _joints(globals, eye),
				"in_view": _is_in_view(globals),
			}
		)
	)


## Where the limbs begin, from the camera, m: three numbers each.
func _joints(p_globals: Array[Transform3D], p_eye: Vector3) -> Array[float]:
	var found: Array[float] = []
	for limb: int in Limbs.COUNT:
		var bone: int = _skeleton.find_bone(Limbs.BONES[limb])
		var at: Vector3 = _skeleton.global_transform * p_globals[bone].origin
		at = _spawn.affine_inverse() * at - p_eye
		found.append_array([at.x, at.y, at.z])
	return found


func _is_in_view(p_globals: Array[Transform3D]) -> bool:
	var size: Vector2 = root.get_visible_rect().size
	for bone: int in _resets:
		var at: Vector3 = _skeleton.global_transform * p_globals[bone].origin
		if _camera.is_position_behind(at):
			return false
		if not Rect2(Vector2.ZERO, size).has_point(_camera.unproject_position(at)):
			return false
	return true


func _option(p_name: String, p_default: String) -> String:
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with("--%s=" % p_name):
			return argument.split("=", true, 1)[1]
	return p_default

extends SceneTree
## Gives a character bodies as the button does, and lets it follow a motion for 5 s of simulated
## time: [code]-- --by=clip[/code] (a BVH file) or [code]--by=animation[/code] (an
## [AnimationPlayer]). Says as JSON how well it did.

const _EXAMPLE: String = "res://addons/ragdoll_motor/example/"
const _SECONDS: float = 5.0

var _ragdoll: Ragdoll = Ragdoll.new()
var _source: BvhSource = null
var _motion: SkeletonMotion = null
var _time_s: float = 0.0
var _turned_deg: float = 0.0


func _initialize() -> void:
	_ragdoll.add_child(_character())
	root.add_child(_ragdoll)
	if OS.get_cmdline_user_args().has("--by=clip"):
		_source = BvhSource.new()
		_source.open(_EXAMPLE + "01_01.bvh")
	else:
		_motion = SkeletonMotion.new(_animated(), _ragdoll)


func _physics_process(p_delta: float) -> bool:
	if _ragdoll.motor == null:
		_ragdoll.make_bodies()
		if not _ragdoll.start():
			return true
		_ragdoll.get_simulator().modification_processed.connect(_look)
	if _time_s > 0.0:
		_ragdoll.motor.measure(_time_s)
	var pose: PoseSample = _motion.sample() if _motion != null else _source.pose_at(_time_s)
	_ragdoll.push_sample(_time_s, pose, pose.root)
	_ragdoll.drive(_time_s, p_delta)
	_time_s += p_delta
	if _time_s < _SECONDS:
		return false
	var found: Dictionary = _ragdoll.motor.get_tracking()
	found["bodies"] = _ragdoll.get_bodies().size()
	found["turned_deg"] = _turned_deg
	print(JSON.stringify(found))
	return true


static func _character() -> Node3D:
	return (load(_EXAMPLE + "soldier.glb") as PackedScene).instantiate()


## An animated copy of the character, which nobody sees.
func _animated() -> Skeleton3D:
	var copy: Node3D = _character()
	copy.hide()
	root.add_child(copy)
	var skeleton: Skeleton3D = copy.find_children("*", "Skeleton3D", true, false)[0]
	var player: AnimationPlayer = AnimationPlayer.new()
	player.callback_mode_process = AnimationMixer.ANIMATION_CALLBACK_MODE_PROCESS_PHYSICS
	copy.add_child(player)
	var library: AnimationLibrary = AnimationLibrary.new()
	library.add_animation(&"wave", _wave(skeleton, copy.get_path_to(skeleton)))
	player.add_animation_library(&"", library)
	player.play(&"wave")
	return skeleton


## Arms down and up again, every two seconds.
static func _wave(p_skeleton: Skeleton3D, p_path: NodePath) -> Animation:
	var wave: Animation = Animation.new()
	wave.length = 2.0
	wave.loop_mode = Animation.LOOP_LINEAR
	for bone: StringName in [&"LeftUpperArm", &"RightUpperArm", &"LeftLowerLeg"]:
		var track: int = wave.add_track(Animation.TYPE_ROTATION_3D)
		wave.track_set_path(track, NodePath("%s:%s" % [p_path, bone]))
		wave.track_set_interpolation_type(track, Animation.INTERPOLATION_CUBIC)
		var index: int = p_skeleton.find_bone(bone)
		var rest: Quaternion = p_skeleton.get_bone_rest(index).basis.get_rotation_quaternion()
		var bent: Quaternion = rest * Quaternion(Vector3.RIGHT, 0.8)
		wave.rotation_track_insert_key(track, 0.0, rest)
		wave.rotation_track_insert_key(track, 1.0, bent)
		wave.rotation_track_insert_key(track, 2.0, rest)
	return wave


## How far the arm that is shown is from the rest pose. What the bodies do to the skeleton can be
## read in this signal only: then the engine gives it its own pose back.
func _look() -> void:
	var skeleton: Skeleton3D = _ragdoll.get_skeleton()
	var bone: int = skeleton.find_bone(&"LeftUpperArm")
	var now: Quaternion = skeleton.get_bone_global_pose(bone).basis.get_rotation_quaternion()
	var rest: Quaternion = skeleton.get_bone_global_rest(bone).basis.get_rotation_quaternion()
	_turned_deg = maxf(_turned_deg, rad_to_deg(now.angle_to(rest)))

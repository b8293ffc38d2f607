extends "stage_case.gd"
## Where bones are while bodies move: as the engine itself would show them, whether it does or not.

const STANDING: Vector3 = Vector3(0.0, 1.0115, 0.0)

var _player: Stage.Player = null
var _skeleton: Skeleton3D = null
## What the engine has shown, bone by bone, and what was said of them at that moment.
var _shown: Array[Transform3D] = []
var _read: Array[Transform3D] = []
var _updates: int = 0


func before_each() -> void:
	super()
	_shown.clear()
	_read.clear()
	_player = _stage.add_soldier(STANDING, RagdollMotor.ROOT_HELD)
	_player.pose = func(_time: float) -> PoseSample: return Stage.arms_pose(60.0, -20.0)
	_skeleton = _player.ragdoll.get_skeleton()
	_skeleton.skeleton_updated.connect(_on_updated)


func test_all_bones_are_where_the_engine_shows_them() -> void:
	await _stage.run(60)
	await process_frames(1)
	equal(_read.size(), _skeleton.get_bone_count())
	for bone: int in _read.size():
		var name: String = _skeleton.get_bone_name(bone)
		almost_equal(_read[bone].origin, _shown[bone].origin, 0.001, name)
		var turn: float = _read[bone].basis.get_rotation_quaternion().angle_to(
			_shown[bone].basis.get_rotation_quaternion()
		)
		is_true(turn < 0.005, "%s is turned by %f" % [name, turn])
	var hand: int = _skeleton.find_bone(&"LeftHand")
	var rest: Vector3 = _skeleton.global_transform * _skeleton.get_bone_global_rest(hand).origin
	is_true(_read[hand].origin.distance_to(rest) > 0.1, "and the arm has moved")


func test_a_skeleton_that_nobody_sees_rests_and_its_bones_are_known() -> void:
	is_true(BoneTransforms.rest(_skeleton))
	await process_frames(2)
	_updates = 0
	await _stage.run(60)
	await process_frames(2)
	equal(_updates, 0)
	var body: PhysicalBone3D = _player.ragdoll.get_simulator().get_node(^"LeftHand")
	var told: Transform3D = _player.ragdoll.get_bone_transform(&"LeftHand") * body.body_offset
	almost_equal(told.origin, body.global_position, 0.001)
	var hand: int = _skeleton.find_bone(&"LeftHand")
	var rest: Vector3 = _skeleton.global_transform * _skeleton.get_bone_global_rest(hand).origin
	is_true(told.origin.distance_to(rest) > 0.1, "it has moved")


func test_one_that_carries_something_moves() -> void:
	var carried: BoneAttachment3D = BoneAttachment3D.new()
	carried.bone_name = "LeftHand"
	_skeleton.add_child(carried)
	is_false(BoneTransforms.rest(_skeleton))
	await _stage.run(60)
	await process_frames(1)
	is_true(_updates > 0)
	var hand: Vector3 = _player.ragdoll.get_bone_transform(&"LeftHand").origin
	almost_equal(carried.global_position, hand, 0.02)


func _on_updated() -> void:
	_updates += 1
	_shown.clear()
	_read.clear()
	for bone: int in _skeleton.get_bone_count():
		_shown.append(_skeleton.global_transform * _skeleton.get_bone_global_pose(bone))
		_read.append(_player.ragdoll.get_bone_transform(_skeleton.get_bone_name(bone)))

class_name VmcWriter
extends StreamWriter
## Writes somebody's poses as the VMC protocol: for other programs (the out direction), and in place
## of one that sends. See [VmcReader] for the frame.

## Bones of one bundle: few enough for a datagram that is not fragmented.
const BONES_PER_BUNDLE: int = 12

var _began_usec: int = -1


func write(p_pose: PoseSample) -> Array[PackedByteArray]:
	if _began_usec < 0 or p_pose.time_usec < _began_usec:
		_began_usec = p_pose.time_usec
	var time: PackedByteArray = Osc.message("/VMC/Ext/T", [(p_pose.time_usec - _began_usec) / 1e6])
	var parts: Array[PackedByteArray] = [
		time,
		Osc.message("/VMC/Ext/OK", [1, 3, 0, 1]),
		_place("/VMC/Ext/Root/Pos", "root", Quaternion.IDENTITY, Vector3.ZERO),
	]
	var datagrams: Array[PackedByteArray] = []
	var bones: Array[PackedByteArray] = _bones(p_pose)
	for at: int in bones.size():
		parts.append(bones[at])
		if at % BONES_PER_BUNDLE == BONES_PER_BUNDLE - 1 or at == bones.size() - 1:
			datagrams.append(Osc.bundle(parts))
			parts = [time]
	return datagrams


func _bones(p_pose: PoseSample) -> Array[PackedByteArray]:
	var turns: Dictionary[int, Quaternion] = _turns(p_pose)
	var bones: Array[PackedByteArray] = []
	for joint: int in turns:
		var above: int = PoseBuilder.parent_of(joint)
		while above >= 0 and not turns.has(above):
			above = PoseBuilder.parent_of(above)
		var turn: Quaternion = turns[joint]
		var offset: Vector3 = p_pose.root
		if above >= 0:
			turn = turns[above].inverse() * turn
			offset = _rest(joint) - _rest(above)
		bones.append(_place("/VMC/Ext/Bone/Pos", UnityBones.name_of(joint), turn, offset))
	return bones


## Rotations in the world by joint, those nearer to the hips first.
func _turns(p_pose: PoseSample) -> Dictionary[int, Quaternion]:
	var known: Dictionary[int, Quaternion] = {}
	if p_pose.details != null:
		known = p_pose.details.joints
	var turns: Dictionary[int, Quaternion] = {}
	for joint: int in PoseBuilder.PARENTS:
		var limb: int = HumanoidAxes.JOINTS.find(joint)
		if limb >= 0:
			turns[joint] = p_pose.orientation(limb).normalized()
		elif known.has(joint):
			turns[joint] = known[joint]
		elif joint == XRBodyTracker.JOINT_NECK:
			var chest: Quaternion = p_pose.orientation(Limbs.CHEST)
			turns[joint] = chest.slerp(p_pose.orientation(Limbs.HEAD), 0.5).normalized()
	for hand: int in 2:
		for joint: int in FingerJoints.of_hand(hand):
			if known.has(joint):
				turns[joint] = known[joint]
	return turns


## Where a joint is in the reset pose, m.
func _rest(p_joint: int) -> Vector3:
	if FingerJoints.hand_of(p_joint) < 0:
		return _figure.rest_of(p_joint)
	var above: int = FingerJoints.parent_of(p_joint)
	return _rest(above) + FingerJoints.offset_of(p_joint, _size.length(&"hand"))


static func _place(
	p_address: String, p_name: String, p_turn: Quaternion, p_place: Vector3
) -> PackedByteArray:
	# Godot's map to Unity's frame is its own inverse.
	var turn: Quaternion = Quaternion(p_turn.x, -p_turn.y, -p_turn.z, p_turn.w)
	var arguments: Array = [p_name, -p_place.x, p_place.y, p_place.z]
	return Osc.message(p_address, arguments + [turn.x, turn.y, turn.z, turn.w])

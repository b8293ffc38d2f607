class_name ContactPoses
extends RefCounted
## Scripted poses for a body of any build: rotations in the world from the reset pose, facing +Z.


## The reset pose, with some limbs (humanoid names) turned.
static func reset(p_turns: Dictionary[StringName, Quaternion] = {}) -> PoseSample:
	var sample: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		sample.set_orientation(limb, p_turns.get(Limbs.BONES[limb], Quaternion.IDENTITY))
	return sample


## Standing with hanging arms.
static func standing(p_person: ContactPerson) -> PoseSample:
	var turns: Dictionary[StringName, Quaternion] = {}
	for side: String in ["Left", "Right"]:
		turns.merge(hanging_arm(p_person, side))
	return reset(turns)


## An arm that hangs down, a little ahead and away from the body.
static func hanging_arm(
	p_person: ContactPerson, p_side: String
) -> Dictionary[StringName, Quaternion]:
	var out: float = 0.25 if p_side == "Left" else -0.25
	var wrist: Vector3 = Vector3(out, -0.93, 0.15).normalized() * 0.97 * p_person.arm_length(p_side)
	return arm(p_person, p_side, wrist, Vector3(0.0, 0.0, -1.0), wrist)


## Both fists before the face, as boxers stand.
static func guard(p_person: ContactPerson) -> PoseSample:
	var turns: Dictionary[StringName, Quaternion] = {}
	for side: String in ["Left", "Right"]:
		var inwards: float = -0.15 if side == "Left" else 0.15
		var wrist: Vector3 = Vector3(inwards, 0.2, 0.6) * p_person.arm_length(side)
		turns.merge(arm(p_person, side, wrist, Vector3.DOWN, Vector3.UP))
	return reset(turns)


## One arm (the right one) that brings the wrist to a place, the fist pointing ahead; the other one
## hangs.
static func fist_at(p_person: ContactPerson, p_wrist: Vector3) -> PoseSample:
	var turns: Dictionary[StringName, Quaternion] = hanging_arm(p_person, "Left")
	turns.merge(arm(p_person, "Right", p_wrist, Vector3(-0.3, -1.0, -0.3), Vector3.BACK))
	return reset(turns)


## Arms that are held out (0) or closed (1) around somebody in front, turned by a heading, rad.
static func hug(p_person: ContactPerson, p_closed: float, p_heading: float) -> PoseSample:
	var facing: Quaternion = Quaternion(Vector3.UP, p_heading)
	var turns: Dictionary[StringName, Quaternion] = {}
	for side: String in ["Left", "Right"]:
		var out: float = 1.0 if side == "Left" else -1.0
		# One arm goes above, one below that of the other person.
		var height: float = 0.15 if side == "Left" else -0.35
		var open: Vector3 = Vector3(0.45 * out, height, 0.8)
		var shut: Vector3 = Vector3(-0.55 * out, height, 0.55)
		var wrist: Vector3 = open.lerp(shut, p_closed) * p_person.arm_length(side)
		turns.merge(arm(p_person, side, wrist, Vector3(out, -0.3, 0.0), Vector3.ZERO))
	for bone: StringName in Limbs.BONES:
		turns[bone] = facing * turns.get(bone, Quaternion.IDENTITY)
	return reset(turns)


## The turns of an arm whose wrist is to be at a place relative to the shoulder, m. The elbow lies
## towards [param p_elbow]; the hand points to [param p_hand], or along the lower arm if that is 0.
static func arm(
	p_person: ContactPerson, p_side: String, p_wrist: Vector3, p_elbow: Vector3, p_hand: Vector3
) -> Dictionary[StringName, Quaternion]:
	var upper: float = p_person.length_of(StringName(p_side + "UpperArm"))
	var lower: float = p_person.length_of(StringName(p_side + "LowerArm"))
	var reach: float = clampf(
		p_wrist.length(), absf(upper - lower) * 1.01 + 0.001, (upper + lower) * 0.9999
	)
	var ahead: Vector3 = p_wrist.normalized()
	var aside: Vector3 = (p_elbow - ahead * p_elbow.dot(ahead)).normalized()
	var along: float = (upper * upper - lower * lower + reach * reach) / (2.0 * reach)
	var away: float = sqrt(maxf(upper * upper - along * along, 0.0))
	var elbow: Vector3 = ahead * along + aside * away
	var reset_direction: Vector3 = Vector3.RIGHT if p_side == "Left" else Vector3.LEFT
	var shoulder_turn: Quaternion = Quaternion(reset_direction, elbow.normalized())
	var forearm: Vector3 = (ahead * reach - elbow).normalized()
	# Relative to what is above, so that no turn comes near half a circle.
	var elbow_turn: Quaternion = Quaternion(elbow.normalized(), forearm) * shoulder_turn
	var hand_turn: Quaternion = elbow_turn
	if not p_hand.is_zero_approx():
		hand_turn = Quaternion(forearm, p_hand.normalized()) * elbow_turn
	return {
		StringName(p_side + "UpperArm"): shoulder_turn,
		StringName(p_side + "LowerArm"): elbow_turn,
		StringName(p_side + "Hand"): hand_turn,
	}


## From 0 to 1 with speed and acceleration 0 at both ends (the least jerk).
static func smooth(p_share: float) -> float:
	var share: float = clampf(p_share, 0.0, 1.0)
	return share * share * share * (10.0 + share * (6.0 * share - 15.0))

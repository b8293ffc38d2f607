class_name GuideMovements
extends RefCounted
## The movements that a wearer is asked to make, and how they turn each mount of the body.

## Movements. All but ARMS and ARMS_UP start and end in the N-pose.
enum Movement {
	## None: a pose is held.
	NONE,
	## From T to N, both arms.
	ARMS,
	## Forward from the hips and up again, back straight.
	BOW,
	## Down and up again, heels on the floor.
	SQUAT,
	## Both arms, straight, up to the front and down again.
	REACH,
	## From N to T, both arms.
	ARMS_UP,
	## On the toes and down again.
	RISE,
	## The left elbow, up to the front and down again.
	LEFT_ELBOW,
	## The right elbow.
	RIGHT_ELBOW,
	## The left arm, straight, up to the side and down again.
	LEFT_ARM,
	## The right arm.
	RIGHT_ARM,
	## The left hand alone, towards the palm and back.
	LEFT_WRIST,
	## The right hand alone.
	RIGHT_WRIST,
	## The left shoulder, up and down.
	LEFT_SHRUG,
	## The right shoulder.
	RIGHT_SHRUG,
	## The head, to the left and back.
	HEAD,
	## Chest, head and arms to the left and back, the hips ahead.
	TWIST,
	## The left knee, up to the front, the shank hanging.
	LEFT_KNEE,
	## The right knee.
	RIGHT_KNEE,
	## The left heel, up to the back, the thigh hanging.
	LEFT_HEEL,
	## The right heel.
	RIGHT_HEEL,
}

## The instruction to the wearer, by [enum Movement].
const TEXTS: PackedStringArray = [
	"",
	"Bring both arms down to your thighs, straight, palms turning in.",
	"Bow forward with a straight back, then come up again.",
	"Squat halfway with the knees ahead, heels down, then come up again.",
	"Raise both arms straight to the front, thumbs up, then lower them.",
	"Raise both arms straight out to the sides again, palms down.",
	"Rise on your toes, then come down again.",
	"Bend the left elbow to the front, then straighten it.",
	"Bend the right elbow to the front, then straighten it.",
	"Raise the left arm straight out to the side, then lower it.",
	"Raise the right arm straight out to the side, then lower it.",
	"Bend the left hand towards its palm, then straighten it; keep the arm still.",
	"Bend the right hand towards its palm, then straighten it; keep the arm still.",
	"Lift the left shoulder, then drop it; keep the arm hanging.",
	"Lift the right shoulder, then drop it; keep the arm hanging.",
	"Look to the left, then ahead again; move only the head.",
	"Turn chest and arms to the left, then ahead again; keep the hips still.",
	"Lift the left knee to the front, the shank hanging, then put the foot down.",
	"Lift the right knee to the front, the shank hanging, then put the foot down.",
	"Lift the left heel to the back, the thigh hanging, then put the foot down.",
	"Lift the right heel to the back, the thigh hanging, then put the foot down.",
]

## How far mounts are turned in the middle of a movement: mounts of [BodyMounts] and rotation
## vectors in degrees, for somebody who faces +Z, of the left side. The right side mirrors it.
## ARMS and ARMS_UP are [method ResetPose.rotation].
const _TURNS: Dictionary[Movement, Dictionary] = {
	Movement.BOW:
	{
		0: Vector3(30, 0, 0),
		1: Vector3(50, 0, 0),
		2: Vector3(55, 0, 0),
		3: Vector3(50, 0, 0),
		7: Vector3(50, 0, 0)
	},
	Movement.SQUAT:
	{11: Vector3(-60, 0, 0), 12: Vector3(35, 0, 0), 14: Vector3(-60, 0, 0), 15: Vector3(35, 0, 0)},
	Movement.REACH:
	{
		4: Vector3(-80, 0, 0),
		5: Vector3(-80, 0, 0),
		6: Vector3(-80, 0, 0),
		8: Vector3(-80, 0, 0),
		9: Vector3(-80, 0, 0),
		10: Vector3(-80, 0, 0)
	},
	Movement.RISE: {13: Vector3(30, 0, 0), 16: Vector3(30, 0, 0)},
	Movement.LEFT_ELBOW: {5: Vector3(-90, 0, 0), 6: Vector3(-90, 0, 0)},
	Movement.LEFT_ARM:
	{3: Vector3(0, 0, 15), 4: Vector3(0, 0, 90), 5: Vector3(0, 0, 90), 6: Vector3(0, 0, 90)},
	Movement.LEFT_WRIST: {6: Vector3(0, 0, -45)},
	Movement.LEFT_SHRUG: {3: Vector3(0, 0, 18)},
	Movement.HEAD: {2: Vector3(0, 55, 0)},
	Movement.TWIST:
	{
		0: Vector3(0, 8, 0),
		1: Vector3(0, 40, 0),
		2: Vector3(0, 40, 0),
		3: Vector3(0, 40, 0),
		4: Vector3(0, 40, 0),
		5: Vector3(0, 40, 0),
		6: Vector3(0, 40, 0),
		7: Vector3(0, 40, 0),
		8: Vector3(0, 40, 0),
		9: Vector3(0, 40, 0),
		10: Vector3(0, 40, 0)
	},
	Movement.LEFT_KNEE: {11: Vector3(-80, 0, 0), 12: Vector3(10, 0, 0), 13: Vector3(20, 0, 0)},
	Movement.LEFT_HEEL: {11: Vector3(-8, 0, 0), 12: Vector3(80, 0, 0), 13: Vector3(85, 0, 0)},
}

## Movements of the right side, and those that they mirror.
const _MIRRORS: Dictionary[Movement, Movement] = {
	Movement.RIGHT_ELBOW: Movement.LEFT_ELBOW,
	Movement.RIGHT_ARM: Movement.LEFT_ARM,
	Movement.RIGHT_WRIST: Movement.LEFT_WRIST,
	Movement.RIGHT_SHRUG: Movement.LEFT_SHRUG,
	Movement.RIGHT_KNEE: Movement.LEFT_KNEE,
	Movement.RIGHT_HEEL: Movement.LEFT_HEEL,
}


## How a movement turns a mount out of its pose in its middle: a rotation vector, degrees, for
## somebody who faces +Z.
static func turn_deg(p_movement: Movement, p_mount: int) -> Vector3:
	if p_movement == Movement.ARMS or p_movement == Movement.ARMS_UP:
		var down: Vector3 = Rotations.vector(ResetPose.rotation(ResetPose.Kind.N, p_mount))
		return down * (180.0 / PI if p_movement == Movement.ARMS else -180.0 / PI)
	if _MIRRORS.has(p_movement):
		var left: Vector3 = turn_deg(_MIRRORS[p_movement], BodyMounts.MIRRORS[p_mount])
		return Vector3(left.x, -left.y, -left.z)
	var turns: Dictionary = _TURNS.get(p_movement, {})
	return turns.get(p_mount, Vector3.ZERO)


## Whether a movement goes from pose to pose and not back.
static func is_passage(p_movement: Movement) -> bool:
	return p_movement == Movement.ARMS or p_movement == Movement.ARMS_UP


## The axis about which a movement turns a mount, level and of length 1, for somebody who faces +Z;
## zero if it leaves it. Only movements that everybody makes about one axis have one.
static func axis(p_movement: Movement, p_mount: int) -> Vector3:
	if p_movement > Movement.RISE or p_movement == Movement.NONE:
		return Vector3.ZERO
	return turn_deg(p_movement, p_mount).normalized()


## The movements that distinguish the mounts which are worn.
static func informative(p_mounts: PackedInt32Array) -> Array[Movement]:
	var found: Array[Movement] = []
	for movement: Movement in Movement.values():
		if movement <= Movement.ARMS_UP:
			continue
		for mount: int in p_mounts:
			# The turn of the chest is for pelvis and sternum: it moves much besides.
			var about: bool = movement != Movement.TWIST or mount < 2
			if about and turn_deg(movement, mount).length() > 14.0 and not found.has(movement):
				found.append(movement)
	return found

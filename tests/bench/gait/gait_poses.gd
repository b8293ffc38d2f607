extends RefCounted
## Poses on the ground, from standing to lying, for a body in its T-pose at rest that looks along
## +Z.

## Trunk, left thigh and shin, right thigh and shin, feet, arms: how far each is swung ahead, rad.
## Then how far the whole body is pitched ahead and rolled to its right.
const POSES: Dictionary[String, Array] = {
	"standing": [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
	"half squat": [0.3, 0.7, -0.5, 0.7, -0.5, 0.0, 0.3, 0.0, 0.0],
	"squat": [0.6, 1.7, -0.9, 1.7, -0.9, 0.0, 0.6, 0.0, 0.0],
	"lunge": [0.1, 1.2, 0.1, -0.6, -1.2, 0.0, 0.0, 0.0, 0.0],
	"touching the toes": [2.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
	"kneeling": [0.0, 0.0, -1.55, 0.0, -1.55, -1.4, 0.0, 0.0, 0.0],
	"kneeling on one knee": [0.1, 1.5, 0.0, 0.0, -1.55, 0.0, 0.0, 0.0, 0.0],
	"sitting on the heels": [0.1, 1.3, -1.55, 1.3, -1.55, -1.4, 0.2, 0.0, 0.0],
	"sitting, legs stretched": [-0.1, 1.5, 1.5, 1.5, 1.5, 0.2, 0.2, 0.0, 0.0],
	"sitting, knees up": [0.2, 2.2, 0.5, 2.2, 0.5, 0.0, 0.6, 0.0, 0.0],
	"sitting, leaning back": [-0.6, 1.5, 1.0, 1.5, 1.0, 0.0, -0.8, 0.0, 0.0],
	"on all fours": [1.45, 0.0, -1.55, 0.0, -1.55, -1.4, 0.0, 0.0, 0.0],
	"on hands and feet": [1.7, 0.6, -0.3, 0.6, -0.3, 0.0, 0.2, 0.0, 0.0],
	"plank": [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.4, 1.35, 0.0],
	"lying on the face": [0.0, 0.0, 0.0, 0.0, 0.0, -1.2, 0.0, 1.55, 0.0],
	"lying on the back": [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.55, 0.0],
	"lying on the back, knees up": [0.0, 0.9, -0.7, 0.9, -0.7, 0.0, 0.0, -1.55, 0.0],
	"lying on the left": [0.0, 0.2, -0.2, 0.2, -0.2, 0.0, 0.3, 0.0, -1.55],
	"lying on the right": [0.0, 0.2, -0.2, 0.2, -0.2, 0.0, 0.3, 0.0, 1.55],
	"curled up on the right": [0.4, 1.6, -0.6, 1.6, -0.6, 0.0, 1.2, 0.0, 1.55],
}


## The pose of a name; its root is not known.
static func pose_of(p_name: String) -> PoseSample:
	return make(POSES[p_name])


## The same from its numbers.
static func make(p_numbers: Array) -> PoseSample:
	var sample: PoseSample = PoseSample.new()
	var whole: Quaternion = (
		Quaternion(Vector3.BACK, -float(p_numbers[8]))
		* Quaternion(Vector3.RIGHT, float(p_numbers[7]))
	)
	# Trunk and head point up, so that leaning ahead is the other sense of turning.
	var swings: Array[float] = []
	swings.resize(Limbs.COUNT)
	for limb: int in [0, 1, 2, 3]:
		swings[limb] = -float(p_numbers[0])
	for limb: int in [4, 5, 6, 7, 8, 9]:
		swings[limb] = p_numbers[6]
	for side: int in 2:
		swings[10 + 3 * side] = p_numbers[1 + 2 * side]
		swings[11 + 3 * side] = p_numbers[2 + 2 * side]
		swings[12 + 3 * side] = p_numbers[5]
	for limb: int in Limbs.COUNT:
		var turn: Quaternion = Quaternion(Vector3.RIGHT, -swings[limb])
		if limb in [4, 5, 6, 7, 8, 9]:
			turn = turn * Quaternion(Vector3.BACK, -1.4 if limb < 7 else 1.4)
		sample.set_orientation(limb, whole * turn)
	return sample

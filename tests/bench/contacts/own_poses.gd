class_name OwnPoses
extends RefCounted
## Poses in which people touch themselves, for a body of any build, each somewhat different for each
## seed. Wearers are slimmer than bodies: most of these go deep into them.

## Wrist from the shoulder as a share of the arm, elbow and fingers' direction (none: along the
## forearm), for the left arm; the right one is mirrored. X points to the left, Z ahead. Two rows
## are left and right arm.
const _ARMS: Dictionary[String, Array] = {
	"crossed arms":
	[
		[Vector3(-0.75, -0.35, 0.42), Vector3(1.0, -0.6, -0.3), Vector3.ZERO],
		[Vector3(-0.75, -0.25, 0.5), Vector3(1.0, -0.6, -0.3), Vector3.ZERO],
	],
	"hands on hips":
	[[Vector3(-0.05, -0.75, 0.15), Vector3(1.0, 0.0, -0.5), Vector3(-1.0, -0.3, 0.5)]],
	"hug oneself":
	[
		[Vector3(-0.85, -0.1, 0.25), Vector3(0.5, -1.0, 0.3), Vector3(-0.7, 0.0, -0.7)],
		[Vector3(-0.85, -0.3, 0.3), Vector3(0.5, -1.0, 0.3), Vector3(-0.7, 0.0, -0.7)],
	],
	"praying": [[Vector3(-0.38, -0.2, 0.5), Vector3(1.0, -0.8, 0.0), Vector3(0.0, 1.0, 0.3)]],
	"hand to the face":
	[[Vector3(-0.3, 0.3, 0.25), Vector3(1.0, -0.8, 0.3), Vector3(-0.3, 1.0, -0.2)], []],
	"hands behind the back":
	[[Vector3(-0.35, -0.8, -0.25), Vector3(1.0, 0.0, -1.0), Vector3(-1.0, -0.2, 0.0)]],
	"hands on the head":
	[[Vector3(-0.2, 0.55, 0.1), Vector3(1.0, 0.3, 0.2), Vector3(-1.0, 0.0, 0.0)]],
	"hands in the neck":
	[[Vector3(-0.25, 0.35, -0.1), Vector3(1.0, 0.3, 0.2), Vector3(-1.0, 0.0, -0.3)]],
	"crossed wrists":
	[[Vector3(-0.5, -0.4, 0.4), Vector3(1.0, -0.8, 0.0), Vector3(-0.6, 0.0, 0.6)]],
	"hand on the heart":
	[[Vector3(-0.35, -0.25, 0.15), Vector3(1.0, -0.8, 0.2), Vector3(-1.0, 0.2, 0.0)], []],
	"hands on the belly":
	[[Vector3(-0.3, -0.6, 0.25), Vector3(1.0, -0.4, -0.3), Vector3(-1.0, 0.0, 0.0)]],
	"clasped hands":
	[[Vector3(-0.33, -0.7, 0.45), Vector3(1.0, -0.3, -0.2), Vector3(-0.5, -0.3, 0.8)]],
	"hanging arms":
	[[Vector3(-0.02, -1.0, 0.02), Vector3(0.0, 0.0, -1.0), Vector3(0.0, -1.0, 0.0)]],
	"hand on the other shoulder":
	[[Vector3(-0.75, 0.05, 0.3), Vector3(0.5, -1.0, 0.5), Vector3(-0.8, 0.1, -0.5)], []],
	"hand at the other hip":
	[[Vector3(-0.6, -0.7, 0.25), Vector3(0.6, -0.2, -0.3), Vector3(-0.6, -0.8, 0.0)], []],
	"one hand in the back":
	[
		[Vector3(-0.4, -0.5, -0.3), Vector3(1.0, 0.0, -1.0), Vector3(-0.8, 0.6, 0.0)],
		[Vector3(-0.05, -0.75, 0.15), Vector3(1.0, 0.0, -0.5), Vector3(-1.0, -0.3, 0.5)],
	],
	"fists at the chin":
	[[Vector3(-0.35, 0.12, 0.3), Vector3(0.4, -1.0, 0.3), Vector3(-0.2, 1.0, 0.0)]],
	"crossed legs": [[Vector3(0.05, -0.95, 0.1), Vector3(0.0, 0.0, -1.0), Vector3(0.0, -1.0, 0.0)]],
	"hands on the thighs":
	[[Vector3(-0.1, -0.9, 0.35), Vector3(0.6, 0.0, -1.0), Vector3(0.0, -0.7, 0.7)]],
	"arms round the knees":
	[[Vector3(-0.4, -0.6, 0.65), Vector3(1.0, -0.2, 0.0), Vector3(-1.0, 0.0, 0.0)]],
}
## How far wrists, elbows and fingers are off from seed to seed, as shares.
const _SPREAD: float = 0.1


## The names of all poses.
static func names() -> Array[String]:
	return _ARMS.keys()


## A pose, given by how far it is entered: 0 is standing, 1 the pose.
static func pose(
	p_person: ContactPerson, p_name: String, p_seed: int, p_share: float
) -> PoseSample:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = hash(p_name) + p_seed
	var turns: Dictionary[StringName, Quaternion] = {}
	var rows: Array = _ARMS[p_name]
	for number: int in 2:
		var side: String = "Left" if number == 0 else "Right"
		var row: Array = rows[number % rows.size()]
		var wrist: Vector3 = _varied(random, row[0] if not row.is_empty() else Vector3.ZERO)
		var elbow: Vector3 = _varied(random, row[1] if not row.is_empty() else Vector3.ZERO)
		var hand: Vector3 = _varied(random, row[2] if not row.is_empty() else Vector3.ZERO)
		var arm: Dictionary[StringName, Quaternion] = ContactPoses.hanging_arm(p_person, side)
		if not row.is_empty():
			var length: float = p_person.arm_length(side)
			var mirror: Vector3 = Vector3.ONE if number == 0 else Vector3(-1.0, 1.0, 1.0)
			if (row[2] as Vector3).is_zero_approx():
				hand = Vector3.ZERO
			arm = ContactPoses.arm(
				p_person, side, wrist * mirror * length, elbow * mirror, hand * mirror
			)
		turns.merge(arm)
	_add_legs(turns, p_name, random)
	return _between(ContactPoses.standing(p_person), ContactPoses.reset(turns), p_share)


static func _varied(p_random: RandomNumberGenerator, p_vector: Vector3) -> Vector3:
	var off: Vector3 = (
		Vector3(p_random.randf(), p_random.randf(), p_random.randf()) * 2.0 - Vector3.ONE
	)
	return p_vector + off * _SPREAD


static func _add_legs(
	r_turns: Dictionary[StringName, Quaternion], p_name: String, p_random: RandomNumberGenerator
) -> void:
	if p_name == "crossed legs":
		var across: float = deg_to_rad(p_random.randf_range(14.0, 20.0))
		for side: String in ["Left", "Right"]:
			var aside: float = -1.0 if side == "Left" else 1.0
			var ahead: Quaternion = Quaternion(Vector3.RIGHT, deg_to_rad(6.0 * aside))
			var leg: Quaternion = Quaternion(Vector3.BACK, aside * across) * ahead
			r_turns[StringName(side + "UpperLeg")] = leg
			r_turns[StringName(side + "LowerLeg")] = leg
	elif p_name == "arms round the knees" or p_name == "hands on the thighs":
		var deep: float = (
			p_random.randf_range(0.6, 1.0) * (1.0 if p_name.begins_with("arms") else 0.5)
		)
		_crouch(r_turns, deep)


## Thighs up, shins back, trunk ahead: over the feet.
static func _crouch(r_turns: Dictionary[StringName, Quaternion], p_deep: float) -> void:
	var lean: Quaternion = Quaternion(Vector3.RIGHT, deg_to_rad(45.0) * p_deep)
	for side: String in ["Left", "Right"]:
		r_turns[StringName(side + "UpperLeg")] = Quaternion(Vector3.LEFT, deg_to_rad(95.0) * p_deep)
		r_turns[StringName(side + "LowerLeg")] = Quaternion(
			Vector3.RIGHT, deg_to_rad(38.0) * p_deep
		)
	for bone: StringName in Limbs.BONES:
		if not String(bone).ends_with("Leg") and not String(bone).ends_with("Foot"):
			r_turns[bone] = lean * r_turns.get(bone, Quaternion.IDENTITY)


static func _between(p_from: PoseSample, p_to: PoseSample, p_share: float) -> PoseSample:
	var result: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		result.set_orientation(
			limb, p_from.orientation(limb).slerp(p_to.orientation(limb), p_share)
		)
	return result

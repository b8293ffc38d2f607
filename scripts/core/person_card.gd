class_name PersonCard
extends RefCounted
## What a client sends about a person whose motion it sends: name and size.

## People whose motion one client may send.
const MAX_PEOPLE: int = 8
## Limits of a hip height, m.
const MIN_HIPS_M: float = 0.2
const MAX_HIPS_M: float = 2.0
## Limits of a limb's length, m.
const MIN_LENGTH_M: float = 0.03
const MAX_LENGTH_M: float = 1.2
## Longest name of an avatar, bytes.
const MAX_AVATAR: int = 32

## Which of the client's people it is, 0 to [constant MAX_PEOPLE] - 1; its samples carry the same
## number.
var index: int = 0
## Shown to the others; empty: the client's own name.
var name: String = ""
## Name of the avatar that the person is shown as; empty, or one that is not known: the default's.
var avatar: String = ""
## Height of the wearer's hips when standing, m.
var hip_height: float = 0.95
## Length of each limb of [constant Limbs.BONES], m, 0 where it is not known; empty: none is.
##
## From a limb's joint to its end in [constant Limbs.TAILS]: the hand's to the knuckle of the
## middle finger, the foot's from the ankle to the ball, the head's from its joint to the crown.
## Hips, spine and chest count as one sum.
var lengths: PackedFloat32Array = PackedFloat32Array()


## A card with a name and a size.
static func of(p_name: String, p_hip_height: float, p_index: int = 0) -> PersonCard:
	var card: PersonCard = PersonCard.new()
	card.index = p_index
	card.name = p_name
	card.hip_height = p_hip_height
	return card


## Sets a size, m, as far as it can be a person's: an impossible length counts as unknown.
func take_size(p_hip_height: float, p_lengths: PackedFloat32Array) -> void:
	if is_finite(p_hip_height):
		hip_height = clampf(p_hip_height, MIN_HIPS_M + 0.01, MAX_HIPS_M - 0.01)
	lengths = p_lengths.duplicate()
	for limb: int in lengths.size():
		if not (lengths[limb] > MIN_LENGTH_M and lengths[limb] < MAX_LENGTH_M):
			lengths[limb] = 0.0


## Whether another card's size differs by more than so much, m.
func is_resized(p_other: PersonCard, p_step: float) -> bool:
	if absf(hip_height - p_other.hip_height) > p_step or lengths.size() != p_other.lengths.size():
		return true
	for limb: int in lengths.size():
		if absf(lengths[limb] - p_other.lengths[limb]) > p_step:
			return true
	return false


## Why this cannot be a person's, or an empty text if it can.
func find_fault() -> String:
	if index < 0 or index >= MAX_PEOPLE:
		return "a client has at most %d people, found number %d" % [MAX_PEOPLE, index]
	# A comparison that NaN fails, too.
	if not (hip_height > MIN_HIPS_M and hip_height < MAX_HIPS_M):
		return "a hip height of %f m is no person's" % hip_height
	if not lengths.is_empty() and lengths.size() != Limbs.COUNT:
		return "%d limbs' lengths instead of %d" % [lengths.size(), Limbs.COUNT]
	for limb: int in lengths.size():
		var length: float = lengths[limb]
		if not (length == 0.0 or (length > MIN_LENGTH_M and length < MAX_LENGTH_M)):
			return "%s of %f m is no person's" % [Limbs.BONES[limb], length]
	return ""


## Whether another card describes the same body.
func is_same_body(p_other: PersonCard) -> bool:
	return (
		hip_height == p_other.hip_height and lengths == p_other.lengths and avatar == p_other.avatar
	)

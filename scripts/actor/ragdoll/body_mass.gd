@tool
class_name BodyMass
extends RefCounted
## Mass and strength of a figure, by its size.
##
## The one place that knows how people of other sizes weigh and how strong they are. The mass of
## adults goes with the square of their height (Quetelet 1835, the body mass index; Heymsfield et
## al. 2007, Scaling of human body composition to stature, found powers of about 2). A joint's
## torque goes with its cube: the force of a muscle with its area, which is h², times the lever,
## which is h (Jaric 2002, Muscle strength testing: use of normalisation for body size). So torque
## keeps step with weight times length: relative strength is the same at any size. The volume of a
## mesh is not used: clothes, hair and gear have much volume and little mass.

## An average adult: height, m, mass, kg, and how high the hip joints are, as a share of the height
## (Winter 2009, Biomechanics and Motor Control of Human Movement, fig. 4.1).
const ADULT_HEIGHT: float = 1.8
const ADULT_MASS: float = 80.0
const HIPS_HEIGHT: float = 0.53
## Bounds of a profile's mass, kg.
const LIGHTEST: float = 1.0
const HEAVIEST: float = 1000.0


## Sets the mass of a profile that is made for a figure, and scales the torques of its limbs, which
## are an adult's.
static func fill(p_profile: RagdollProfile, p_figure: RestSkeleton) -> void:
	var size: float = stature(p_figure) / ADULT_HEIGHT
	# The estimate is no better than tenths of a kilogram.
	p_profile.mass = snappedf(scaled_mass(ADULT_MASS, size), 0.1)
	for limb: RagdollLimb in p_profile.limbs:
		limb.max_torque *= torque_factor(size)


## The mass of somebody who is so much taller, kg.
static func scaled_mass(p_mass: float, p_taller: float) -> float:
	return clampf(p_mass * mass_factor(p_taller), LIGHTEST, HEAVIEST)


## By how much somebody is heavier who is so much taller.
static func mass_factor(p_taller: float) -> float:
	return p_taller ** 2


## By how much the joints of somebody are stronger who is so much taller.
static func torque_factor(p_taller: float) -> float:
	return p_taller ** 3


## How tall a figure is, m, by the height of its hip joints above straight legs: not every skeleton
## has where the head ends, and many stand with their legs apart at rest.
static func stature(p_figure: RestSkeleton) -> float:
	var lowest: float = INF
	for side: String in ["Left", "Right"]:
		for bone: String in ["Foot", "Toes"]:
			if p_figure.has(StringName(side + bone)):
				lowest = minf(lowest, p_figure.rest(StringName(side + bone)).origin.y)
	var hips: float = p_figure.rest(&"LeftUpperLeg").origin.y
	# The origin of a figure is between its soles, if it is anywhere near them.
	var ground: float = 0.0 if absf(lowest) < 0.15 * absf(hips) else lowest
	return (hips - ground + _lowered(p_figure)) / HIPS_HEIGHT


## By how much the hip joints are lower at rest than over straight, upright legs, m.
static func _lowered(p_figure: RestSkeleton) -> float:
	var hip: Vector3 = p_figure.rest(&"LeftUpperLeg").origin
	var knee: Vector3 = p_figure.rest(&"LeftLowerLeg").origin
	var ankle: Vector3 = p_figure.rest(&"LeftFoot").origin
	return hip.distance_to(knee) + knee.distance_to(ankle) - (hip.y - ankle.y)

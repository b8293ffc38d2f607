// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace wire {

/// The chart that most limbs are in: it drops w, its parts have the axes of the limb and its parent.
constexpr int USUAL_CHART = 3;
/// Kinds of limbs that share parameters: left and right move alike.
constexpr int LIMB_CLASSES = 11;
/// Steps of speed for which the share of the velocity is given.
constexpr int GAIN_STEPS = 8;
/// Points of a distribution, from the middle outwards, a sixteenth of the spread apart.
constexpr int SHARE_POINTS = 193;
/// Distributions to choose from, the ones with the heaviest tails first.
constexpr int SHAPES = 8;

/// Parameters of predictions: of the root's position, or of rotations. All are trained.
struct MotionModel {
	int16_t gains[GAIN_STEPS]; ///< By speed: share of the velocity that is believed, 1 / 256.
	int16_t biases[LIMB_CLASSES]; ///< By class: level where nothing else is known, 1 / 16 octave.
	int16_t part_biases[LIMB_CLASSES][3]; ///< By class and part, added in the usual chart.
	int16_t pulls[LIMB_CLASSES][3]; ///< By class and part: share of the parent's turn, 1 / 256.
	int16_t passes[LIMB_CLASSES]; ///< By class: share of its pull that a limb hands on to its children, 1 / 256.
	int16_t speed; ///< What follows are weights in 1 / 64: of the limb's speed,
	int16_t part_speed; ///< of the part's speed,
	int16_t parent; ///< of how wrong the prediction of the parent was,
	int16_t average; ///< of those before it,
	int16_t part; ///< of this limb's parts before this one.
	int16_t along; ///< How firmly errors lie along the velocity: less is more, 1 / 256.
	int16_t shapes[3]; ///< By part: which of SHARES_WITHIN.
};

/// All parameters for one age of the base and one resolution.
struct PersonModel {
	MotionModel root;
	MotionModel rotation;
};

} // namespace wire

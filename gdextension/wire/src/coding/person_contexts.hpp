// SPDX-License-Identifier: MIT
#pragma once

#include "coding/person_coder.hpp"
#include "coding/person_tables.hpp" // Made by tools/wire/train_models.sh.

namespace wire {

/// Index of an age (ticks) in the tables.
inline int age_step(int p_age) {
	int step = 0;
	while (step < AGE_STEPS - 1 && p_age > LAST_OF_AGE_STEP[step]) {
		step++;
	}
	return step;
}

/// Which tables there are for a resolution: 0 fine, 1 coarse.
inline int precision_step(int p_resolution) {
	return p_resolution >= MIN_FINE ? 0 : 1;
}

/// Finds the parameters for a person that is to be coded.
inline PersonContext make_context(const kinematics::Skeleton &p_skeleton, int p_resolution, const PersonState *p_base,
		const PersonState *p_before, int p_base_age, int p_before_age) {
	constexpr int MAX_AGE = 255;
	const int precision = precision_step(p_resolution);
	const int age = p_base_age < 1 ? 1 : (p_base_age > MAX_AGE ? MAX_AGE : p_base_age);
	const int older = p_before_age > 2 * MAX_AGE ? 2 * MAX_AGE : p_before_age;
	const PersonState *before = p_base != nullptr && older > age ? p_before : nullptr;
	const PersonModel &model = p_base == nullptr
			? WHOLE_MODELS[precision]
			: (before == nullptr ? STILL_MODELS : MOVING_MODELS)[precision][age_step(age)];
	return { model, SHARES_WITHIN, p_skeleton, p_resolution, p_base, before, age, older > age ? older - age : 1 };
}

} // namespace wire

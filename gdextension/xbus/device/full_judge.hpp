// SPDX-License-Identifier: MIT
#pragma once

#include "bus/plausibility.hpp"
#include "device/full_sample.hpp"

namespace xbus {

/// Whether every value that the sample holds is finite and within what a sensor on a person can measure.
bool is_in_range(const FullSample &p_sample);

/// Judges what `SampleJudge` does not look at: the further values of one device's samples.
class FurtherJudge {
public:
	/// False for values that cannot be, unless the device sends such again and again: then it is sick, and its
	/// messages are whole.
	bool accept(const FullSample &p_sample);

private:
	NormJudge _delta_q;
	NonsenseJudge _nonsense;
};

} // namespace xbus

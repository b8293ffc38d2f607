// SPDX-License-Identifier: MIT
#include "tracking_meter.hpp"

#include <algorithm>

namespace ragdoll {

void TrackingMeter::note(double p_time_s, const std::vector<Quat> &p_actual, const std::vector<Vec3> &p_joints) {
	if (waiting.size() >= LONGEST) {
		waiting.pop_front(); // The stream has stalled: there is no truth to compare with.
	}
	waiting.push_back({ p_time_s, p_actual, p_joints });
}

void TrackingMeter::settle(const PoseStream &p_stream, const Rig &p_rig) {
	while (!waiting.empty() && !p_stream.is_empty() && waiting.front().time_s <= p_stream.newest()) {
		if (waiting.front().time_s >= p_stream.oldest()) {
			compare(waiting.front(), p_stream, p_rig);
		}
		waiting.pop_front();
	}
}

void TrackingMeter::compare(const Noted &p_noted, const PoseStream &p_stream, const Rig &p_rig) {
	p_stream.recall(p_noted.time_s, truth);
	if (measures_lag) {
		compare_shifted(p_noted, p_stream);
	}
	p_rig.joint_positions(truth, true_joints);
	double total = 0.0;
	for (std::size_t i = 0; i < p_noted.actual.size(); i++) {
		const double angle = angle_between(p_noted.actual[i], truth.orientations[i]);
		histogram[std::min(std::size_t(angle / BIN), BINS - 1)]++;
		total += angle;
		distance_sum += double((p_noted.joints[i] - true_joints[i]).length());
	}
	last_mean = total / double(p_noted.actual.size());
	sum += total;
	count += p_noted.actual.size();
}

void TrackingMeter::compare_shifted(const Noted &p_noted, const PoseStream &p_stream) {
	for (int shift = 0; shift < SHIFTS; shift++) {
		// A negative delay would need samples that have not come: the pose is compared with what is
		// known, which is right up to the newest sample.
		p_stream.recall(p_noted.time_s - FIRST_SHIFT - shift * SHIFT, shifted);
		for (std::size_t i = 0; i < p_noted.actual.size(); i++) {
			shifted_sums[shift] += angle_between(p_noted.actual[i], shifted.orientations[i]);
		}
	}
}

double TrackingMeter::lag() const {
	const int best = int(std::min_element(shifted_sums.begin(), shifted_sums.end()) - shifted_sums.begin());
	if (!measures_lag || count == 0 || best == 0 || best == SHIFTS - 1) {
		return measures_lag && count > 0 ? FIRST_SHIFT + best * SHIFT : 0.0;
	}
	// The bottom of the parabola through the best delay and its neighbours.
	const double left = shifted_sums[best - 1];
	const double right = shifted_sums[best + 1];
	const double bend = left - 2.0 * shifted_sums[best] + right;
	return FIRST_SHIFT + SHIFT * (best + (bend > 0.0 ? 0.5 * (left - right) / bend : 0.0));
}

double TrackingMeter::percentile(double p_fraction) const {
	std::uint64_t below = 0;
	for (std::size_t i = 0; i < BINS; i++) {
		below += histogram[i];
		if (below > 0 && double(below) >= p_fraction * double(count)) {
			return (double(i) + 0.5) * BIN;
		}
	}
	return 0.0;
}

void TrackingMeter::clear() {
	waiting.clear();
	histogram.fill(0);
	count = 0;
	sum = 0.0;
	last_mean = 0.0;
	distance_sum = 0.0;
	shifted_sums.fill(0.0);
}

} // namespace ragdoll

// SPDX-License-Identifier: MIT
#include "tracking_meter.hpp"

#include <algorithm>

namespace ragdoll {

void TrackingMeter::note(double p_time_s, const std::vector<Quat> &p_actual) {
	if (waiting.size() >= LONGEST) {
		waiting.pop_front(); // The stream has stalled: there is no truth to compare with.
	}
	waiting.push_back({ p_time_s, p_actual });
}

void TrackingMeter::settle(const PoseStream &p_stream) {
	while (!waiting.empty() && !p_stream.is_empty() && waiting.front().time_s <= p_stream.newest()) {
		if (waiting.front().time_s >= p_stream.oldest()) {
			p_stream.predict(waiting.front().time_s, truth);
			compare(waiting.front(), truth);
		}
		waiting.pop_front();
	}
}

void TrackingMeter::compare(const Noted &p_noted, const Pose &p_truth) {
	double total = 0.0;
	for (std::size_t i = 0; i < p_noted.actual.size(); i++) {
		const double angle = angle_between(p_noted.actual[i], p_truth.orientations[i]);
		histogram[std::min(std::size_t(angle / BIN), BINS - 1)]++;
		total += angle;
	}
	last_mean = total / double(p_noted.actual.size());
	sum += total;
	count += p_noted.actual.size();
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
}

} // namespace ragdoll

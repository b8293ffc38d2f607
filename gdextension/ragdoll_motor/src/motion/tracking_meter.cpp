// SPDX-License-Identifier: MIT
#include "motion/tracking_meter.hpp"

#include <algorithm>

namespace ragdoll {

void TrackingMeter::note(double p_time_s, const std::vector<Quat> &p_actual, const std::vector<Vec3> &p_joints) {
	if (_waiting.size() >= LONGEST) {
		_waiting.pop_front(); // The stream has stalled: there is no truth to compare with.
	}
	_waiting.push_back({ p_time_s, p_actual, p_joints });
}

void TrackingMeter::settle(const PoseStream &p_stream, const Rig &p_rig) {
	// With a lead, a pose is that of a moment to come.
	const double lead = measures_lag ? MAX_LEAD : 0.0;
	while (!_waiting.empty() && !p_stream.is_empty() && _waiting.front().time_s + lead <= p_stream.newest()) {
		if (_waiting.front().time_s >= p_stream.oldest()) {
			compare(_waiting.front(), p_stream, p_rig);
		}
		_waiting.pop_front();
	}
}

void TrackingMeter::compare(const Noted &p_noted, const PoseStream &p_stream, const Rig &p_rig) {
	p_stream.recall(p_noted.time_s, _truth);
	if (measures_lag && p_noted.time_s - MAX_LAG >= p_stream.oldest()) {
		compare_shifted(p_noted, p_stream);
	}
	p_rig.joint_positions(_truth, _true_joints);
	double total = 0.0;
	for (std::size_t i = 0; i < p_noted.actual.size(); i++) {
		const double angle = angle_between(p_noted.actual[i], _truth.orientations[i]);
		_histogram.add(angle / BIN);
		total += angle;
		_distance_sum += double((p_noted.joints[i] - _true_joints[i]).length());
	}
	_last_mean = total / double(p_noted.actual.size());
	_sum += total;
}

void TrackingMeter::compare_shifted(const Noted &p_noted, const PoseStream &p_stream) {
	_shifted_count++;
	for (int shift = 0; shift < SHIFTS; shift++) {
		p_stream.recall(p_noted.time_s + MAX_LEAD - shift * SHIFT, _shifted);
		for (std::size_t i = 0; i < p_noted.actual.size(); i++) {
			_shifted_sums[shift] += angle_between(p_noted.actual[i], _shifted.orientations[i]);
		}
	}
}

int TrackingMeter::find_best_shift() const {
	return int(std::min_element(_shifted_sums.begin(), _shifted_sums.end()) - _shifted_sums.begin());
}

bool TrackingMeter::is_lag_known() const {
	const int best = find_best_shift();
	return _shifted_count > 0 && best > 0 && best < SHIFTS - 1;
}

double TrackingMeter::lag() const {
	if (_shifted_count == 0) {
		return 0.0;
	}
	const int best = find_best_shift();
	if (!is_lag_known()) {
		return best * SHIFT - MAX_LEAD;
	}
	// The bottom of the parabola through the best delay and its neighbours.
	const double left = _shifted_sums[best - 1];
	const double right = _shifted_sums[best + 1];
	const double bend = left - 2.0 * _shifted_sums[best] + right;
	return SHIFT * (best + (bend > 0.0 ? 0.5 * (left - right) / bend : 0.0)) - MAX_LEAD;
}

double TrackingMeter::percentile(double p_fraction) const {
	const int bin = _histogram.find(p_fraction);
	return bin < 0 ? 0.0 : (double(bin) + 0.5) * BIN;
}

void TrackingMeter::clear() {
	_waiting.clear();
	_histogram.clear();
	_sum = 0.0;
	_last_mean = 0.0;
	_distance_sum = 0.0;
	_shifted_sums.fill(0.0);
	_shifted_count = 0;
}

} // namespace ragdoll

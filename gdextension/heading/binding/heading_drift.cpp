// SPDX-License-Identifier: MIT
#include "heading_drift.hpp"

#include <convert.hpp>

#include <cmath>

namespace godot {

namespace {

constexpr int64_t MAX_SENSORS = 256;

bool is_mount(int64_t p_mount) {
	return p_mount >= 0 && p_mount < heading::MOUNTS;
}

} // namespace

void HeadingDrift::reset() {
	_estimator.reset();
	_sensors.clear();
}

void HeadingDrift::set_sensor(int64_t p_sensor, int64_t p_mount, double p_heading, const Quaternion &p_mounting) {
	ERR_FAIL_COND_MSG(p_sensor < 0 || p_sensor >= MAX_SENSORS, "A sensor's number is between 0 and 255.");
	ERR_FAIL_COND_MSG(p_mount != -1 && !is_mount(p_mount), "A mount is between 0 and 16, or -1 for none.");
	if (std::size_t(p_sensor) >= _sensors.size()) {
		_sensors.resize(std::size_t(p_sensor) + 1);
	}
	Sensor &sensor = _sensors[std::size_t(p_sensor)];
	sensor.mount = int(p_mount);
	sensor.left = kinematics::exp({ 0.0f, float(-p_heading), 0.0f });
	sensor.right = to_core(p_mounting).inverse();
}

void HeadingDrift::set_joint(int64_t p_mount, const Vector3 &p_from_above, const Vector3 &p_from_own) {
	ERR_FAIL_COND_MSG(!is_mount(p_mount) || p_mount == 0, "A mount that has a joint above it is between 1 and 16.");
	ERR_FAIL_COND_MSG(!p_from_above.is_finite() || !p_from_own.is_finite(), "A joint is at a finite place, m.");
	_estimator.set_levers(int(p_mount), { to_core(p_from_above), to_core(p_from_own) });
}

void HeadingDrift::add(int64_t p_time_usec, const PackedByteArray &p_present, const PackedFloat32Array &p_orientations,
		const PackedVector3Array &p_magnetics, const PackedVector3Array &p_accelerations) {
	ERR_FAIL_COND_MSG(p_orientations.size() != p_present.size() * 4, "Each sensor has an orientation of 4 numbers.");
	heading::DriftEstimator::Sample sample;
	sample.time = double(p_time_usec) * 1e-6;
	const bool is_accelerated = p_accelerations.size() == p_present.size();
	if (!_estimator.wants(sample.time) && !is_accelerated) {
		return;
	}
	const uint8_t *present = p_present.ptr();
	const float *numbers = p_orientations.ptr();
	const Vector3 *accelerations = is_accelerated ? p_accelerations.ptr() : nullptr;
	const Vector3 *fields = p_magnetics.size() == p_present.size() ? p_magnetics.ptr() : nullptr;
	for (std::size_t i = 0; i < _sensors.size() && int64_t(i) < p_present.size(); i++) {
		const Sensor &sensor = _sensors[i];
		if (sensor.mount < 0 || present[i] == 0) {
			continue;
		}
		const kinematics::Quat said{ numbers[i * 4], numbers[i * 4 + 1], numbers[i * 4 + 2], numbers[i * 4 + 3] };
		const kinematics::Quat limb = sensor.left * said * sensor.right;
		if (!limb.is_finite() || limb.dot(limb) < 0.25f) {
			continue;
		}
		sample.present[std::size_t(sensor.mount)] = true;
		sample.rotations[std::size_t(sensor.mount)] = limb.normalized();
		if (fields != nullptr) {
			sample.fields[std::size_t(sensor.mount)] = (sensor.left * said).rotate(to_core(fields[i]));
		}
		if (accelerations != nullptr && accelerations[i].is_finite()) {
			sample.accelerations[std::size_t(sensor.mount)] = (sensor.left * said).rotate(to_core(accelerations[i]));
		}
	}
	_estimator.add(sample);
}

double HeadingDrift::get_correction(int64_t p_mount) const {
	return is_mount(p_mount) ? _estimator.correction(int(p_mount)) : 0.0;
}

double HeadingDrift::get_rate(int64_t p_mount) const {
	return is_mount(p_mount) ? _estimator.state().rate(int(p_mount)) : 0.0;
}

double HeadingDrift::get_trust() const {
	return _estimator.trust();
}

bool HeadingDrift::is_field_known(int64_t p_mount) const {
	return is_mount(p_mount) && _estimator.field(int(p_mount)).is_known();
}

bool HeadingDrift::is_field_good(int64_t p_mount) const {
	return is_mount(p_mount) && _estimator.field(int(p_mount)).is_good();
}

double HeadingDrift::get_field_strength(int64_t p_mount) const {
	return is_mount(p_mount) ? _estimator.field(int(p_mount)).strength() : 1.0;
}

double HeadingDrift::get_field_dip(int64_t p_mount) const {
	return is_mount(p_mount) ? _estimator.field(int(p_mount)).dip() : 0.0;
}

void HeadingDrift::restart(const PackedFloat64Array &p_drifts) {
	ERR_FAIL_COND_MSG(p_drifts.size() != heading::MOUNTS, "There is a drift for each of 17 mounts.");
	std::array<double, heading::MOUNTS> drifts{};
	for (std::size_t i = 0; i < drifts.size(); i++) {
		ERR_FAIL_COND_MSG(!std::isfinite(p_drifts[int64_t(i)]), "A drift is a number, rad.");
		drifts[i] = p_drifts[int64_t(i)];
	}
	_estimator.restart(drifts);
}

void HeadingDrift::_bind_methods() {
	ClassDB::bind_method(D_METHOD("reset"), &HeadingDrift::reset);
	ClassDB::bind_method(D_METHOD("set_sensor", "sensor", "mount", "heading", "mounting"), &HeadingDrift::set_sensor);
	ClassDB::bind_method(D_METHOD("set_joint", "mount", "from_above", "from_own"), &HeadingDrift::set_joint);
	ClassDB::bind_method(
			D_METHOD("add", "time_usec", "present", "orientations", "magnetics", "accelerations"), &HeadingDrift::add);
	ClassDB::bind_method(D_METHOD("get_correction", "mount"), &HeadingDrift::get_correction);
	ClassDB::bind_method(D_METHOD("get_rate", "mount"), &HeadingDrift::get_rate);
	ClassDB::bind_method(D_METHOD("get_trust"), &HeadingDrift::get_trust);
	ClassDB::bind_method(D_METHOD("is_field_known", "mount"), &HeadingDrift::is_field_known);
	ClassDB::bind_method(D_METHOD("is_field_good", "mount"), &HeadingDrift::is_field_good);
	ClassDB::bind_method(D_METHOD("get_field_strength", "mount"), &HeadingDrift::get_field_strength);
	ClassDB::bind_method(D_METHOD("get_field_dip", "mount"), &HeadingDrift::get_field_dip);
	ClassDB::bind_method(D_METHOD("restart", "drifts"), &HeadingDrift::restart);
}

} // namespace godot

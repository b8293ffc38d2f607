// SPDX-License-Identifier: MIT
// RagdollMotor: what it measures and tells.
#include "ragdoll_motor.hpp"

#include <convert.hpp>

#include <algorithm>

namespace godot {

namespace {

constexpr double DEGREES = 180.0 / 3.14159265358979323846;

PackedFloat32Array to_packed(const std::vector<float> &p_values) {
	PackedFloat32Array result;
	result.resize(int64_t(p_values.size()));
	std::copy(p_values.begin(), p_values.end(), result.ptrw());
	return result;
}

} // namespace

void RagdollMotor::measure(double p_time_s) {
	if (is_ready() && read_bodies()) {
		_driver->measure(p_time_s, _state);
		note_body_pose();
	}
}

Dictionary RagdollMotor::get_tracking() const {
	Dictionary tracking;
	const bool known = _driver != nullptr;
	tracking["count"] = known ? int64_t(_driver->get_meter().get_count()) : int64_t(0);
	tracking["mean_deg"] = known ? _driver->get_meter().mean() * DEGREES : 0.0;
	tracking["p95_deg"] = known ? _driver->get_meter().percentile(0.95) * DEGREES : 0.0;
	tracking["p99_deg"] = known ? _driver->get_meter().percentile(0.99) * DEGREES : 0.0;
	tracking["latest_deg"] = known ? _driver->get_meter().latest() * DEGREES : 0.0;
	tracking["distance_m"] = known ? _driver->get_meter().mean_distance() : 0.0;
	tracking["lag_s"] = known ? _driver->get_meter().lag() : 0.0;
	tracking["lag_known"] = known && _driver->get_meter().is_lag_known();
	return tracking;
}

void RagdollMotor::clear_tracking() {
	if (_driver) {
		_driver->get_meter().clear();
	}
}

PackedFloat32Array RagdollMotor::get_limb_errors() {
	return _driver ? to_packed(_driver->find_errors(_state)) : PackedFloat32Array();
}

PackedFloat32Array RagdollMotor::get_limb_torques() const {
	return _driver ? to_packed(_driver->get_torques().get_torques()) : PackedFloat32Array();
}

PackedFloat32Array RagdollMotor::get_limb_saturations() const {
	return _driver ? to_packed(_driver->get_saturations()) : PackedFloat32Array();
}

void RagdollMotor::set_frame(const Transform3D &p_frame) {
	ERR_FAIL_COND_MSG(!_driver, "RagdollMotor: call setup() first.");
	ERR_FAIL_COND_MSG(!p_frame.is_finite(), "RagdollMotor: a frame is finite.");
	_driver->set_frame(to_core(p_frame.basis), to_core(p_frame.origin));
}

Transform3D RagdollMotor::get_frame() const {
	if (!_driver) {
		return Transform3D();
	}
	return Transform3D(Basis(from_core(_driver->get_frame_orientation())), from_core(_driver->get_frame_origin()));
}

Vector3 RagdollMotor::get_root_target() const {
	return _driver ? from_core(_driver->get_root_target()) : Vector3();
}

Vector3 RagdollMotor::get_tether() const {
	return _driver ? from_core(_driver->get_tether()) : Vector3();
}

Dictionary RagdollMotor::get_balance() const {
	Dictionary balance;
	if (_driver != nullptr && _driver->root_mode == ragdoll::RootMode::GROUNDED) {
		const ragdoll::Balance &source = _driver->get_balance();
		balance["phase"] = int64_t(source.get_recovery().get_phase());
		balance["force_n"] = source.get_force().length();
		balance["force_limit_n"] = source.get_force_limit();
		balance["torque_limit_nm"] = source.get_torque();
		balance["offset_m"] = from_core(source.get_offset());
		balance["capture_error_m"] = from_core(source.get_capture_error());
		balance["is_stepping"] = source.is_stepping();
	}
	return balance;
}

bool RagdollMotor::is_flying() const {
	return _driver && _driver->get_travel() && _driver->get_travel()->is_flying();
}

} // namespace godot

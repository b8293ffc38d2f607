// SPDX-License-Identifier: MIT
#include "ragdoll_report.hpp"

#include <convert.hpp>

#include <algorithm>

namespace godot {

namespace {

constexpr double DEGREES = 180.0 / 3.14159265358979323846;

} // namespace

PackedFloat32Array to_packed(const std::vector<float> &p_values) {
	PackedFloat32Array result;
	result.resize(int64_t(p_values.size()));
	std::copy(p_values.begin(), p_values.end(), result.ptrw());
	return result;
}

Dictionary RagdollReport::get_tracking() const {
	static const ragdoll::TrackingMeter nothing;
	const ragdoll::TrackingMeter &meter = _driver ? _driver->get_meter() : nothing;
	Dictionary tracking;
	tracking["count"] = int64_t(meter.get_count());
	tracking["mean_deg"] = meter.mean() * DEGREES;
	tracking["p95_deg"] = meter.percentile(0.95) * DEGREES;
	tracking["p99_deg"] = meter.percentile(0.99) * DEGREES;
	tracking["latest_deg"] = meter.latest() * DEGREES;
	tracking["distance_m"] = meter.mean_distance();
	tracking["lag_s"] = meter.lag();
	tracking["lag_known"] = meter.is_lag_known();
	return tracking;
}

Dictionary RagdollReport::get_balance() const {
	Dictionary balance;
	if (_driver && _driver->root_mode == ragdoll::RootMode::GROUNDED) {
		const ragdoll::Balance &source = _driver->get_balance();
		balance["phase"] = int64_t(source.get_recovery().get_phase());
		balance["force_n"] = source.get_force().length();
		balance["force_limit_n"] = source.get_force_limit();
		balance["torque_nm"] = _driver->get_residual().get_latest().torque.length();
		balance["torque_p95_nm"] = _driver->get_residual().find_torque(0.95);
		balance["torque_limit_nm"] = std::max(source.get_torque(), source.get_recovery().get_most_help());
		balance["offset_m"] = from_core(source.get_offset());
		balance["capture_error_m"] = from_core(source.get_capture_error());
		balance["is_stepping"] = source.is_stepping();
	}
	return balance;
}

PackedFloat32Array RagdollReport::get_limb_torques() const {
	return _driver ? to_packed(_driver->get_torques().get_torques()) : PackedFloat32Array();
}

PackedFloat32Array RagdollReport::get_limb_saturations() const {
	return _driver ? to_packed(_driver->get_saturations()) : PackedFloat32Array();
}

Transform3D RagdollReport::get_frame() const {
	if (!_driver) {
		return Transform3D();
	}
	return Transform3D(Basis(from_core(_driver->get_frame_orientation())), from_core(_driver->get_frame_origin()));
}

Vector3 RagdollReport::get_root_target() const {
	return _driver ? from_core(_driver->get_root_target()) : Vector3();
}

Vector3 RagdollReport::get_tether() const {
	return _driver ? from_core(_driver->get_tether()) : Vector3();
}

bool RagdollReport::is_flying() const {
	return _driver && _driver->get_travel() && _driver->get_travel()->is_flying();
}

} // namespace godot

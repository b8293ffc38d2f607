// SPDX-License-Identifier: MIT
#include "platform_sender.hpp"

#include "triple.hpp"

#include <convert.hpp>

#include <godot_cpp/core/error_macros.hpp>

namespace godot {

String PlatformSender::open(
		const String &p_host, int64_t p_port, Format p_format, double p_rate, const Ref<MotionCueing> &p_cueing) {
	if (p_cueing.is_null()) {
		return "a platform needs a MotionCueing, which knows what it can do";
	}
	if (p_port < 1 || p_port > 65535) {
		return "a UDP port is 1 to 65535";
	}
	cueing::SenderOptions options;
	options.host = p_host.utf8().get_data();
	options.port = int(p_port);
	options.format = cueing::CueFormat(p_format);
	options.outsim_id = int32_t(_outsim_id);
	options.rate_hz = p_rate;
	return String::utf8(_core.open(options, p_cueing->core()).c_str());
}

void PlatformSender::set_outsim_id(int64_t p_id) {
	ERR_FAIL_COND_MSG(p_id < 1 || p_id > 0x7fffffff, "OutSim's id is a number above 0.");
	_outsim_id = p_id;
}

void PlatformSender::push(double p_time, const Transform3D &p_transform, const Vector3 *p_velocity, int64_t p_tick) {
	cueing::SeatState state;
	state.time = p_time;
	state.position = to_triple(p_transform.origin);
	// A seat that is scaled, or not at all right: its axes are made what axes are.
	state.orientation = to_core(p_transform.basis.orthonormalized());
	if (p_velocity != nullptr) {
		state.velocity = to_triple(*p_velocity);
		state.has_velocity = true;
	}
	_core.push(state, uint32_t(p_tick));
}

void PlatformSender::push_state(double p_time, const Transform3D &p_transform, int64_t p_tick) {
	push(p_time, p_transform, nullptr, p_tick);
}

void PlatformSender::push_moving_state(
		double p_time, const Transform3D &p_transform, const Vector3 &p_velocity, int64_t p_tick) {
	push(p_time, p_transform, &p_velocity, p_tick);
}

String PlatformSender::get_error() const {
	return String::utf8(_core.report().error.c_str());
}

Vector3 PlatformSender::get_position() const {
	return from_triple(_core.report().message.cue.position);
}

Vector3 PlatformSender::get_attitude() const {
	return from_triple(_core.report().message.cue.attitude);
}

Vector3 PlatformSender::get_specific_force() const {
	return from_triple(_core.report().message.motion.felt.specific_force);
}

Vector3 PlatformSender::get_rates() const {
	return from_triple(_core.report().message.motion.felt.rates);
}

void PlatformSender::_bind_methods() {
	ClassDB::bind_method(D_METHOD("open", "host", "port", "format", "rate", "cueing"), &PlatformSender::open);
	ClassDB::bind_method(D_METHOD("close"), &PlatformSender::close);
	ClassDB::bind_method(D_METHOD("is_open"), &PlatformSender::is_open);
	ClassDB::bind_method(D_METHOD("set_outsim_id", "id"), &PlatformSender::set_outsim_id);
	ClassDB::bind_method(D_METHOD("get_outsim_id"), &PlatformSender::get_outsim_id);
	ClassDB::bind_method(D_METHOD("push_state", "time", "transform", "tick"), &PlatformSender::push_state);
	ClassDB::bind_method(
			D_METHOD("push_moving_state", "time", "transform", "velocity", "tick"), &PlatformSender::push_moving_state);
	ClassDB::bind_method(D_METHOD("teleport"), &PlatformSender::teleport);
	ClassDB::bind_method(D_METHOD("set_paused", "paused"), &PlatformSender::set_paused);
	ClassDB::bind_method(D_METHOD("get_error"), &PlatformSender::get_error);
	ClassDB::bind_method(D_METHOD("get_latest"), &PlatformSender::get_latest);
	ClassDB::bind_method(D_METHOD("get_position"), &PlatformSender::get_position);
	ClassDB::bind_method(D_METHOD("get_attitude"), &PlatformSender::get_attitude);
	ClassDB::bind_method(D_METHOD("get_specific_force"), &PlatformSender::get_specific_force);
	ClassDB::bind_method(D_METHOD("get_rates"), &PlatformSender::get_rates);
	ClassDB::bind_method(D_METHOD("get_gain"), &PlatformSender::get_gain);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "outsim_id"), "set_outsim_id", "get_outsim_id");
	BIND_ENUM_CONSTANT(FORMAT_OWN);
	BIND_ENUM_CONSTANT(FORMAT_OUTSIM);
	BIND_ENUM_CONSTANT(FORMAT_OUTSIM_WITH_ID);
}

} // namespace godot

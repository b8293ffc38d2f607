// SPDX-License-Identifier: MIT
#pragma once

#include "motion_cueing.hpp"

#include <platform_sender.hpp>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

/// Sends a motion platform its cues over UDP. Documented in doc_classes/PlatformSender.xml.
class PlatformSender : public RefCounted {
	GDCLASS(PlatformSender, RefCounted)

public:
	/// What is sent.
	enum Format {
		FORMAT_OWN,
		FORMAT_OUTSIM,
		FORMAT_OUTSIM_WITH_ID,
	};

	String open(
			const String &p_host, int64_t p_port, Format p_format, double p_rate, const Ref<MotionCueing> &p_cueing);
	void close() { _core.close(); }
	bool is_open() const { return _core.is_open(); }
	void set_outsim_id(int64_t p_id);
	int64_t get_outsim_id() const { return _outsim_id; }
	void push_state(double p_time, const Transform3D &p_transform, int64_t p_tick);
	void push_moving_state(double p_time, const Transform3D &p_transform, const Vector3 &p_velocity, int64_t p_tick);
	void teleport() { _core.teleport(); }
	void set_paused(bool p_paused) { _core.set_paused(p_paused); }
	String get_error() const;
	double get_latest() const { return _core.report().latest_s; }
	Vector3 get_position() const;
	Vector3 get_attitude() const;
	Vector3 get_specific_force() const;
	Vector3 get_rates() const;
	double get_gain() const { return _core.report().message.gain; }

protected:
	static void _bind_methods();

private:
	void push(double p_time, const Transform3D &p_transform, const Vector3 *p_velocity, int64_t p_tick);

	cueing::PlatformSender _core;
	int64_t _outsim_id = 1;
};

} // namespace godot

VARIANT_ENUM_CAST(godot::PlatformSender::Format);

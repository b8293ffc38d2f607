// SPDX-License-Identifier: MIT
#pragma once

#include "snapshot_decoder.hpp"
#include <smoothing/smoother.hpp>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>

namespace godot {

/// Makes smooth motion of what a server sends. Documented in doc_classes/SnapshotSmoother.xml.
class SnapshotSmoother : public RefCounted {
	GDCLASS(SnapshotSmoother, RefCounted)

public:
	enum Method {
		NONE,
		LINEAR,
		EXTRAPOLATE_LERP,
		HERMITE,
		ERROR_OFFSET,
		ADAPTIVE_LOW_DELAY,
	};

	void set_method(Method p_method);
	Method get_method() const { return Method(int(_smoother.get_method())); }
	void set_tick_rate(double p_rate);
	double get_tick_rate() const { return _smoother.get_clock().tick_rate; }

	bool set_skeleton(int64_t p_person, const PackedInt32Array &p_parents, const PackedVector3Array &p_joints_in_parent,
			const PackedVector3Array &p_joints_in_limb);
	bool push_person(int64_t p_person, int64_t p_tick, double p_arrival_s, const Vector3 &p_root,
			const PackedFloat32Array &p_orientations);
	bool push_body(int64_t p_body, int64_t p_tick, double p_arrival_s, const Transform3D &p_transform,
			const Vector3 &p_velocity, const Vector3 &p_spin, bool p_at_rest);

	void take(const Ref<SnapshotDecoder> &p_decoder, double p_arrival_s);

	void evaluate(double p_now_s) { _smoother.evaluate(p_now_s); }
	bool show_tick(double p_tick, double p_now_s) { return _smoother.show_tick(p_tick, p_now_s); }
	double get_shown_tick() const { return _smoother.shown_tick(); }
	double get_motion_tick() const { return _smoother.motion_tick(); }
	double get_delay() const { return _smoother.delay(); }
	double server_time(double p_now_s) const;

	bool has_person(int64_t p_person) const;
	bool has_body(int64_t p_body) const;
	PackedFloat32Array person_transforms(int64_t p_person) const;
	PackedFloat32Array newest_person_transforms(int64_t p_person) const;
	Transform3D body_transform(int64_t p_body) const;
	Transform3D newest_body_transform(int64_t p_body) const;
	bool predict_body(int64_t p_body, const Transform3D &p_transform);
	void forget_prediction(int64_t p_body);
	PackedInt32Array get_moved_bodies() const;

	double field(int64_t p_entity, int64_t p_field) const;

	void forget_entity(int64_t p_entity);
	void clear() { _smoother.clear(); }
	/// What other classes of this module read.
	const wire::Smoother &get_core() const { return _smoother; }

protected:
	static void _bind_methods();

private:
	wire::Smoother _smoother;
	Ref<SnapshotDecoder> _decoder; // It knows the types and the spawns.
};

} // namespace godot

VARIANT_ENUM_CAST(SnapshotSmoother::Method);

// SPDX-License-Identifier: MIT
#pragma once

#include <smoothing/local_feedback.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

namespace godot {

/// Shows wearers their own bodies at once. Documented in doc_classes/LocalFeedback.xml.
class LocalFeedback : public RefCounted {
	GDCLASS(LocalFeedback, RefCounted)

public:
	bool set_skeleton(const PackedInt32Array &p_parents, const PackedVector3Array &p_joints_in_parent,
			const PackedVector3Array &p_joints_in_limb);
	void set_heading(double p_heading) { _feedback.set_heading(float(p_heading)); }
	bool push_local(double p_moment_s, const Vector3 &p_root, const PackedFloat32Array &p_orientations);
	bool push_truth(double p_moment_s, const PackedFloat32Array &p_transforms);
	bool evaluate(double p_now_s, double p_moment_s) { return _feedback.evaluate(p_now_s, p_moment_s); }
	PackedFloat32Array transforms() const;
	double deviation(int64_t p_limb) const;
	double newest_moment() const { return _feedback.newest_moment(); }
	void clear() { _feedback.clear(); }

protected:
	static void _bind_methods();

private:
	wire::LocalFeedback _feedback;
};

} // namespace godot

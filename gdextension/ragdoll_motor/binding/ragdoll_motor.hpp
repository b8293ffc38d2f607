// SPDX-License-Identifier: MIT
#pragma once

#include "../src/tracking_meter.hpp"
#include "../src/velocity_motor.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <memory>
#include <vector>

namespace godot {

/// Makes the bodies of a ragdoll follow live motion. Documented in doc_classes/RagdollMotor.xml.
class RagdollMotor : public Node {
	GDCLASS(RagdollMotor, Node)

public:
	enum RootMode {
		ROOT_HELD,
		ROOT_SOFT,
	};

	void set_gain(double p_gain) { gain = p_gain; }
	double get_gain() const { return gain; }
	void set_root_mode(RootMode p_mode) { root_mode = p_mode; }
	RootMode get_root_mode() const { return root_mode; }

	bool setup(const TypedArray<RID> &p_bodies, const TypedArray<RID> &p_joints, const PackedInt32Array &p_parents,
			const PackedVector3Array &p_anchors, const PackedVector3Array &p_body_offsets);
	bool push_sample(double p_time_s, const PackedFloat32Array &p_orientations, const Vector3 &p_root);
	void clear_motion();
	bool snap_to(double p_time_s);
	bool drive(double p_time_s, double p_delta_s);
	void measure(double p_time_s);
	bool is_stalled(double p_time_s) const;
	Dictionary get_tracking() const;
	void clear_tracking();

protected:
	static void _bind_methods();

private:
	struct Limb {
		RID body;
		RID joint;
		ragdoll::Vec3 offset; // Of the body's origin in the limb's frame.
	};

	bool is_ready() const { return stream && !stream->is_empty(); }
	bool read_bodies();
	Transform3D body_transform(std::size_t p_limb, const ragdoll::Pose &p_pose) const;
	void drive_root(double p_delta_s);

	double gain = 45.0;
	RootMode root_mode = ROOT_SOFT;

	std::vector<Limb> limbs;
	std::vector<ragdoll::Vec3> anchors;
	std::unique_ptr<ragdoll::PoseStream> stream;
	std::unique_ptr<ragdoll::VelocityMotor> motor;
	ragdoll::TrackingMeter meter;

	// Kept between ticks, so that a tick allocates nothing.
	ragdoll::Pose now;
	ragdoll::Pose next;
	std::vector<ragdoll::Quat> actual;
	std::vector<ragdoll::Vec3> velocities;
	std::vector<ragdoll::Vec3> joints;
	ragdoll::Vec3 actual_root;
};

} // namespace godot

VARIANT_ENUM_CAST(RagdollMotor::RootMode);

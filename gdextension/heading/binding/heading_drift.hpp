// SPDX-License-Identifier: MIT
#pragma once

#include <drift_estimator.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_float64_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/quaternion.hpp>

#include <vector>

namespace godot {

/// Finds how far headings of worn sensors have drifted. Documented in doc_classes/HeadingDrift.xml.
class HeadingDrift : public RefCounted {
	GDCLASS(HeadingDrift, RefCounted)

public:
	void reset();
	void set_sensor(int64_t p_sensor, int64_t p_mount, double p_heading, const Quaternion &p_mounting);
	void set_joint(int64_t p_mount, const Vector3 &p_from_above, const Vector3 &p_from_own);
	void add(int64_t p_time_usec, const PackedByteArray &p_present, const PackedFloat32Array &p_orientations,
			const PackedVector3Array &p_magnetics, const PackedVector3Array &p_accelerations);
	double get_correction(int64_t p_mount) const;
	double get_rate(int64_t p_mount) const;
	double get_trust() const;
	bool is_field_known(int64_t p_mount) const;
	bool is_field_good(int64_t p_mount) const;
	double get_field_strength(int64_t p_mount) const;
	double get_field_dip(int64_t p_mount) const;
	void restart(const PackedFloat64Array &p_drifts);

protected:
	static void _bind_methods();

private:
	struct Sensor {
		int mount = -1;
		kinematics::Quat left;
		kinematics::Quat right;
	};

	heading::DriftEstimator _estimator;
	std::vector<Sensor> _sensors;
};

} // namespace godot

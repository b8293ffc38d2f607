// SPDX-License-Identifier: MIT
#pragma once

#include "body/rig.hpp"
#include "joint/joint_drive.hpp"

#include <vector>

namespace ragdoll {

/// The actuations that are compared with VELOCITY_MOTOR: SPRING_TORQUE (thesis 8.2), ANGULAR_MOTOR (thesis 8.3)
/// and POSITION_MOTOR (the engine's own springs).
class ThesisJoints : public JointDrive {
public:
	/// Keeps a reference: the rig must live as long.
	explicit ThesisJoints(const Rig &p_rig) : _rig(&p_rig), _integrals(p_rig.size(), 0.0f) {}

	void command(std::size_t p_limb, const JointState &p_joint, const ControlSettings &p_settings, float p_delta_s,
			LimbCommand &r_command) override;
	bool drives_root(Actuation p_mode) const override { return p_mode == Actuation::ANGULAR_MOTOR; }
	void reset() override;
	void save(ArchiveWriter &p_archive) const override { p_archive.put_all(_integrals); }
	bool restore(ArchiveReader &p_archive) override { return p_archive.get_all(_integrals); }

private:
	void command_torque(std::size_t p_limb, const JointState &p_joint, const ControlSettings &p_settings,
			float p_delta_s, LimbCommand &r_command);
	void command_position(std::size_t p_limb, const JointState &p_joint, const ControlSettings &p_settings,
			float p_delta_s, LimbCommand &r_command) const;

	const Rig *_rig = nullptr;
	std::vector<float> _integrals; // SPRING_TORQUE's leaky integrators, rad s.
};

} // namespace ragdoll

// SPDX-License-Identifier: MIT
#include "control/limb_pushes.hpp"

#include <algorithm>

namespace ragdoll {

LimbPushes::LimbPushes(const Rig &p_rig) :
		_world(p_rig.size()), _feed_forward(p_rig), _joints(p_rig.size()), _joints_next(p_rig.size()) {}

void LimbPushes::advance(const Rig &p_rig, const RigState &p_state, const Pose &p_now, const Pose &p_next,
		float p_delta_s, const std::vector<LimbCommand> &p_commands, std::vector<LimbPush> &r_pushes) {
	_world.advance(p_delta_s);
	if (_world.is_active()) {
		p_rig.joint_positions(p_now, _joints);
		p_rig.joint_positions(p_next, _joints_next);
		_world.compute(p_rig, p_state, p_now, p_next, _joints, _joints_next, p_delta_s, r_pushes);
	} else {
		std::fill(r_pushes.begin(), r_pushes.end(), LimbPush());
	}
	_feed_forward.add(p_rig, p_state, p_now, p_next, p_delta_s, p_commands, r_pushes);
}

void LimbPushes::save(ArchiveWriter &p_archive) const {
	_world.save(p_archive);
	_feed_forward.save(p_archive);
}

bool LimbPushes::restore(ArchiveReader &p_archive) {
	return _world.restore(p_archive) && _feed_forward.restore(p_archive);
}

} // namespace ragdoll

// SPDX-License-Identifier: MIT
#include "root/getting_up.hpp"

#include <algorithm>

namespace ragdoll {

void GettingUp::advance(const RigState &p_state, const Pose &p_now, const Pose &p_next, bool p_is_limp,
		bool p_finds_travel, float p_highest, float p_delta_s) {
	_is_getting_up = (_is_getting_up || _was_limp) && !p_is_limp;
	_was_limp = p_is_limp;
	_since_s = _is_getting_up && p_finds_travel ? _since_s + p_delta_s : 0.0f;
	const float up = _is_getting_up ? find_lift(p_state, p_now, p_next, p_finds_travel, p_highest, p_delta_s) : 0.0f;
	_lift = { 0.0f, up, 0.0f };
}

float GettingUp::find_lift(const RigState &p_state, const Pose &p_now, const Pose &p_next, bool p_finds_travel,
		float p_highest, float p_delta_s) {
	float error = 0.0f;
	for (std::size_t i = 0; i < p_now.orientations.size(); i++) {
		error += angle_between(p_state.orientations[i], p_now.orientations[i]) / float(p_now.orientations.size());
	}
	_upright_s = error > UPRIGHT ? 0.0f : _upright_s + p_delta_s;
	_is_getting_up = _upright_s < UPRIGHT_S;
	const float more = std::clamp(1.0f + (_since_s - STUCK_S) * MORE, 1.0f, MOST);
	const float lift = std::min(error, 0.5f) * LIFT * more;
	const float highest = std::max(p_state.root.y + p_highest - p_next.root.y, 0.0f);
	return p_finds_travel ? std::min(lift, highest) : lift;
}

void GettingUp::save(ArchiveWriter &p_archive) const {
	p_archive.put(_was_limp);
	p_archive.put(_is_getting_up);
	p_archive.put(_upright_s);
	p_archive.put(_since_s);
}

bool GettingUp::restore(ArchiveReader &p_archive) {
	return p_archive.get(_was_limp) && p_archive.get(_is_getting_up) && p_archive.get(_upright_s) &&
			p_archive.get(_since_s);
}

} // namespace ragdoll

// SPDX-License-Identifier: MIT
#include "motion/stream_watch.hpp"

namespace ragdoll {

bool StreamWatch::advance(const PoseStream &p_stream, double p_time_s) {
	_has_resumed = false;
	if (p_stream.is_stalled(p_time_s)) {
		_is_stalled = true;
		return false;
	}
	_has_resumed = _is_stalled && p_time_s - _alive_s > RESUME_AFTER;
	_is_stalled = false;
	const bool has_paused = p_time_s - _alive_s > RESTART_AFTER;
	_alive_s = p_time_s;
	return has_paused;
}

} // namespace ragdoll

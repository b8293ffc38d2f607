// SPDX-License-Identifier: MIT
#pragma once

#include "motion/pose_stream.hpp"

namespace ragdoll {

/// Notices when a motion begins, stalls and comes back.
class StreamWatch {
public:
	/// After a pause of this length (s) the body is put into the new pose: joints would fling it there.
	static constexpr double RESTART_AFTER = 1.0;
	/// Whoever was stalled for longer than this (s) has to be brought back to the motion; what is shorter is the
	/// network's jitter, and the pose has hardly gone back.
	static constexpr double RESUME_AFTER = 0.05;

	/// Begins a step. Returns whether the motion has begun, or has come back after such a pause.
	bool advance(const PoseStream &p_stream, double p_time_s);
	/// Whether there has been any motion yet.
	bool has_begun() const { return _alive_s != NEVER; }
	/// Whether the motion was stalled until the step before, for longer than RESUME_AFTER.
	bool has_resumed() const { return _has_resumed; }
	/// Whether the motion is stalled in this step.
	bool is_stalled() const { return _is_stalled; }
	/// The next motion begins anew.
	void clear() {
		_alive_s = NEVER;
		_is_stalled = true;
	}

	void save(ArchiveWriter &p_archive) const {
		p_archive.put(_alive_s);
		p_archive.put(_is_stalled);
	}
	bool restore(ArchiveReader &p_archive) { return p_archive.get(_alive_s) && p_archive.get(_is_stalled); }

private:
	static constexpr double NEVER = -1e30;

	double _alive_s = NEVER; // When the motion was last not stalled.
	bool _is_stalled = true;
	bool _has_resumed = false;
};

} // namespace ragdoll

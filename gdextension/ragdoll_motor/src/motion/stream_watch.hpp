// SPDX-License-Identifier: MIT
#pragma once

#include "motion/pose_stream.hpp"

namespace ragdoll {

/// Notices when a motion begins, stalls and comes back.
class StreamWatch {
public:
	/// After a pause of this length (s) the body is put into the new pose: joints would fling it there.
	static constexpr double RESTART_AFTER = 1.0;

	/// Begins a step. Returns whether the motion has begun, or has come back after such a pause.
	bool advance(const PoseStream &p_stream, double p_time_s);
	/// Whether there has been any motion yet.
	bool has_begun() const { return _alive_s != NEVER; }
	/// Whether the motion was stalled in the step before, and is no more.
	bool has_resumed() const { return _has_resumed; }
	/// The next motion begins anew.
	void clear() { _alive_s = NEVER; }

	void save(ArchiveWriter &p_archive) const { p_archive.put(_alive_s); }
	bool restore(ArchiveReader &p_archive) { return p_archive.get(_alive_s); }

private:
	static constexpr double NEVER = -1e30;

	double _alive_s = NEVER; // When the motion was last not stalled.
	bool _has_resumed = false;
};

} // namespace ragdoll

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace xbus {

/// Judges over some seconds at a time how many samples are lost, and whether the line damages bytes.
class StreamHealth {
public:
	/// What has just been found.
	enum class Finding : uint8_t {
		NOTHING,
		/// Many samples are lost, and the line damages bytes.
		LINE_DAMAGES,
		/// Many samples are lost on the way.
		SAMPLES_LOST,
		/// As few are lost as should be, after many were.
		WELL_AGAIN,
	};

	/// Begins anew.
	void restart() { _began_usec = 0; }
	/// Takes what had come, was lost and was damaged by a time, µs, since the device was found.
	Finding judge(uint64_t p_now_usec, uint64_t p_received, uint64_t p_lost, uint64_t p_bad_bytes);
	/// Whether it is time to judge.
	bool is_due(uint64_t p_now_usec) const;
	/// Part of the samples that was lost in the last seconds, 0 to 1.
	double lost_share() const { return _lost_share; }

private:
	/// Of the present span: when it began, and what had come and was lost by then.
	uint64_t _began_usec = 0;
	uint64_t _received = 0;
	uint64_t _lost = 0;
	uint64_t _bad_bytes = 0;
	double _lost_share = 0.0;
};

} // namespace xbus

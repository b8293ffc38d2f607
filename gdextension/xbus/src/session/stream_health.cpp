// SPDX-License-Identifier: MIT
#include "session/stream_health.hpp"

namespace xbus {

namespace {

constexpr uint64_t SPAN_USEC = 5000000;
/// Part of the samples from which on it is told that many are lost.
constexpr double MUCH_LOST = 0.01;

} // namespace

bool StreamHealth::is_due(uint64_t p_now_usec) const {
	return _began_usec == 0 || p_now_usec >= _began_usec + SPAN_USEC;
}

StreamHealth::Finding StreamHealth::judge(
		uint64_t p_now_usec, uint64_t p_received, uint64_t p_lost, uint64_t p_bad_bytes) {
	Finding finding = Finding::NOTHING;
	if (_began_usec != 0) {
		const double came = double(p_received - _received);
		const double missed = double(p_lost - _lost);
		const bool lost_much = _lost_share > MUCH_LOST;
		_lost_share = came + missed > 0.0 ? missed / (came + missed) : 0.0;
		if (_lost_share > MUCH_LOST) {
			finding = p_bad_bytes > _bad_bytes ? Finding::LINE_DAMAGES : Finding::SAMPLES_LOST;
		} else if (lost_much) {
			finding = Finding::WELL_AGAIN;
		}
	}
	_began_usec = p_now_usec;
	_received = p_received;
	_lost = p_lost;
	_bad_bytes = p_bad_bytes;
	return finding;
}

} // namespace xbus

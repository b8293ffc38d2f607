// SPDX-License-Identifier: MIT
#include "stream_time.hpp"

namespace godot {

int64_t StreamTime::at(int64_t p_source_usec, int64_t p_counter, int64_t p_arrival_usec) {
	if (p_source_usec >= 0) {
		return _time.at(p_source_usec, p_arrival_usec);
	}
	return p_counter >= 0 ? _time.at_count(p_counter, p_arrival_usec) : _time.at_arrival(p_arrival_usec);
}

void StreamTime::_bind_methods() {
	ClassDB::bind_method(D_METHOD("at", "source_usec", "counter", "arrival_usec"), &StreamTime::at);
}

} // namespace godot

// SPDX-License-Identifier: MIT
#include "runtime_probe.hpp"

#include <chrono>

namespace godot {

bool RuntimeProbe::start(const String &p_library, double p_patience_s) {
	const auto patience = std::chrono::milliseconds(static_cast<int64_t>(p_patience_s * 1000.0));
	return _probe.start(p_library.utf8().get_data(), patience);
}

RuntimeProbe::Answer RuntimeProbe::poll() {
	return static_cast<Answer>(_probe.poll());
}

void RuntimeProbe::_bind_methods() {
	ClassDB::bind_method(D_METHOD("start", "library", "patience_s"), &RuntimeProbe::start);
	ClassDB::bind_method(D_METHOD("poll"), &RuntimeProbe::poll);
	BIND_ENUM_CONSTANT(NONE);
	BIND_ENUM_CONSTANT(PENDING);
	BIND_ENUM_CONSTANT(READY);
	BIND_ENUM_CONSTANT(NO_LIBRARY);
	BIND_ENUM_CONSTANT(NO_SERVICE);
	BIND_ENUM_CONSTANT(NO_HEADSET);
	BIND_ENUM_CONSTANT(STALLED);
}

} // namespace godot

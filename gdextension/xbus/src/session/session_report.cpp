// SPDX-License-Identifier: MIT
#include "session/session_report.hpp"

namespace xbus {

const char *state_text(SessionState p_state) {
	switch (p_state) {
		case SessionState::SEARCHING:
			return "searching";
		case SessionState::CONFIGURING:
			return "being set up";
		case SessionState::MEASURING:
			return "measuring";
		case SessionState::SILENT:
			return "silent";
		case SessionState::UNSUPPORTED:
			return "not supported";
		default:
			return "stopped";
	}
}

} // namespace xbus

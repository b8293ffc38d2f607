// SPDX-License-Identifier: MIT
#include "session/session_log.hpp"

#include <cstdarg>
#include <cstdio>

namespace xbus {

void SessionLog::log(Severity p_severity, const char *p_format, ...) {
	std::array<char, 240> text{};
	va_list arguments;
	va_start(arguments, p_format);
	vsnprintf(text.data(), text.size(), p_format, arguments);
	va_end(arguments);
	if (p_severity == Severity::INFO || text != _problem) {
		_host.say(p_severity, text.data());
	}
	if (p_severity != Severity::INFO) {
		_problem = text;
	}
}

} // namespace xbus

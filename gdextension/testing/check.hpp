// SPDX-License-Identifier: MIT
#pragma once

// A few lines instead of a test library: none can be installed without root on a bare machine.

#include <cmath>
#include <cstdio>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

namespace check {

struct Case {
	const char *file;
	const char *name;
	std::function<void()> run;
};

struct State {
	std::vector<Case> cases;
	int checks = 0;
	int failures = 0;
};

inline State &state() {
	static State instance;
	return instance;
}

struct Registration {
	Registration(const char *p_file, const char *p_name, std::function<void()> p_run) {
		state().cases.push_back({ p_file, p_name, std::move(p_run) });
	}
};

inline void that(bool p_holds, const char *p_text, const char *p_file, int p_line) {
	state().checks++;
	if (!p_holds) {
		state().failures++;
		std::printf("%s:%d: does not hold: %s\n", p_file, p_line, p_text);
	}
}

inline void near(double p_found, double p_expected, double p_tolerance, const char *p_file, int p_line) {
	state().checks++;
	if (!(std::fabs(p_found - p_expected) <= p_tolerance)) {
		state().failures++;
		std::printf("%s:%d: found %.9g, expected %.9g +- %g\n", p_file, p_line, p_found, p_expected, p_tolerance);
	}
}

/// Whether a path is that of a file, named without folder and ending.
inline bool is_of(std::string_view p_path, std::string_view p_file) {
	const std::string_view name = p_path.substr(p_path.rfind('/') + 1);
	return name.substr(0, name.find('.')) == p_file;
}

/// Runs the cases of a file ("test_gait"), or of all; a case that checks nothing is a failure too.
inline int run_all(std::string_view p_file = "") {
	int failed = 0;
	int passed = 0;
	for (const Case &test : state().cases) {
		if (!p_file.empty() && !is_of(test.file, p_file)) {
			continue;
		}
		const int failures = state().failures;
		const int checks = state().checks;
		test.run();
		const bool empty = state().checks == checks;
		const bool bad = empty || state().failures > failures;
		(bad ? failed : passed)++;
		std::printf("%s %s%s\n", bad ? "FAIL" : "ok  ", test.name, empty ? " (checks nothing)" : "");
	}
	std::printf("%d passed, %d failed\n", passed, failed);
	return failed == 0 && passed > 0 ? 0 : 1;
}

} // namespace check

#define TEST(m_name) \
	static void m_name(); \
	static const check::Registration m_name##_registration(__FILE__, #m_name, m_name); \
	static void m_name()
#define CHECK(m_condition) check::that((m_condition), #m_condition, __FILE__, __LINE__)
#define CHECK_NEAR(m_found, m_expected, m_tolerance) \
	check::near((m_found), (m_expected), (m_tolerance), __FILE__, __LINE__)
#define TEST_MAIN() \
	int main() { \
		return check::run_all(); \
	}

// SPDX-License-Identifier: MIT
#include <check.hpp>

/// Runs the tests of a file ("test_gait"), or of all files.
int main(int p_count, char **p_arguments) {
	return check::run_all(p_count > 1 ? p_arguments[1] : "");
}

// SPDX-License-Identifier: MIT
#include <check.hpp>
#include <smoothing/smoother.hpp>
TEST(x) { CHECK(true); }
TEST_MAIN()

// SPDX-License-Identifier: MIT
#pragma once

/// Where tests find their data.
namespace test_data {

/// The folder gdextension of the clone.
extern const char *const SOURCES;

} // namespace test_data

# SPDX-License-Identifier: MIT
# Provides libsodium::libsodium (shared), from DISMOUNT_LIBSODIUM_ROOT or from the system.
include_guard()
include(dismount_shipped)

dismount_import(libsodium sodium.h sodium libsodium-dev)

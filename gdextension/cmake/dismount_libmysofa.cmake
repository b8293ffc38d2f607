# SPDX-License-Identifier: MIT
# Provides libmysofa::libmysofa (shared), from DISMOUNT_LIBMYSOFA_ROOT or from the system.
include_guard()
include(dismount_shipped)

dismount_import(libmysofa mysofa.h mysofa libmysofa-dev)

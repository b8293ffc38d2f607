// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/variant.hpp>

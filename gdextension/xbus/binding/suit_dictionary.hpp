// SPDX-License-Identifier: MIT
#pragma once

#include <session/suit_frame.hpp>

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>

namespace godot {

/// A sample of all trackers of a device as scripts see it (doc_classes/SuitHub.xml). `p_unix_ahead`: Unix time less
/// the frame's, µs.
Dictionary suit_frame_dictionary(const xbus::SuitFrame &p_frame, int64_t p_unix_ahead);

} // namespace godot

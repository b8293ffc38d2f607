// SPDX-License-Identifier: MIT
#pragma once

#include <mvn/datagram.hpp>

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string.hpp>

namespace godot {

/// A sample of MVN's stream as scripts see it. The keys are described in doc_classes/MvnReceiver.xml.
Dictionary mvn_to_dictionary(const mvn::Content &p_content);

/// The reverse. Returns what is wrong, or an empty text.
String mvn_from_dictionary(const Dictionary &p_sample, mvn::Content &r_content);

} // namespace godot

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace godot::internal {

/// A class reference page (doc_classes/*.xml) that the build has put into the extension. A static
/// object of it is enough; the text must live as long as the library.
class Documentation {
public:
	Documentation(const char *p_xml, size_t p_size);
};

} // namespace godot::internal

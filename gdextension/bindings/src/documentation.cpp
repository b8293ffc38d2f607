// SPDX-License-Identifier: MIT
#include "internal.hpp"

#include <godot_cpp/core/documentation.hpp>

#include <string_view>
#include <vector>

namespace godot::internal {

namespace {

std::vector<std::string_view> &pages() {
	static std::vector<std::string_view> list;
	return list;
}

} // namespace

Documentation::Documentation(const char *p_xml, size_t p_size) {
	pages().emplace_back(p_xml, p_size);
}

void load_documentation() {
	// Export templates have no editor, and no such function.
	if (engine.editor_help_load_xml_from_utf8_chars_and_len == nullptr) {
		return;
	}
	for (const std::string_view page : pages()) {
		engine.editor_help_load_xml_from_utf8_chars_and_len(page.data(), static_cast<GDExtensionInt>(page.size()));
	}
}

} // namespace godot::internal

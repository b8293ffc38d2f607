// SPDX-License-Identifier: MIT
#pragma once

// Makes enums usable in bound methods. Use the macros outside of any namespace.

namespace godot {

/// The name of an enum, set by VARIANT_ENUM_CAST.
template <class T>
struct EnumInfo {
	static constexpr bool is_bitfield = false;
	static constexpr const char *name = "";
};

} // namespace godot

#define GODOT_ENUM_INFO(m_enum, m_is_bitfield) \
	namespace godot { \
	template <> \
	struct EnumInfo<m_enum> { \
		static constexpr bool is_bitfield = m_is_bitfield; \
		static constexpr const char *name = #m_enum; \
	}; \
	}

#define VARIANT_ENUM_CAST(m_enum) GODOT_ENUM_INFO(m_enum, false)
#define VARIANT_BITFIELD_CAST(m_enum) GODOT_ENUM_INFO(m_enum, true)

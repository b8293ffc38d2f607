// SPDX-License-Identifier: MIT
#pragma once

// Complaints at the boundary to scripts: they print an error with its place and leave the function.
#include <godot_cpp/variant/variant.hpp>

namespace godot::internal {

void print_error(
		const char *p_condition, const char *p_message, const char *p_function, const char *p_file, int p_line);
inline void print_error(
		const char *p_condition, const String &p_message, const char *p_function, const char *p_file, int p_line) {
	print_error(p_condition, p_message.utf8().get_data(), p_function, p_file, p_line);
}

} // namespace godot::internal

#define GODOT_PRINT_ERROR(m_condition, m_message) \
	::godot::internal::print_error(m_condition, m_message, __func__, __FILE__, __LINE__)

#define ERR_PRINT(m_message) GODOT_PRINT_ERROR("", m_message)

#define ERR_FAIL_COND_V_MSG(m_condition, m_result, m_message) \
	do { \
		if (m_condition) { \
			GODOT_PRINT_ERROR("Condition \"" #m_condition "\" is true.", m_message); \
			return m_result; \
		} \
	} while (0)
#define ERR_FAIL_COND_V(m_condition, m_result) ERR_FAIL_COND_V_MSG(m_condition, m_result, "")
#define ERR_FAIL_COND_MSG(m_condition, m_message) ERR_FAIL_COND_V_MSG(m_condition, , m_message)
#define ERR_FAIL_COND(m_condition) ERR_FAIL_COND_V_MSG(m_condition, , "")

#define ERR_FAIL_NULL_V_MSG(m_pointer, m_result, m_message) \
	do { \
		if ((m_pointer) == nullptr) { \
			GODOT_PRINT_ERROR("Parameter \"" #m_pointer "\" is null.", m_message); \
			return m_result; \
		} \
	} while (0)
#define ERR_FAIL_NULL_V(m_pointer, m_result) ERR_FAIL_NULL_V_MSG(m_pointer, m_result, "")
#define ERR_FAIL_NULL_MSG(m_pointer, m_message) ERR_FAIL_NULL_V_MSG(m_pointer, , m_message)
#define ERR_FAIL_NULL(m_pointer) ERR_FAIL_NULL_V_MSG(m_pointer, , "")

// Not wrapped in a loop of its own: it continues that of its caller.
#define ERR_CONTINUE_MSG(m_condition, m_message) \
	if (m_condition) { \
		GODOT_PRINT_ERROR("Condition \"" #m_condition "\" is true. Continuing.", m_message); \
		continue; \
	} else \
		((void)0)
#define ERR_CONTINUE(m_condition) ERR_CONTINUE_MSG(m_condition, "")
